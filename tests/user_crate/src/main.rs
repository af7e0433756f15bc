//! Generated code against the recursion over the same file: exit code 1 if one bit differs.

use std::process::ExitCode;

use robots::{Evaluator, FloatingBase, Model, Quantity};

robots::frs_model!(mod arm = "arm.urdf", outputs(inertia, forward_dynamics));

fn main() -> ExitCode {
    let (q, qd, tau) = ([0.3, -1.1], [0.5, 0.2], [1.0, -2.0]);
    let (mu, gravity, wrench) = ([0.1, 0.0, -0.2, 0.3, 0.4, 0.0], [0.0, 0.0, -9.81], [0.0, 1.0, 0.0, 2.0, 0.0, 0.5]);

    let (mut locked, mut connection, mut shape, mut xi_dot) = ([[0.0; 6]; 6], [[0.0; 6]; 2], [[0.0; 2]; 2], [0.0; 8]);
    arm::inertia(&q, &mut locked, &mut connection, &mut shape);
    arm::forward_dynamics(&q, &qd, &mu, &gravity, &wrench, &tau, &mut xi_dot);
    let called = [locked.as_flattened(), connection.as_flattened(), shape.as_flattened(), &xi_dot].concat();

    let model = Model::from_urdf(include_str!("../arm.urdf")).expect("the macro has read it");
    let mut recursive = Evaluator::new(&model);
    let robots: [&mut dyn FloatingBase; 2] = [&mut arm::Inspector, &mut recursive];
    let same = robots.map(|robot| {
        let (mut locked, mut connection, mut shape, mut xi_dot) = ([0.0; 36], [0.0; 12], [0.0; 4], [0.0; 8]);
        robot.answer(Quantity::Inertia, &[&q], &mut [&mut locked, &mut connection, &mut shape]);
        robot.answer(Quantity::ForwardDynamics, &[&q, &qd, &mu, &gravity, &wrench, &tau], &mut [&mut xi_dot]);
        let answered = [&locked[..], &connection, &shape, &xi_dot].concat();
        answered.iter().map(|x| x.to_bits()).eq(called.iter().map(|x| x.to_bits()))
    });

    println!("{} coordinates, {} kg, bit for bit: {same:?}", arm::DOF, locked[3][3]);
    if same == [true; 2] { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
