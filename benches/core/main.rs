//! Timings of the recursive core: `cargo bench`.

mod chain;
mod states;
mod work;

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use frs::Model;
use states::State;

fn robots() -> Vec<Model> {
    let urdfs = [
        include_str!("../../robots/lwr_satellite.urdf"),
        include_str!("../../robots/quadruped.urdf"),
        include_str!("../../robots/humanoid.urdf"),
    ];
    let own = urdfs.map(|urdf| Model::from_urdf(urdf).unwrap_or_else(|error| panic!("{error}")));
    own.into_iter().chain([10, 50, 100, 200].map(chain::chain)).collect()
}

/// Of velocities and forces below 10⁻³⁰⁸, of which doubles keep fewer digits.
const DENORMAL: f64 = 1e-313;

/// The same shape, hardly moving and hardly pushed.
fn denormal(state: &State) -> State {
    let scaled = |vector: &[f64]| vector.iter().map(|x| DENORMAL * x).collect();
    let (qd, tau) = (scaled(&state.qd), scaled(&state.tau));
    State { q: state.q.clone(), qd, mu: state.mu * DENORMAL, wrench: state.wrench * DENORMAL, tau }
}

fn core(criterion: &mut Criterion) {
    for model in robots() {
        let states = states::states(&model, 128);
        let slow: Vec<_> = states.iter().map(denormal).collect();
        let mut bench = work::Bench::new(&model);
        let mut group = criterion.benchmark_group(model.name());
        let moving = work::ALL.into_iter().filter(|(name, _)| name.starts_with("forward"));
        let timed = work::ALL.map(|(name, work)| (name.to_owned(), work, &states)).into_iter();
        for (name, work, states) in timed.chain(moving.map(|(name, work)| (format!("{name}_denormal"), work, &slow))) {
            let mut next = states.iter().cycle();
            group.bench_function(name, |bencher| {
                bencher.iter(|| next.next().map(|state| work(&mut bench, black_box(state))));
            });
        }
    }
}

criterion_group!(benches, core);
criterion_main!(benches);
