//! Numbers that states are computed in, one state or several side by side.

use frs_core::Real;
use frs_core::lanes::{F32x8, F32x16, F64x4, F64x8};

/// A number of so many states.
pub trait Number: Real {
    /// How many.
    const LANES: usize;

    /// One number from each state.
    fn gather(lane: impl Fn(usize) -> f64) -> Self;

    /// The number of a state.
    fn lane(self, lane: usize) -> f64;
}

impl Number for f64 {
    const LANES: usize = 1;

    fn gather(lane: impl Fn(usize) -> f64) -> Self {
        lane(0)
    }

    fn lane(self, _: usize) -> f64 {
        self
    }
}

macro_rules! number {
    ($($Lanes:ident),*) => {
        $(impl Number for $Lanes {
            const LANES: usize = $Lanes::LANES;

            fn gather(lane: impl Fn(usize) -> f64) -> Self {
                Self::from_array(std::array::from_fn(|k| lane(k) as _))
            }

            fn lane(self, lane: usize) -> f64 {
                self.to_array()[lane].into()
            }
        })*
    };
}

number!(F64x4, F64x8, F32x8, F32x16);
