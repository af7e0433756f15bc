//! scratch
use frs_batch::*;
use frs_core::lanes::*;
use frs_core::*;
use ndarray::*;
use std::time::Instant;
fn main() {
    for name in ["lwr_satellite", "humanoid"] {
        let model = Model::from_urdf(&std::fs::read_to_string(format!("robots/{name}.urdf")).unwrap()).unwrap();
        let eight = model.cast::<F64x8>();
        for quantity in [Quantity::Inertia, Quantity::Matrices, Quantity::ForwardDynamics] {
            let t = Instant::now();
            let recording = Recording::new(&model, quantity).unwrap();
            println!("{name} {} steps {} slots {} in {:?}", quantity.name(), recording.steps(), recording.slots(), t.elapsed());
            let states = 1024;
            let mut seed = fastrand::Rng::with_seed(1);
            let inputs: Vec<Array2<f64>> = quantity.inputs().map(|a| Array2::from_shape_fn((states, a.len(model.dof())), |_| seed.f64() - 0.5)).collect();
            let mut outputs: Vec<Array2<f64>> = quantity.outputs().map(|a| Array2::zeros((states, a.len(model.dof())))).collect();
            let inputs: Vec<_> = inputs.iter().map(|a| a.view()).collect();
            let mut time = |what: &str, f: &mut dyn FnMut(Vec<ArrayViewMut2<f64>>)| {
                let mut best = f64::INFINITY;
                for _ in 0..60 {
                    let t = Instant::now();
                    f(outputs.iter_mut().map(|a| a.view_mut()).collect());
                    best = best.min(t.elapsed().as_secs_f64());
                }
                println!("  {what:20} {:.3} us", best / states as f64 * 1e6);
            };
            let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
            pool.install(|| {
                for i in Instructions::ALL {
                    time(i.name(), &mut |o| answer(|| recording.blocks_by(i), quantity, &inputs, o).unwrap());
                }
                time("one", &mut |o| answer(|| Side::new(Evaluator::new(&model)), quantity, &inputs, o).unwrap());
                time("eight", &mut |o| answer(|| Side::new(Evaluator::new(&eight)), quantity, &inputs, o).unwrap());
            });
        }
    }
}
