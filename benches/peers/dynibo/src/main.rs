//! The crate dynibo, asked the same questions: its inertia matrix and its forward dynamics. Arguments: ROBOT.urdf STATES.

use std::error::Error;
use std::ops::Range;

use beside::{Contestant, Part, State, Work, serve, states};
use dynibo::{BaseState, FloatingRobot, Frame, Twist};

/// Of free fall, which dynibo always adds, along the world's z axis; the base falls with everything else.
const GRAVITY: f64 = 9.80665;

struct Dynibo {
    robot: FloatingRobot,
    states: Vec<State>,
    bases: Vec<BaseState>,
    forces: Vec<Vec<f64>>,
    mass: Vec<f64>,
    acceleration: Vec<f64>,
}

impl Dynibo {
    fn one(&mut self, work: Work, group: usize) -> dynibo::Result<()> {
        let (state, base) = (&self.states[group], &self.bases[group]);
        match work {
            Work::Mass => self.robot.mass_matrix(base, &state.q, &mut self.mass),
            _ => {
                let (forces, out) = (&self.forces[group], &mut self.acceleration);
                self.robot.forward_dynamics(base, &state.q, &state.qd, forces, &[], out)
            }
        }
    }
}

impl Contestant for Dynibo {
    fn does(&self, work: Work) -> bool {
        matches!(work, Work::Mass | Work::Forward)
    }

    fn groups(&self) -> usize {
        self.states.len()
    }

    fn lanes(&self) -> usize {
        1
    }

    fn run(&mut self, work: Work, groups: Range<usize>) {
        for group in groups {
            self.one(work, group).unwrap_or_else(|error| panic!("{error}"));
        }
        std::hint::black_box((&self.mass, &self.acceleration));
    }

    fn answer(&self, work: Work, _: usize) -> Vec<Part> {
        if work == Work::Mass {
            return vec![("mass", self.mass.clone())];
        }
        let mut acceleration = self.acceleration.clone();
        acceleration[5] += GRAVITY;
        vec![("classical_acceleration", acceleration)]
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut argument = || arguments.next().ok_or("expected ROBOT.urdf and its states");
    let robot = FloatingRobot::from_urdf(argument()?)?;
    let n = robot.joint_count();
    let states = states(&argument()?, n)?;
    // The base stands in the world's origin, with the world's axes.
    let base = |state: &State| {
        let [a, b, c, x, y, z] = state.mu;
        let velocity = Twist::new([a, b, c].into(), [x, y, z].into());
        BaseState::new(Frame::identity(), velocity, Twist::zeros())
    };
    let bases = states.iter().map(base).collect::<Result<_, _>>()?;
    let forces = states.iter().map(|state| [&state.wrench[..], &state.tau].concat()).collect();
    let size = robot.generalized_count();
    let contestant =
        Dynibo { robot, bases, forces, states, mass: vec![0.0; size * size], acceleration: vec![0.0; size] };
    Ok(serve(vec![("dynibo", Box::new(contestant))])?)
}
