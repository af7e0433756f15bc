//! What accuracy costs: one scene computed in many ways, each judged by a motion with 31 digits.

mod errors;
mod front;
mod track;
mod variant;

pub use errors::{Errors, Observed};
pub use front::{dominated, front};
pub use track::{Equate, Number, Track, fly};
pub use variant::{Curve, Evaluation, Scalar, Variant, curves};

use std::time::Instant;

use frs_core::Model;
use frs_core::extended::DoubleDouble;
use frs_core::spatial::Pose;

use crate::integrate::{IntegrationError, Method, Steps};
use crate::run::equations;
use crate::scene::{Force, Scene, Solver};

/// The motion of a scene, as exactly as it is needed to judge others.
///
/// ```
/// use frs_core::Model;
/// use frs_sim::{integrate::Steps, scene::{Scene, Solver}, study::{Scalar, Truth, Variant}};
///
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
/// let text = "robot = 'lwr_satellite.urdf'\nduration = 0.2\n[start]\nqd = { joint_2 = 0.5 }";
/// let scene = Scene::parse("example.toml", text, &model)?;
/// let truth = Truth::of(&scene, &model)?;
/// let solver = Solver { steps: Steps::Accuracy(1e-6), ..Solver::default() };
/// let judged = truth.judge(&Variant { solver, ..Variant::default() })?;
/// assert!(judged.errors.of_state() < 1e-5 && judged.evaluations < 200);
/// assert!(truth.error().of_state() < 1e-14); // the yardstick's own
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Truth<'s> {
    scene: &'s Scene,
    double: &'s Model,
    single: Model<f32>,
    precise: Model<DoubleDouble>,
    times: Vec<f64>,
    observed: Vec<Observed>,
    error: Errors,
}

/// What a variant costs and gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// How far it is off.
    pub errors: Errors,
    /// How often the equations were evaluated.
    pub evaluations: usize,
    /// How long that took on this machine, s.
    pub seconds: f64,
}

/// Parts of a motion at whose ends it is judged.
const PARTS: u32 = 10;

/// The motion is computed with these accuracies, and the difference of both is what the better one is trusted to.
const ACCURACIES: [f64; 2] = [1e-15, 1e-17];

impl<'s> Truth<'s> {
    /// Computes the motion twice with 31 digits.
    ///
    /// # Errors
    /// If the motion cannot be computed.
    pub fn of(scene: &'s Scene, model: &'s Model) -> Result<Self, IntegrationError> {
        let times = (1..=PARTS).map(|part| scene.duration * f64::from(part) / f64::from(PARTS)).collect();
        let mut truth = Self {
            scene,
            double: model,
            single: model.cast::<f32>().orthonormalised(),
            precise: model.cast::<DoubleDouble>().orthonormalised(),
            times,
            observed: Vec::new(),
            error: Errors::default(),
        };
        for accuracy in ACCURACIES {
            let solver = Solver { method: Method::Dop853, steps: Steps::Accuracy(accuracy), ..Solver::default() };
            let scene = Scene { solver, ..scene.clone() };
            let track = fly(&scene, &truth.times, true, &mut |time| equations(&scene, &truth.precise, time))?;
            let observed = truth.observe(&scene, &track);
            truth.error = Errors::between(&observed, &truth.observed);
            truth.observed = observed;
        }
        Ok(truth)
    }

    /// How far the motion is off at most, by its difference to one that is a hundred times less accurate.
    pub fn error(&self) -> Errors {
        self.error
    }

    /// The motion by another way.
    ///
    /// # Errors
    /// If the motion cannot be computed this way.
    pub fn judge(&self, variant: &Variant) -> Result<Judged, IntegrationError> {
        let scene = Scene { solver: variant.solver, ..self.scene.clone() };
        match variant.scalar {
            Scalar::Single => self.judged(&scene, &mut |time| equations(&scene, &self.single, time)),
            Scalar::Double => self.judged(&scene, &mut |time| equations(&scene, self.double, time)),
            Scalar::DoubleDouble => self.judged(&scene, &mut |time| equations(&scene, &self.precise, time)),
        }
    }

    /// The motion in doubles with equations that are evaluated otherwise.
    ///
    /// # Errors
    /// If the motion cannot be computed this way.
    pub fn judge_with(&self, solver: Solver, equate: Equate<'_, '_, f64>) -> Result<Judged, IntegrationError> {
        self.judged(&Scene { solver, ..self.scene.clone() }, equate)
    }

    /// When motions are judged, s.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// How far a motion from elsewhere is off in pose and shape, at [`times`](Self::times); one that was not seen at all of them is
    /// infinitely far off. Its momentum and energy are not known: NaN.
    pub fn judge_places(&self, places: &[(Pose<f64>, Vec<f64>)]) -> Errors {
        let dof = self.double.dof();
        if places.len() != self.times.len() || places.iter().any(|(_, q)| q.len() != dof) {
            return Errors { pose: f64::INFINITY, shape: f64::INFINITY, momentum: f64::NAN, energy: f64::NAN };
        }
        let widen = |(pose, q): &(Pose<f64>, Vec<f64>)| {
            let pose = Pose::new(pose.rotation.map(DoubleDouble::from), pose.translation.map(DoubleDouble::from));
            (pose, q.iter().copied().map(DoubleDouble::from).collect::<Vec<_>>())
        };
        let wide: Vec<_> = places.iter().map(widen).collect();
        Errors::of_places(wide.iter().map(|(pose, q)| (pose, q.as_slice())), &self.observed)
    }

    fn judged<T: track::Number>(&self, scene: &Scene, equate: Equate<'_, '_, T>) -> Result<Judged, IntegrationError> {
        let start = Instant::now();
        let track = fly(scene, &self.times, false, equate)?;
        let seconds = start.elapsed().as_secs_f64();
        let errors = Errors::between(&self.observe(scene, &track), &self.observed);
        Ok(Judged { errors, evaluations: track.evaluations, seconds })
    }

    /// What is compared, computed with 31 digits from a track's own states.
    fn observe<T: track::Number>(&self, scene: &Scene, track: &Track<T>) -> Vec<Observed> {
        let each = self.times.iter().zip(&track.states);
        each.map(|(&time, state)| {
            let mut equations = equations(scene, &self.precise, time);
            Observed::of(&mut *equations, DoubleDouble::from(time), &track::widened(state))
        })
        .collect()
    }
}

/// Why a scene is not studied, if it is not: its forces change where it is touched, or its robot where it takes something.
pub fn reason_against(scene: &Scene) -> Option<&'static str> {
    scene.forces.iter().find_map(|named| match named.force {
        Force::Contact(_) | Force::Stops { .. } => {
            Some("it has contact or stops, whose instants are part of the motion")
        }
        Force::Payload(_) => Some("it has a payload, which changes the robot on the way"),
        _ => None,
    })
}
