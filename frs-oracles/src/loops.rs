//! Closed paths of the shape, and how they displace a robot at rest.

use std::f64::consts::TAU;

use frs_core::spatial::Pose;
use nalgebra::{Matrix3, Vector3};
use serde::Deserialize;

use crate::Case;

/// A closed path of a case's shape with the displacement it makes at zero momentum; `data/loops.json` says how it was made.
///
/// The shape need not return where a joint turned fully: closed is what the robot looks like.
#[derive(Clone, Debug)]
pub struct Loop {
    /// The case.
    pub case: Case,
    /// What the path does.
    pub name: String,
    /// Where the displacement comes from.
    pub kind: Kind,
    /// The path.
    pub path: Path,
    /// g₀⁻¹g_T, the base's pose after the path in that before it.
    pub displacement: Pose<f64>,
    /// What was left between two ways to the same displacement, or the one way's own estimate.
    pub verified_to: f64,
    /// The displacement as a formula.
    pub note: String,
}

/// Where a loop's displacement comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// A closed form.
    Exact,
    /// A path-ordered product of exponentials in extended arithmetic.
    Reference,
}

/// A path of the shape.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Path {
    /// Straight from point to point.
    Polyline(Vec<Vec<f64>>),
    /// Two coordinates around a centre, from where the first is largest, the second growing first.
    Circle {
        /// The shape at the centre.
        centre: Vec<f64>,
        /// How far the two coordinates go.
        radius: f64,
        /// The two coordinates.
        coordinates: [usize; 2],
    },
    /// The gait of Kane and Scher's falling cat: the second half's direction sweeps a cone about the first's, and no half
    /// twists; `opening` is larger than `tilt`.
    NoTwistCone {
        /// Angle of the cone's axis to the first half's axis, rad.
        tilt: f64,
        /// Half the cone's opening angle, rad.
        opening: f64,
    },
}

#[derive(Deserialize)]
struct Data {
    loops: Vec<Entry>,
}

#[derive(Deserialize)]
struct Entry {
    case: String,
    name: String,
    kind: Kind,
    path: Path,
    rotation: [[f64; 3]; 3],
    translation: [f64; 3],
    verified_to: f64,
    note: String,
}

/// All loops.
pub fn loops() -> Vec<Loop> {
    let data: Data = serde_json::from_str(include_str!("../data/loops.json")).expect("the crate's own data");
    let known = |Entry { case, name, kind, path, rotation, translation, verified_to, note }| Loop {
        case: Case::named(&case).expect("the crate's own case"),
        name,
        kind,
        path,
        // By rows in the data.
        displacement: Pose::new(Matrix3::from(rotation).transpose(), Vector3::from(translation)),
        verified_to,
        note,
    };
    data.loops.into_iter().map(known).collect()
}

impl Path {
    /// How many smooth pieces the path has, one after the other.
    pub fn pieces(&self) -> usize {
        match self {
            Self::Polyline(points) => points.len() - 1,
            Self::Circle { .. } | Self::NoTwistCone { .. } => 1,
        }
    }

    /// The shape q at `t` from 0 to 1 of a piece, and dq/dt.
    ///
    /// # Panics
    /// If there is no such piece.
    pub fn at(&self, piece: usize, t: f64) -> [Vec<f64>; 2] {
        let (sin, cos) = (TAU * t).sin_cos();
        match self {
            Self::Polyline(points) => {
                let side: Vec<_> = points[piece].iter().zip(&points[piece + 1]).map(|(from, to)| to - from).collect();
                [points[piece].iter().zip(&side).map(|(from, way)| from + way * t).collect(), side]
            }
            Self::Circle { centre, radius, coordinates: [first, second] } => {
                let (mut q, mut rate) = (centre.clone(), vec![0.0; centre.len()]);
                (q[*first], rate[*first]) = (centre[*first] + radius * cos, -TAU * radius * sin);
                (q[*second], rate[*second]) = (centre[*second] + radius * sin, TAU * radius * cos);
                [q, rate]
            }
            Self::NoTwistCone { tilt, opening } => {
                let ((sin_tilt, cos_tilt), (sin_opening, cos_opening)) = (tilt.sin_cos(), opening.sin_cos());
                let [x, y, z] = [
                    cos_opening * sin_tilt - sin_opening * cos * cos_tilt,
                    sin_opening * sin,
                    cos_opening * cos_tilt + sin_opening * cos * sin_tilt,
                ];
                let [x_rate, y_rate, z_rate] =
                    [sin * cos_tilt, cos, -(sin * sin_tilt)].map(|rate| TAU * sin_opening * rate);
                let reach = x.hypot(y);
                // From half a turn to minus half a turn: atan2 jumps at the ends alone.
                let azimuth_rate = (x * y_rate - y * x_rate) / (reach * reach);
                let bend_rate = z * (x * x_rate + y * y_rate) / reach - reach * z_rate;
                [[y.atan2(x), reach.atan2(z), -y.atan2(x)].into(), [azimuth_rate, bend_rate, -azimuth_rate].into()]
            }
        }
    }
}
