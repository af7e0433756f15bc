//! The numbers of explicit Runge-Kutta methods.

mod dop853;

use frs_core::Real;

pub use dop853::DOP853;

/// An explicit Runge-Kutta method.
///
/// Slope s is taken at the time `t + node_s h`, in the state reached with the slopes before it weighted by row s. Row
/// [`stages`](Self::stages) holds the weights of the step itself; rows after it are stages of the interpolant.
#[derive(Debug)]
pub struct Tableau {
    /// Its name, as users write it.
    pub name: &'static str,
    /// Order of the error of a whole motion: h to this power.
    pub order: usize,
    /// Slopes of a step.
    pub stages: usize,
    /// Power of h in the estimated error of one step; 0 for a method that estimates none.
    pub error_order: usize,
    pub(super) nodes: &'static [Coefficient],
    pub(super) rows: &'static [&'static [Coefficient]],
    /// Weights of the estimated errors, the slope at the end of the step included.
    pub(super) errors: &'static [&'static [Coefficient]],
    /// For each slope the coefficients of θ, θ², … in its weight at `t + θh`; empty without an interpolant.
    pub(super) dense: &'static [&'static [Coefficient]],
}

/// A number of a method: `numerator/denominator + low`.
#[derive(Clone, Copy, Debug)]
pub struct Coefficient {
    numerator: f64,
    denominator: f64,
    low: f64,
}

const ZERO: Coefficient = exact(0.0);

const fn exact(value: f64) -> Coefficient {
    Coefficient { numerator: value, denominator: 1.0, low: 0.0 }
}

const fn ratio(numerator: f64, denominator: f64) -> Coefficient {
    Coefficient { numerator, denominator, low: 0.0 }
}

/// A decimal as the sum of two doubles.
const fn pair(high: f64, low: f64) -> Coefficient {
    Coefficient { numerator: high, denominator: 1.0, low }
}

impl Coefficient {
    /// The number, to the digits of `T`.
    pub(super) fn value<T: Real>(self) -> T {
        T::from_f64(self.numerator) / T::from_f64(self.denominator) + T::from_f64(self.low)
    }
}

/// Euler's method, order 1.
pub static EULER: Tableau = Tableau {
    name: "euler",
    order: 1,
    stages: 1,
    error_order: 0,
    nodes: &[ZERO],
    rows: &[&[], &[exact(1.0)]],
    errors: &[],
    dense: &[],
};

/// The midpoint method, order 2.
pub static MIDPOINT: Tableau = Tableau {
    name: "rkmk2",
    order: 2,
    stages: 2,
    error_order: 0,
    nodes: &[ZERO, exact(0.5)],
    rows: &[&[], &[exact(0.5)], &[ZERO, exact(1.0)]],
    errors: &[],
    dense: &[],
};

/// The classical method of order 4.
pub static RK4: Tableau = Tableau {
    name: "rkmk4",
    order: 4,
    stages: 4,
    error_order: 0,
    nodes: &[ZERO, exact(0.5), exact(0.5), exact(1.0)],
    rows: &[
        &[],
        &[exact(0.5)],
        &[ZERO, exact(0.5)],
        &[ZERO, ZERO, exact(1.0)],
        &[ratio(1.0, 6.0), ratio(1.0, 3.0), ratio(1.0, 3.0), ratio(1.0, 6.0)],
    ],
    errors: &[],
    dense: &[],
};

/// The pair of order 5(4) of Dormand and Prince, with Shampine's interpolant of order 4.
///
/// Dormand, Prince, J. Comput. Appl. Math. 6 (1980); Shampine, Math. Comp. 46 (1986).
pub static DOPRI5: Tableau = Tableau {
    name: "dopri5",
    order: 5,
    stages: 6,
    error_order: 5,
    nodes: &[ZERO, ratio(1.0, 5.0), ratio(3.0, 10.0), ratio(4.0, 5.0), ratio(8.0, 9.0), exact(1.0), exact(1.0)],
    rows: &[
        &[],
        &[ratio(1.0, 5.0)],
        &[ratio(3.0, 40.0), ratio(9.0, 40.0)],
        &[ratio(44.0, 45.0), ratio(-56.0, 15.0), ratio(32.0, 9.0)],
        &[ratio(19372.0, 6561.0), ratio(-25360.0, 2187.0), ratio(64448.0, 6561.0), ratio(-212.0, 729.0)],
        &[
            ratio(9017.0, 3168.0),
            ratio(-355.0, 33.0),
            ratio(46732.0, 5247.0),
            ratio(49.0, 176.0),
            ratio(-5103.0, 18656.0),
        ],
        &[
            ratio(35.0, 384.0),
            ZERO,
            ratio(500.0, 1113.0),
            ratio(125.0, 192.0),
            ratio(-2187.0, 6784.0),
            ratio(11.0, 84.0),
        ],
    ],
    errors: &[&[
        ratio(71.0, 57600.0),
        ZERO,
        ratio(-71.0, 16695.0),
        ratio(71.0, 1920.0),
        ratio(-17253.0, 339200.0),
        ratio(22.0, 525.0),
        ratio(-1.0, 40.0),
    ]],
    dense: &[
        &[
            exact(1.0),
            ratio(-8048581381.0, 2820520608.0),
            ratio(8663915743.0, 2820520608.0),
            ratio(-12715105075.0, 11282082432.0),
        ],
        &[],
        &[
            ZERO,
            ratio(131558114200.0, 32700410799.0),
            ratio(-68118460800.0, 10900136933.0),
            ratio(87487479700.0, 32700410799.0),
        ],
        &[
            ZERO,
            ratio(-1754552775.0, 470086768.0),
            ratio(14199869525.0, 1410260304.0),
            ratio(-10690763975.0, 1880347072.0),
        ],
        &[
            ZERO,
            ratio(127303824393.0, 49829197408.0),
            ratio(-318862633887.0, 49829197408.0),
            ratio(701980252875.0, 199316789632.0),
        ],
        &[ZERO, ratio(-282668133.0, 205662961.0), ratio(2019193451.0, 616988883.0), ratio(-1453857185.0, 822651844.0)],
        &[ZERO, ratio(40617522.0, 29380423.0), ratio(-110615467.0, 29380423.0), ratio(69997945.0, 29380423.0)],
    ],
};
