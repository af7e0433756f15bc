//! What is seen beside the robot: bodies that it takes and lets go, and places that its hands are to reach.

use frs::nalgebra::Vector3;
use frs::spatial::{Pose, Twist};
use frs::{Model, Workspace};
use frs_sim::motion::free_flight;
use frs_sim::run::Sample;
use frs_sim::scene::{Force, Payload, Scene};
use serde::Serialize;

use super::cuboid;

/// What is seen beside the robot.
pub struct Scenery {
    pub boxes: Vec<Taken>,
    pub marks: Vec<Mark>,
    /// Where its points are in the world, for each sample that is shown.
    pub points: Vec<Vec<Vector3<f64>>>,
}

/// A body that is held for a while, as a box.
#[derive(Serialize)]
pub struct Taken {
    /// The first of its eight corners.
    first: usize,
    name: String,
    /// When, s; none: from the start, to the end.
    grasp: Option<f64>,
    release: Option<f64>,
}

/// A place that a link is to reach.
#[derive(Serialize)]
pub struct Mark {
    point: usize,
    name: String,
}

impl Scenery {
    /// That of a scene, at the samples with the numbers `shown`; its points are counted from `first` on.
    pub fn new(scene: &Scene, model: &Model, samples: &[Sample], shown: &[usize], first: usize) -> Self {
        let mut points = vec![Vec::new(); shown.len()];
        let (mut boxes, mut marks) = (Vec::new(), Vec::new());
        let mut next = first;
        for payload in scene.payloads() {
            let Some(places) = places(scene, model, payload, samples, shown) else { continue };
            let corners = cuboid::corners(&payload.inertial);
            for (points, place) in points.iter_mut().zip(places) {
                points.extend(corners.map(|corner| place.transform(corner)));
            }
            let (name, grasp, release) = (model.links()[payload.link].name.clone(), payload.grasp, payload.release);
            boxes.push(Taken { first: next, name: format!("payload of {name}"), grasp, release });
            next += corners.len();
        }
        for named in &scene.forces {
            if let Force::EndEffector(target) = &named.force {
                points.iter_mut().for_each(|points| points.push(target.position.into()));
                marks.push(Mark { point: next, name: format!("goal of {}", model.links()[target.link].name) });
                next += 1;
            }
        }
        Self { boxes, marks, points }
    }

    /// How many points there are for each sample, at most.
    pub fn len(scene: &Scene) -> usize {
        let marks = scene.forces.iter().filter(|named| matches!(named.force, Force::EndEffector(_)));
        8 * scene.payloads().count() + marks.count()
    }

    /// What the page tells of the marks that it shows.
    pub fn legend(&self) -> String {
        let boxes = "; <span class=\"load\">■</span> bodies that it takes or lets go, pale while they fly";
        let marks = "; <span class=\"load\">+</span> where hands are to be";
        [(!self.boxes.is_empty(), boxes), (!self.marks.is_empty(), marks)]
            .map(|(is_seen, text)| if is_seen { text } else { "" })
            .concat()
    }
}

/// Where the frame of a payload's link is in the world while it is held, and where it would be while the payload flies by itself. None if the
/// motion ended before it was taken.
fn places(
    scene: &Scene,
    model: &Model,
    payload: &Payload,
    samples: &[Sample],
    shown: &[usize],
) -> Option<Vec<Pose<f64>>> {
    let place = |model: &Model, sample: &Sample| {
        let mut work = Workspace::new(model);
        let mut shape = work.shape(&sample.q);
        let robot = shape.moving(&sample.qd);
        (sample.pose * robot.link_pose(payload.link), robot.link_twist(payload.link, sample.mu))
    };
    let time = |i: &usize| samples[*i].time;
    let before = shown.iter().filter(|i| payload.grasp.is_some_and(|grasp| time(i) < grasp));
    let after = shown.iter().filter(|i| payload.release.is_some_and(|release| time(i) >= release));
    let flown = |event: f64, given: Option<Twist<f64>>, times: Vec<f64>| {
        // Of the sample before it; the hand keeps its velocity in between.
        let sample = samples.iter().rfind(|sample| sample.time <= event)?;
        // μ is that of the robot with what it held until then.
        let (pose, own) = place(&scene.laden(model, event.next_down()), sample);
        let pose = pose * Pose::exp(own * (event - sample.time));
        let twist = given.map_or(own, |given| {
            let turn = pose.rotation.transpose();
            Twist::new(turn * given.angular, turn * given.linear).at(-payload.inertial.com)
        });
        let from_event = times.into_iter().map(|time| time - event);
        free_flight(&payload.inertial, &pose, twist, scene.gravity(), from_event).ok()
    };
    let mut found = Vec::new();
    if let Some(grasp) = payload.grasp {
        if samples.last()?.time < grasp {
            return None;
        }
        // Back in time from the grasp.
        let mut past = flown(grasp, payload.twist, before.map(time).rev().collect())?;
        past.reverse();
        found.extend(past);
    }
    let (end, then) = match payload.release {
        None => (shown.len(), Vec::new()),
        Some(release) => {
            let then = flown(release, None, after.clone().map(time).collect())?;
            (shown.len() - then.len(), then)
        }
    };
    let held: Vec<_> = shown[found.len()..end].iter().map(|i| place(model, &samples[*i]).0).collect();
    found.extend(held.into_iter().chain(then));
    Some(found)
}
