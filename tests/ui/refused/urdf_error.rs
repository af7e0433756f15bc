frs::frs_model!(pub mod arm = "broken.urdf", outputs(inertia), gravity = off);

use arm::{Broken, COORDINATES, DOF};
use frs::{FloatingBase, Quantity};

fn ask(robot: &mut impl FloatingBase) -> bool {
    robot.answers(Quantity::Inertia)
}

fn main() {
    let mut robot: Broken = Broken;
    println!("{} {:?} {:?}", ask(&mut robot), COORDINATES, [0.0; DOF]);
}
