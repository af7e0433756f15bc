//! Numbers that are one state or several states side by side.

use super::{F32x8, F32x16, F64x4, F64x8};
use crate::{Lanes, Real};

/// A scalar with a state in each of its lanes.
pub trait Lane: Lanes<Self::Element> + Send + Sync {
    /// The number of one state.
    type Element: Real + Send + Sync;
}

macro_rules! impl_lane {
    ($($number:ty: $element:ty),*) => {
        $(impl Lane for $number {
            type Element = $element;
        })*
    };
}

impl_lane!(f64: f64, f32: f32, F64x4: f64, F64x8: f64, F32x8: f32, F32x16: f32);
