//! scratch
use frs_batch::*;
use frs_core::*;
use ndarray::*;
use std::time::Instant;
fn main() {
    for name in ["lwr_satellite", "humanoid"] {
        let model = Model::from_urdf(&std::fs::read_to_string(format!("robots/{name}.urdf")).unwrap()).unwrap();
        for quantity in [Quantity::Inertia, Quantity::Matrices, Quantity::ForwardDynamics] {
            let recording = Recording::new(&model, quantity).unwrap();
            let mut line = format!("{name} {} slots {} steps {}:", quantity.name(), recording.slots(), recording.steps());
            for i in Instructions::ALL {
                let mut robot = recording.blocks_by(i);
                let states = robot.states();
                let mut seed = fastrand::Rng::with_seed(1);
                let inputs: Vec<Array2<f64>> = quantity.inputs().map(|a| Array2::from_shape_fn((states, a.len(model.dof())), |_| seed.f64() - 0.5)).collect();
                let mut outputs: Vec<Array2<f64>> = quantity.outputs().map(|a| Array2::zeros((states, a.len(model.dof())))).collect();
                let inputs: Vec<_> = inputs.iter().map(|a| a.view()).collect();
                let mut outputs: Vec<_> = outputs.iter_mut().map(|a| a.view_mut()).collect();
                let mut best = f64::INFINITY;
                for _ in 0..600 {
                    let t = Instant::now();
                    robot.answer(quantity, &inputs, &mut outputs);
                    best = best.min(t.elapsed().as_secs_f64());
                }
                line += &format!(" {:.3}", best / states as f64 * 1e6);
            }
            println!("{line}");
        }
    }
}
