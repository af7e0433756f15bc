//! What is seen of a robot that has no looks: its joints, the lines between them, and the base as a box.

use frs::model::{Body, Inertial, Motion};
use frs::nalgebra::Vector3;
use frs::spatial::Pose;
use frs::{Model, Workspace};
use frs_sim::run::Sample;
use serde::Serialize;

use super::cuboid;

/// The point in the middle of the base's box, whose corners are the first points: the base's centre of mass.
const BASE: usize = 8;

/// Points of the robot and what joins them. After them, and those of what is beside it, comes the robot's centre of mass.
pub struct Skeleton {
    points: Vec<Fixed>,
    pub joints: Vec<Joint>,
    /// Pairs of points.
    pub segments: Vec<[usize; 2]>,
}

/// A point that stands still in a link.
struct Fixed {
    link: usize,
    at: Vector3<f64>,
}

/// A joint that is seen.
#[derive(Serialize)]
pub struct Joint {
    point: usize,
    name: String,
    slides: bool,
}

impl Skeleton {
    /// The skeleton of a robot: segments from joint to joint, at the ends of chains to what is farthest from the joint.
    pub fn new(model: &Model) -> Self {
        let bodies = model.bodies();
        let to_root = model.links()[0].placement.inverse();
        let Body { mass, com, inertia, .. } = bodies[0];
        let corners = cuboid::corners(&Inertial { mass, com, inertia });
        let mut points: Vec<Fixed> =
            corners.map(|corner| Fixed { link: 0, at: to_root.transform(corner) }).into_iter().collect();
        points.push(Fixed { link: 0, at: to_root.transform(com) });
        let (mut joints, mut segments) = (Vec::new(), Vec::new());
        // The point of each body; a body without a link, inside a planar joint, has its parent's.
        let mut origin = vec![BASE];
        for (k, body) in bodies.iter().enumerate().skip(1) {
            let Some(link) = model.links().iter().position(|link| link.body == k) else {
                origin.push(origin[body.parent]);
                continue;
            };
            let placement = model.links()[link].placement.inverse();
            let point = points.len();
            points.push(Fixed { link, at: placement.translation });
            origin.push(point);
            segments.push([origin[body.parent], point]);
            let own = model.coordinates().iter().find(|coordinate| coordinate.body == k);
            let name = own.map_or(&model.links()[link].name, |coordinate| &coordinate.name).clone();
            joints.push(Joint { point, name, slides: body.motion == Motion::Prismatic });
            if body.end == k + 1 {
                segments.push([point, points.len()]);
                points.push(Fixed { link, at: placement.transform(tip(model, k)) });
            }
        }
        Self { points, joints, segments }
    }

    /// How many points there are.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// The unit, m, and for each sample where the points are in the world, in units: x, y, z of the first, of the second, …; then those `beside` the
    /// robot, then its centre of mass.
    ///
    /// The unit is the power of ten by which the robot's size has five digits.
    pub fn frames<'s>(
        &self,
        model: &Model,
        samples: impl Iterator<Item = &'s Sample>,
        beside: &[Vec<Vector3<f64>>],
    ) -> (f64, Vec<Vec<i64>>) {
        let mut work = Workspace::new(model);
        let samples: Vec<_> = samples.collect();
        let places: Vec<_> = samples.iter().map(|sample| self.places(&mut work, sample)).collect();
        let from_base =
            |points: &Vec<Vector3<f64>>| points.iter().map(|p| (p - points[BASE]).norm()).fold(0.0, f64::max);
        let size = places.first().map_or(0.0, from_base);
        let unit = if size > 0.0 { 10.0_f64.powf(size.log10().floor() - 4.0) } else { 1.0 };
        let whole = |point: &Vector3<f64>| [point.x, point.y, point.z].map(|x| (x / unit).round() as i64);
        let frames = places.iter().zip(beside).zip(&samples);
        let frame = frames
            .map(|((own, beside), sample)| own.iter().chain(beside).chain([&sample.com]).flat_map(whole).collect());
        (unit, frame.collect())
    }

    fn places(&self, work: &mut Workspace, sample: &Sample) -> Vec<Vector3<f64>> {
        let links = work.model().links().len();
        let shape = work.shape(&sample.q);
        let poses: Vec<Pose<f64>> = (0..links).map(|link| sample.pose * shape.link_pose(link)).collect();
        self.points.iter().map(|point| poses[point.link].transform(point.at)).collect()
    }
}

/// Of a body's links and its centre of mass, the one that is farthest from its joint, in the body's frame.
fn tip(model: &Model, body: usize) -> Vector3<f64> {
    let links = model.links().iter().filter(|link| link.body == body).map(|link| link.placement.translation);
    let com = model.bodies()[body].com;
    links.fold(com, |far, point| if point.norm() > far.norm() { point } else { far })
}
