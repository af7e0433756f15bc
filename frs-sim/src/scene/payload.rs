//! Bodies that the robot holds, takes, and lets go.
//!
//! A body that is taken brings its momentum, one that is let go takes it away: with p and π the momenta of base and shape before,
//! and w that of the body (link frame),
//!
//! ```text
//! p⁺ = p + X_kᵀ w,   π⁺ = π + J_kᵀ w,   Λ_b⁺ μ⁺ = p⁺,   Λ_q⁺ q̇⁺ = π⁺ − A_l⁺ᵀ p⁺
//! ```
//!
//! with the quantities of the robot as it is afterwards. If the body moves as the link does, no velocity jumps.

use frs_core::Model;
use frs_core::model::Inertial;
use frs_core::spatial::{Symmetric3, Twist};

use super::reader::Table;

/// A body on a link.
#[derive(Clone, Debug, PartialEq)]
pub struct Payload {
    /// The link's number.
    pub link: usize,
    /// Its mass distribution, link frame.
    pub inertial: Inertial,
    /// When it is taken, s; none: it is there at the start.
    pub grasp: Option<f64>,
    /// How it moves when it is taken: angular velocity, and velocity of its centre of mass, in axes of the world. None: as the link does.
    pub twist: Option<Twist<f64>>,
    /// When it is let go, s.
    pub release: Option<f64>,
}

impl Payload {
    /// Whether the robot has it from `time` (s) on.
    pub fn is_held(&self, time: f64) -> bool {
        self.grasp.is_none_or(|grasp| grasp <= time) && self.release.is_none_or(|release| time < release)
    }
}

/// The robot with all of `payloads` that it has from `time` (s) on.
pub fn laden<'a>(model: &Model, payloads: impl Iterator<Item = &'a Payload>, time: f64) -> Model {
    payloads.filter(|payload| payload.is_held(time)).fold(model.clone(), |model, payload| {
        let link = &model.links()[payload.link];
        let both = link.inertial.joined(payload.inertial);
        model.with_inertial(&link.name, both).expect("the link is the model's")
    })
}

pub fn read(table: &Table<'_, '_>, model: &Model, duration: f64) -> Option<Payload> {
    table.only(&["link", "mass", "com", "inertia", "grasp", "twist", "release"]);
    let link = table.required("link", "the name of a link").and_then(|item| item.link(model));
    let mass = table.required("mass", "kg").and_then(|item| item.positive());
    let com = table.get("com").map_or(Some([0.0; 3]), |item| item.numbers("x, y, z in m, link frame"));
    let what = "ixx, iyy, izz, ixy, ixz, iyz in kg·m², about its centre of mass, axes of the link";
    let inertia = table.required("inertia", what).and_then(|item| {
        let [xx, yy, zz, xy, xz, yz] = item.numbers(what)?;
        let inertia = Symmetric3 { xx, xy, xz, yy, yz, zz };
        let [a, b, c]: [f64; 3] = inertia.to_matrix().symmetric_eigenvalues().into();
        if a.min(b).min(c) >= 0.0 && a + b + c >= 2.0 * a.max(b).max(c) {
            return Some(inertia);
        }
        item.refuse(format!(
            "principal moments {a}, {b}, {c}; expected those of a body: none negative, none above the sum of the others"
        ))
    });
    let time = |key: &str| match table.get(key) {
        None => Some(None),
        Some(item) => match item.number()? {
            time if time > 0.0 && time < duration => Some(Some(time)),
            time => item.refuse(format!("found {time}; expected a time within the motion's {duration} s")),
        },
    };
    let (grasp, release) = (time("grasp"), time("release"));
    let six = "angular velocity (rad/s), then velocity of its centre of mass (m/s), in world axes";
    let twist = table.get("twist").map_or(Some(None), |item| Some(Some(Twist::from_array(item.numbers(six)?))));
    let (link, grasp, twist, release) = (link?, grasp?, twist?, release?);
    if twist.is_some() && grasp.is_none() {
        table.refuse("it has a twist and is there from the start; expected a time of grasp, or no twist");
    }
    if let (Some(grasp), Some(release)) = (grasp, release)
        && release <= grasp
    {
        table.refuse(format!("it is let go at {release} s and taken at {grasp} s; expected a release after the grasp"));
    }
    Some(Payload {
        link,
        inertial: Inertial { mass: mass?, com: com?.into(), inertia: inertia? },
        grasp,
        twist,
        release,
    })
}
