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

fn core(criterion: &mut Criterion) {
    for model in robots() {
        let states = states::states(&model, 128);
        let mut bench = work::Bench::new(&model);
        let mut group = criterion.benchmark_group(model.name());
        for (name, work) in work::ALL {
            let mut next = states.iter().cycle();
            group.bench_function(name, |bencher| {
                bencher.iter(|| next.next().map(|state| work(&mut bench, black_box(state))));
            });
        }
    }
}

criterion_group!(benches, core);
criterion_main!(benches);
