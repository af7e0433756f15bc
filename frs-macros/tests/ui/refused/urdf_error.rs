frs::frs_model!(pub mod arm = "broken.urdf", outputs(inertia), gravity = off);

use arm::{Broken, COORDINATES, DOF};
use frs::{FloatingBase, Quantity};

fn ask(robot: &mut impl FloatingBase) -> bool {
    robot.answers(Quantity::Inertia)
}

fn main() {
    let mut robot: Broken = Broken;
    let (mut locked, mut connection, mut shape) = ([[0.0; 6]; 6], [[0.0; 6]; DOF], [[0.0; DOF]; DOF]);
    arm::inertia(&[0.0; DOF], &mut locked, &mut connection, &mut shape);
    println!("{} {:?} {:?}", ask(&mut robot), COORDINATES, [0.0; DOF]);
}
