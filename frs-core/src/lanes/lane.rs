//! Numbers that are one state or several states side by side.

use super::{F32x8, F32x16, F64x4, F64x8};
use crate::Real;

/// A scalar with [`LANES`](Self::LANES) states in it.
pub trait Lane: Real + Send + Sync {
    /// The number of one state.
    type Element: Copy + Send + Sync;

    /// How many states there are.
    const LANES: usize;

    /// The numbers `of` states 0, 1, …
    fn gather(of: impl FnMut(usize) -> Self::Element) -> Self;

    /// The number of state `lane`.
    ///
    /// # Panics
    /// If there is no such state.
    fn get(&self, lane: usize) -> Self::Element;

    /// Gives state `lane` another number.
    ///
    /// # Panics
    /// If there is no such state.
    fn set(&mut self, lane: usize, number: Self::Element);
}

macro_rules! impl_plain {
    ($number:ty) => {
        impl Lane for $number {
            type Element = Self;
            const LANES: usize = 1;

            #[inline(always)]
            fn gather(mut of: impl FnMut(usize) -> Self) -> Self {
                of(0)
            }

            #[inline(always)]
            fn get(&self, lane: usize) -> Self {
                [*self][lane]
            }

            #[inline(always)]
            fn set(&mut self, lane: usize, number: Self) {
                std::slice::from_mut(self)[lane] = number;
            }
        }
    };
}

macro_rules! impl_lanes {
    ($Lanes:ident, $element:ty) => {
        impl Lane for $Lanes {
            type Element = $element;
            const LANES: usize = $Lanes::LANES;

            #[inline(always)]
            fn gather(of: impl FnMut(usize) -> $element) -> Self {
                Self::from_array(std::array::from_fn(of))
            }

            #[inline(always)]
            fn get(&self, lane: usize) -> $element {
                self.to_array()[lane]
            }

            #[inline(always)]
            fn set(&mut self, lane: usize, number: $element) {
                let mut lanes = self.to_array();
                lanes[lane] = number;
                *self = Self::from_array(lanes);
            }
        }
    };
}

impl_plain!(f64);
impl_plain!(f32);
impl_lanes!(F64x4, f64);
impl_lanes!(F64x8, f64);
impl_lanes!(F32x8, f32);
impl_lanes!(F32x16, f32);
