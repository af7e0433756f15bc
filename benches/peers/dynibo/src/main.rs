//! The crate dynibo, asked the same questions: its inertia matrix and its forward dynamics.
//! Arguments: ROBOT.urdf, its states, and the names of their coordinates with commas between.

use std::error::Error;
use std::ops::Range;

use beside::{Contestant, Part, State, Work, serve, states};
use dynibo::{BaseState, FloatingRobot, Frame, Twist};

/// Of free fall, which dynibo always adds, along the world's z axis; the base falls with everything else.
const GRAVITY: f64 = 9.80665;

struct Dynibo {
    robot: FloatingRobot,
    /// Where each of its velocities stands among ours.
    places: Vec<usize>,
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
        let size = self.places.len();
        if work == Work::Mass {
            let mut mass = vec![0.0; size * size];
            for (column, from) in self.places.iter().zip(self.mass.chunks_exact(size)) {
                self.places.iter().zip(from).for_each(|(row, &entry)| mass[column * size + row] = entry);
            }
            return vec![("mass", mass)];
        }
        let mut acceleration = vec![0.0; size];
        self.places.iter().zip(&self.acceleration).for_each(|(&place, &entry)| acceleration[place] = entry);
        acceleration[5] += GRAVITY;
        vec![("classical_acceleration", acceleration)]
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut argument = || arguments.next().ok_or("expected ROBOT.urdf, its states and the names of its coordinates");
    let robot = FloatingRobot::from_urdf(argument()?)?;
    let n = robot.joint_count();
    let mut states = states(&argument()?, n)?;
    let names = argument()?;
    let place = |k| {
        let name = robot.joint_name(k)?;
        names.split(',').position(|known| known == name).ok_or_else(|| format!("unknown joint {name}").into())
    };
    let joints: Vec<usize> = (0..n).map(place).collect::<Result<_, Box<dyn Error>>>()?;
    for state in &mut states {
        for vector in [&mut state.q, &mut state.qd, &mut state.tau] {
            *vector = joints.iter().map(|&place| vector[place]).collect();
        }
    }
    let places = (0..6).chain(joints.iter().map(|place| 6 + place)).collect();
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
        Dynibo { robot, places, bases, forces, states, mass: vec![0.0; size * size], acceleration: vec![0.0; size] };
    Ok(serve(vec![("dynibo", Box::new(contestant))])?)
}
