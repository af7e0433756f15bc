//! Timings of the recursive core: `cargo bench`.

mod chain;
mod states;
mod work;

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use frs::Model;

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

fn core(criterion: &mut Criterion) {
    for model in robots() {
        let states = states::states(&model, 128);
        let denormal: Vec<_> = states.iter().map(|state| state.times(DENORMAL)).collect();
        let mut bench = work::Bench::new(&model);
        let mut group = criterion.benchmark_group(model.name());
        let moving = work::ALL.into_iter().filter(|(name, _)| name.starts_with("forward"));
        let timed = work::ALL.map(|(name, work)| (name.to_owned(), work, &states)).into_iter();
        for (name, work, states) in
            timed.chain(moving.map(|(name, work)| (format!("{name}_denormal"), work, &denormal)))
        {
            let mut next = states.iter().cycle();
            group.bench_function(name, |bencher| {
                bencher.iter(|| next.next().map(|state| work(&mut bench, black_box(state))));
            });
        }
    }
}

criterion_group!(benches, core);
criterion_main!(benches);
