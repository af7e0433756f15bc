//! Times the core on given robots and prints samples as JSON lines, for the side-by-side table of `benches/peers/run`.
//!
//! `peer_times [--samples N] ROBOT.urdf …`: each sample is the mean over 128 random states.

#[path = "../core/states.rs"]
mod states;
#[path = "../core/work.rs"]
mod work;

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use frs::Model;

fn main() -> Result<(), Box<dyn Error>> {
    let (mut samples, mut robots) = (50, Vec::new());
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        if argument == "--samples" {
            samples = arguments.next().ok_or("--samples needs a number")?.parse()?;
        } else {
            robots.push(argument);
        }
    }
    for path in robots {
        let text = std::fs::read_to_string(&path).map_err(|error| format!("{path}: {error}"))?;
        time(&path, &Model::from_urdf(&text)?, samples);
    }
    Ok(())
}

fn time(robot: &str, model: &Model, samples: usize) {
    let states = states::states(model, 128);
    let mut bench = work::Bench::new(model);
    for (name, work) in work::ALL {
        // The first pass warms the caches and is not counted.
        let times: Vec<f64> = (0..=samples)
            .map(|_| {
                let start = Instant::now();
                for state in &states {
                    black_box(work(&mut bench, black_box(state)));
                }
                start.elapsed().as_secs_f64() * 1e9 / states.len() as f64
            })
            .skip(1)
            .collect();
        let line = serde_json::json!({ "robot": robot, "n": model.dof(), "work": name, "ns": times });
        println!("{line}");
    }
}
