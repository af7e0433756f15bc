//! What one evaluation of a scene's equations performs, written down.

use frs::Model;
use frs::nalgebra::{Matrix3, Vector3};
use frs::spatial::Pose;
use frs_codegen::record::{Operation, Place, Recorded, record};
use frs_sim::integrate::{State, System, Tangent};

/// The operations of one evaluation.
pub struct Recording {
    /// All, with those that prepare it.
    pub tape: Vec<Operation>,
    /// Where the evaluation itself begins.
    pub start: usize,
    /// The rate of the pose, then of the other numbers. What is read: rotation by rows, translation, the other numbers, time.
    pub outputs: Vec<Place>,
}

impl Recording {
    /// Of `system` for the robot over [`Recorded`], with so many numbers in a state beside its pose.
    pub fn of(
        model: &Model,
        numbers: usize,
        system: impl for<'m> FnOnce(&'m Model<Recorded>) -> Box<dyn System<Recorded> + 'm>,
    ) -> Self {
        let ((start, outputs), tape) = record(|| {
            let mut inputs = Inputs::default();
            let model: Model<Recorded> = model.cast();
            let state = inputs.state(numbers);
            let mut rate = Tangent::zero(numbers);
            let mut system = system(&model);
            let time = inputs.next();
            system.rate(time, &state, &mut rate);
            let outputs = rate.twist.to_array().into_iter().chain(rate.flat).map(|number| number.0);
            (time.0 as usize, outputs.collect())
        });
        Self { tape, start, outputs }
    }
}

/// Numbers that are not known before the evaluation.
#[derive(Default)]
pub struct Inputs(u32);

impl Inputs {
    /// The next of them.
    pub fn next(&mut self) -> Recorded {
        self.0 += 1;
        Recorded::input(self.0 - 1)
    }

    /// A state.
    pub fn state(&mut self, numbers: usize) -> State<Recorded> {
        let rows: [[Recorded; 3]; 3] = std::array::from_fn(|_| std::array::from_fn(|_| self.next()));
        let rotation = Matrix3::from_fn(|row, column| rows[row][column]);
        let translation = Vector3::from_fn(|_, _| self.next());
        State { pose: Pose::new(rotation, translation), flat: (0..numbers).map(|_| self.next()).collect() }
    }
}
