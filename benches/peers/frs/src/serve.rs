//! The pipe: a line in, a line of JSON out, as serve.hpp says; and `clock`, which tells how fast this core runs.

use std::hint::black_box;
use std::io::{self, BufRead};
use std::time::Instant;

use serde_json::{Map, Value, json};

use crate::contestant::Contestant;
use crate::work::Work;

/// States that are timed together: a disturbance hits some of them, not all.
const TOGETHER: usize = 32;

/// States at which cold calls are timed.
const COLD_STATES: usize = 16;

/// Numbers in twice the second cache of a large processor.
const WALKED: usize = (16 << 20) / 8;

/// Multiplications, each of which waits for the one before it.
const PRODUCTS: u64 = 1_000_000;

/// Cycles of each on every x86-64 and AArch64 core of the last ten years.
const CYCLES: f64 = 3.0;

/// A contestant by its name.
pub type Named<'c> = (&'static str, Box<dyn Contestant + 'c>);

/// Answers until nobody asks.
///
/// # Errors
/// If the pipe breaks, or asks for what is not there.
pub fn serve(mut contestants: Vec<Named<'_>>) -> io::Result<()> {
    let mut walked = vec![0.0; WALKED];
    for line in io::stdin().lock().lines() {
        let line = line?;
        let reply = reply(&mut contestants, &mut walked, &line);
        println!("{}", reply.ok_or_else(|| io::Error::other(format!("unknown request: {line}")))?);
    }
    Ok(())
}

fn reply(contestants: &mut [Named<'_>], walked: &mut [f64], line: &str) -> Option<Value> {
    let mut words = line.split(' ');
    let what = words.next()?;
    match what {
        "list" => return Some(list(contestants)),
        "clock" => return Some(json!(gigahertz())),
        _ => {}
    }
    let (name, work) = (words.next()?, words.next()?);
    let contestant = &mut contestants.iter_mut().find(|(known, _)| *known == name)?.1;
    let work = Work::ALL.into_iter().find(|known| known.name() == work && contestant.does(*known))?;
    let number = words.next().and_then(|word| word.parse::<usize>().ok());
    let lanes = contestant.lanes();
    match what {
        "answer" => {
            let (group, lane) = (number? / lanes, number? % lanes);
            contestant.run(work, group..group + 1);
            Some(contestant.answer(work, lane).into_iter().map(|(name, part)| (name.to_owned(), json!(part))).collect())
        }
        "time" => {
            let (groups, together, passes) = (contestant.groups(), TOGETHER / lanes, number?);
            let least = |first: usize| {
                let mut some = || nanoseconds(|| contestant.run(work, first..groups.min(first + together)));
                some(); // warms the caches
                (0..passes).map(|_| some()).fold(f64::INFINITY, f64::min)
            };
            let sum: f64 = (0..groups).step_by(together).map(least).sum();
            Some(json!(sum / (groups * lanes) as f64))
        }
        "cold" => {
            let groups = contestant.groups().min(COLD_STATES);
            let call = |group: usize| {
                // The other works' instructions, then numbers.
                let others = Work::ALL.into_iter().filter(|other| *other != work && contestant.does(*other));
                let others: Vec<Work> = others.collect();
                others.into_iter().for_each(|other| contestant.run(other, group..group + 1));
                black_box(&mut *walked).iter_mut().step_by(8).for_each(|number| *number += 1.0);
                nanoseconds(|| contestant.run(work, group..group + 1)) / lanes as f64
            };
            Some((0..groups).map(call).collect())
        }
        _ => None,
    }
}

fn list(contestants: &[Named<'_>]) -> Value {
    let works = |contestant: &dyn Contestant| -> Value {
        Work::ALL.into_iter().filter(|work| contestant.does(*work)).map(Work::name).collect()
    };
    Value::Object(contestants.iter().map(|(name, one)| ((*name).to_owned(), works(&**one))).collect::<Map<_, _>>())
}

fn nanoseconds(run: impl FnOnce()) -> f64 {
    let start = Instant::now();
    run();
    start.elapsed().as_secs_f64() * 1e9
}

/// Cycles a nanosecond, by operations that wait for each other.
fn gigahertz() -> f64 {
    let mut number = black_box(3_u64);
    let spent = nanoseconds(|| {
        for _ in 0..PRODUCTS {
            number = number.wrapping_mul(number);
        }
        black_box(number);
    });
    CYCLES * PRODUCTS as f64 / spent
}
