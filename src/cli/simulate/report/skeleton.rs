//! What is seen of a robot that has no looks: its joints, the lines between them, and the base as a box.

use frs::model::{Body, Motion};
use frs::nalgebra::{SymmetricEigen, Vector3};
use frs::spatial::Pose;
use frs::{Model, Workspace};
use frs_sim::run::Sample;
use serde::Serialize;

/// Corners of the base's box are the first points; bits 0, 1, 2 of a corner's number tell its side along each axis.
const CORNERS: usize = 8;

/// The point in the middle of the box: the base's centre of mass.
const BASE: usize = CORNERS;

/// Points of the robot and what joins them. After them comes one more point, the robot's centre of mass.
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
        let half = half_edges(&bodies[0]);
        let mut points: Vec<Fixed> = (0..CORNERS)
            .map(|corner| {
                let sides = (0..3).map(|axis| half[axis] * if corner >> axis & 1 == 0 { -1.0 } else { 1.0 });
                Fixed { link: 0, at: to_root.transform(bodies[0].com + sides.sum::<Vector3<f64>>()) }
            })
            .collect();
        points.push(Fixed { link: 0, at: to_root.transform(bodies[0].com) });
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

    /// Numbers of a frame.
    pub fn numbers(&self) -> usize {
        3 * (self.points.len() + 1)
    }

    /// The unit, m, and for each sample where the points are in the world, in units: x, y, z of the first, of the second, ….
    ///
    /// The unit is the power of ten by which the robot's size has five digits.
    pub fn frames<'s>(&self, model: &Model, samples: impl Iterator<Item = &'s Sample>) -> (f64, Vec<Vec<i64>>) {
        let mut work = Workspace::new(model);
        let places: Vec<_> = samples.map(|sample| self.places(&mut work, sample)).collect();
        let from_base =
            |points: &Vec<Vector3<f64>>| points.iter().map(|p| (p - points[BASE]).norm()).fold(0.0, f64::max);
        let size = places.first().map_or(0.0, from_base);
        let unit = if size > 0.0 { 10.0_f64.powf(size.log10().floor() - 4.0) } else { 1.0 };
        let whole = |points: &Vec<Vector3<f64>>| points.iter().flatten().map(|x| (x / unit).round() as i64).collect();
        (unit, places.iter().map(whole).collect())
    }

    fn places(&self, work: &mut Workspace, sample: &Sample) -> Vec<Vector3<f64>> {
        let links = work.model().links().len();
        let shape = work.shape(&sample.q);
        let poses: Vec<Pose<f64>> = (0..links).map(|link| sample.pose * shape.link_pose(link)).collect();
        let points = self.points.iter().map(|point| poses[point.link].transform(point.at));
        points.chain([sample.com]).collect()
    }
}

/// Half the edges of the box that has the body's mass and inertia: `a² = 6 (I_b + I_c − I_a) / m` for its edges a, b, c.
fn half_edges(body: &Body) -> [Vector3<f64>; 3] {
    let axes = SymmetricEigen::new(body.inertia.to_matrix());
    [0, 1, 2].map(|i| {
        let square = 6.0 * (axes.eigenvalues.sum() - 2.0 * axes.eigenvalues[i]) / body.mass;
        axes.eigenvectors.column(i) * (0.5 * square.max(0.0).sqrt())
    })
}

/// Of a body's links and its centre of mass, the one that is farthest from its joint, in the body's frame.
fn tip(model: &Model, body: usize) -> Vector3<f64> {
    let links = model.links().iter().filter(|link| link.body == body).map(|link| link.placement.translation);
    let com = model.bodies()[body].com;
    links.fold(com, |far, point| if point.norm() > far.norm() { point } else { far })
}
