//! A run's equations as code that is made for what acts.

use frs_core::{Model, Real};

use super::fall::FreeFall;
use super::meter::Meter;
use super::metered::Metered;
use super::{Knowing, knowing, motion};
use crate::integrate::{State, System, Tangent};
use crate::motion::Momentum;
use crate::scene::Scene;

/// What a run integrates, evaluated by something else than the core: with the same bits, but for the signs of zeros.
pub trait Code<T: Real = f64> {
    /// The rate of a state, with those of the works that a run measures.
    fn rate(&mut self, time: T, state: &State<T>, rate: &mut Tangent<T>);
}

/// Makes code for what acts, or declines.
pub type Coder<'c> = &'c dyn Fn(&Acting<'_>) -> Option<Box<dyn Code>>;

/// What acts from one event of a run to the next.
pub struct Acting<'a> {
    pub(super) scene: &'a Scene,
    pub(super) model: &'a Model,
    pub(super) time: f64,
    pub(super) fall: FreeFall,
    pub(super) closed: Vec<([usize; 2], bool)>,
    pub(super) numbers: usize,
}

impl Acting<'_> {
    /// The robot, with the payloads that it has now.
    pub fn model(&self) -> &Model {
        self.model
    }

    /// Numbers of a state beside its pose.
    pub fn numbers(&self) -> usize {
        self.numbers
    }

    /// What is integrated now, over any scalar; `model` is [`model`](Self::model) over it.
    pub fn system<'m, T: Real>(&self, model: &'m Model<T>) -> Box<dyn System<T> + 'm> {
        knowing(self.scene, &self.fall, Over { acting: self, model })
    }
}

struct Over<'a, 'b, 'm, T: Real> {
    acting: &'a Acting<'b>,
    model: &'m Model<T>,
}

impl<'m, T: Real> Knowing<T> for Over<'_, '_, 'm, T> {
    type Out = Box<dyn System<T> + 'm>;

    fn with<M: Momentum<T> + 'static>(self, momentum: M) -> Self::Out {
        let Acting { scene, time, ref closed, .. } = *self.acting;
        let mut effects = scene.effects(self.model);
        effects.enter(time);
        closed.iter().for_each(|(owner, closed)| effects.touch(*owner, *closed));
        let motion = motion(scene, self.model, momentum, Meter::new(scene, effects), time);
        let state = State::origin(motion.dimension());
        Box::new(Metered::new(motion, state))
    }
}
