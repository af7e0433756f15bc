//! The cases, one a file: a robot built in code, and its connection and curvature in closed form.

use frs_core::model::RobotDescription;
use frs_core::{FloatingBase, Real};

use crate::{Values, generated};

/// A case's formulas as text, and where they come from.
#[derive(Clone, Copy, Debug)]
struct Formula {
    source: &'static str,
    connection: &'static str,
    curvature: &'static str,
}

macro_rules! cases {
    ($($case:ident $module:ident $title:literal,)*) => {
        $(mod $module;)*

        /// A robot whose connection and curvature are known in closed form.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Case {
            $(
                #[doc = concat!(stringify!($case), ": ", $title, ".")]
                $case,
            )*
        }

        impl Case {
            /// All cases.
            pub const ALL: &'static [Self] = &[$(Self::$case,)*];

            /// Its short name, as `P5`.
            pub fn id(self) -> &'static str {
                match self {
                    $(Self::$case => stringify!($case),)*
                }
            }

            /// What the robot is.
            pub fn title(self) -> &'static str {
                match self {
                    $(Self::$case => $title,)*
                }
            }

            /// The robot as `robots/oracles` has it.
            pub fn urdf(self) -> &'static str {
                match self {
                    $(Self::$case => {
                        include_str!(concat!("../../../robots/oracles/", stringify!($module), ".urdf"))
                    })*
                }
            }

            /// The robot built in code.
            pub fn robot(self) -> RobotDescription {
                match self {
                    $(Self::$case => $module::robot(),)*
                }
            }

            /// The robot as generated code, which answers the inertia and the curvature.
            pub fn generated(self) -> Box<dyn FloatingBase> {
                match self {
                    $(Self::$case => Box::new(generated::$module::$case),)*
                }
            }

            /// A_l, 𝓑 and c at shape `q` by the case's formulas, over any scalar.
            ///
            /// # Panics
            /// If `q` has too few entries.
            pub fn values<T: Real>(self, q: &[T]) -> Values<T> {
                match self {
                    $(Self::$case => $module::values(q),)*
                }
            }

            fn formula(self) -> Formula {
                match self {
                    $(Self::$case => $module::FORMULA,)*
                }
            }
        }
    };
}

cases! {
    P1 p1 "a planar body with one balanced rotor, both centres of mass on the rotor's axis",
    P2 p2 "a planar body with one balanced rotor, nothing at the origin",
    P3 p3 "a planar body with two balanced rotors on parallel axes",
    P4 p4 "two planar bodies joined by a hinge off both centres of mass",
    P5 p5 "a planar chain of three links, an end link as base",
    P6 p6 "three equal uniform rods in the plane, the middle one as base",
    P7 p7 "a planar chain of four links, an end link as base",
    P8 p8 "a hopper in flight: a leg that turns about the base's centre of mass and a foot that telescopes",
    P9 p9 "a planar base with two rails at right angles, one slider on each",
    S0 s0 "a rotor and a slider on one line through all centres of mass",
    G1 g1 "a satellite with three rotors on its principal axes",
    G2 g2 "a gyrostat: any base inertia, three rotors anywhere, one on a skew axis",
    D1 d1 "one mass on a gantry of three rails, base with equal principal moments",
    D2 d2 "one mass on a gantry of three rails, any base inertia",
    D3 d3 "two masses, each on its own gantry of three rails",
    D4 d4 "a mass on a tether: yaw, pitch and reel",
    D5 d5 "three rails in three directions, one slider on each",
    C1 c1 "two axisymmetric bodies joined by a z-y-z wrist on their axes",
    C2 c2 "the falling cat: two equal axisymmetric halves joined by a z-y-z wrist",
    M1 m1 "a satellite with a yaw-pitch arm, the base symmetric about the yaw axis",
    M2 m2 "a satellite with a yaw-pitch arm, any mass distribution",
}

pub use c2::no_twist_curvature;

impl Case {
    /// The case called `id`, in small or capital letters.
    pub fn named(id: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|case| case.id().eq_ignore_ascii_case(id))
    }

    /// Where the formulas come from.
    pub fn source(self) -> &'static str {
        self.formula().source
    }

    /// The formula of A_l, for people.
    pub fn connection(self) -> &'static str {
        self.formula().connection
    }

    /// The formula of 𝓑, for people.
    pub fn curvature(self) -> &'static str {
        self.formula().curvature
    }
}
