//! Inertias against what bodies can be made of: mistakes of a robot's description that its equations do not notice.

use std::f64::consts::PI;
use std::fmt;

use frs_core::Model;
use frs_core::model::Inertial;

/// kg/m³ of osmium, the densest metal (CRC Handbook of Chemistry and Physics: 22.59 g/cm³).
const DENSEST: f64 = 22_590.0;

/// kg/m³ of air at sea level.
const AIR: f64 = 1.2;

/// A principal second moment of mass this much smaller than the largest belongs to a body without thickness.
const FLAT: f64 = 1e-12;

/// What is odd about a link.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Name of the link.
    pub link: String,
    /// What is odd.
    pub oddity: Oddity,
}

/// What may be odd about a link.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Oddity {
    /// No body of any known matter is that small for its mass. kg/m³.
    TooDense(f64),
    /// A block of air weighs more. kg/m³.
    TooThin(f64),
    /// A point, a line or a plate: so many of its three sides have no length.
    Flat(usize),
    /// The very inertia of the link named here, which has another mass.
    SameInertiaAs(String),
    /// Its centre of mass is farther from its frame than the frames of the robot are from each other. m, m.
    FarFromMass {
        /// From the frame to the centre of mass, m.
        distance: f64,
        /// The largest way from a joint's frame to the next one's, m.
        robot: f64,
    },
}

impl Oddity {
    /// Whether no body can have it.
    pub fn is_impossible(&self) -> bool {
        matches!(self, Self::TooDense(_))
    }
}

impl fmt::Display for Oddity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooDense(density) => write!(
                f,
                "its mass is packed to {density:.0} kg/m³ at least, more than osmium ({DENSEST} kg/m³): the inertia is too small, \
                 or the mass too large; check their units (kg, kg·m²)"
            ),
            Self::TooThin(density) => write!(
                f,
                "a solid body of this inertia has {density:.2} kg/m³, less than air: the inertia is too large, or the mass too \
                 small; check their units (kg, kg·m²)"
            ),
            Self::Flat(1) => write!(f, "its masses lie in a plane, as of a plate without thickness"),
            Self::Flat(2) => write!(f, "its masses lie on a line, as of a rod without thickness"),
            Self::Flat(_) => write!(f, "its mass is a point: it has no inertia of its own"),
            Self::SameInertiaAs(other) => write!(
                f,
                "it has the inertia of '{other}' to the last digit, but another mass: one of them may be a placeholder"
            ),
            Self::FarFromMass { distance, robot } => write!(
                f,
                "its centre of mass is {distance:.3} m from its frame, and joints are at most {robot:.3} m apart: what is told in \
                 this frame is mostly the distance"
            ),
        }
    }
}

/// What is odd about the links of a robot, in their order.
///
/// A body of density ρ at most has the least second moments of mass if it is an ellipsoid of that density throughout: so the ellipsoid
/// of the same mass and inertia bounds the density of any body from below.
///
/// ```
/// let model = frs::Model::from_urdf(frs::urdf::LWR_SATELLITE)?;
/// assert!(frs::plausibility::findings(&model).iter().all(|finding| !finding.oddity.is_impossible()));
/// # Ok::<(), frs::urdf::UrdfError>(())
/// ```
pub fn findings(model: &Model) -> Vec<Finding> {
    let links = model.links();
    let massive = |inertial: &Inertial| inertial.mass > 0.0;
    let ways = model.bodies()[1..].iter().map(|body| body.placement.translation.norm());
    let robot = ways.fold(0.0, f64::max);
    let mut found = Vec::new();
    for (k, link) in links.iter().enumerate().filter(|(_, link)| massive(&link.inertial)) {
        let mut see = |oddity| found.push(Finding { link: link.name.clone(), oddity });
        let inertial = &link.inertial;
        match matter(inertial) {
            Matter::Flat(sides) => see(Oddity::Flat(sides)),
            Matter::Solid(density) if density > DENSEST => see(Oddity::TooDense(density)),
            Matter::Solid(density) if density < AIR => see(Oddity::TooThin(density)),
            Matter::Solid(_) => {}
        }
        let twin = links[..k].iter().find(|other| {
            massive(&other.inertial)
                && other.inertial.inertia == inertial.inertia
                && other.inertial.mass != inertial.mass
        });
        if let Some(twin) = twin
            && inertial.inertia.to_matrix().amax() > 0.0
        {
            see(Oddity::SameInertiaAs(twin.name.clone()));
        }
        let distance = inertial.com.norm();
        if model.joints() > 0 && distance > FAR * robot {
            see(Oddity::FarFromMass { distance, robot });
        }
    }
    found
}

/// From this many times the robot's longest way between joints on, a centre of mass is far from its frame.
const FAR: f64 = 100.0;

/// What a body may be made of.
enum Matter {
    /// The density of the ellipsoid of this mass and inertia, kg/m³.
    Solid(f64),
    /// So many sides have no length.
    Flat(usize),
}

fn matter(inertial: &Inertial) -> Matter {
    let about = inertial.inertia.to_matrix().symmetric_eigenvalues();
    // The second moments of mass along the principal axes, of an ellipsoid m/5 times the squares of its half axes.
    let along = about.map(|own| 0.5 * about.sum() - own);
    let thick = along.iter().filter(|&&moment| moment > FLAT * along.max()).count();
    if thick < 3 {
        return Matter::Flat(3 - thick);
    }
    let half_axes = along.map(|moment| (5.0 * moment / inertial.mass).sqrt());
    Matter::Solid(inertial.mass / (4.0 / 3.0 * PI * half_axes.product()))
}
