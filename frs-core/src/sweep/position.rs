//! Position sweep: poses, inertias, screws and the connection at a shape. docs/mathematics.md §3.

use nalgebra::{Matrix3, Vector3};

use super::Data;
use super::composite::{outside_sums, subtree_sums};
use crate::Real;
use crate::model::{Body, Model, Motion};
use crate::spatial::{Inertia, Twist, columns, compose, cross, minus_scaled, plus_scaled, times};

/// Fills everything in `data` that depends on `q` alone.
pub(super) fn position<T: Real>(model: &Model<T>, q: &[T], data: &mut Data<T>) {
    angles(model, q, data);
    kinematics(model, q, data);
    centroidal_frame(model, data);
    subtree_sums(model.bodies(), &mut data.composite, &mut data.complement);
    data.inertia_before[0] = Inertia::zero();
    outside_sums(model.bodies(), &data.composite, &mut data.complement, &mut data.inertia_before);
    data.locked = data.composite[0].rotational.factor();
    joint_columns(model, data);
}

/// Sines and cosines of all joints, before anything waits for them.
fn angles<T: Real>(model: &Model<T>, q: &[T], data: &mut Data<T>) {
    const GROUP: usize = 4;
    let angle = |body: &Body<T>| match body.motion {
        Motion::Revolute => body.value(q),
        Motion::Prismatic => T::zero(),
    };
    let (bodies, pairs) = (&model.bodies()[1..], &mut data.sin_cos);
    if !T::SIDE_BY_SIDE {
        let each = pairs.iter_mut().zip(bodies).filter(|(_, body)| body.motion == Motion::Revolute);
        return each.for_each(|(pair, body)| *pair = angle(body).sin_cos());
    }
    for (pairs, bodies) in pairs.chunks_mut(GROUP).zip(bodies.chunks(GROUP)) {
        let group: [T; GROUP] = std::array::from_fn(|k| bodies.get(k).map_or_else(T::zero, angle));
        pairs.iter_mut().zip(T::sin_cos_each(group)).for_each(|(pair, both)| *pair = both);
    }
}

/// R_k, p_k from the base outwards; origins are still taken from the base body's origin.
fn kinematics<T: Real>(model: &Model<T>, q: &[T], data: &mut Data<T>) {
    data.rotation[0] = Matrix3::identity();
    data.origin[0] = Vector3::zeros();
    for (k, body) in model.bodies().iter().enumerate().skip(1) {
        let parent = data.rotation[body.parent];
        let rotation = compose(&parent, &body.placement.rotation);
        let origin = data.origin[body.parent] + times(&parent, &body.placement.translation);
        match body.motion {
            Motion::Revolute => {
                let (sin, cos) = data.sin_cos[k - 1];
                let [x, y, z] = columns(&rotation);
                data.rotation[k] =
                    Matrix3::from_columns(&[plus_scaled(x * cos, y, sin), minus_scaled(y * cos, x, sin), z]);
                data.origin[k] = origin;
            }
            Motion::Prismatic => {
                data.rotation[k] = rotation;
                data.origin[k] = plus_scaled(origin, rotation.column(2).into_owned(), body.value(q));
            }
        }
    }
}

/// The centre of mass, and every origin and inertia about it. `composite` starts as the bodies' own inertias.
fn centroidal_frame<T: Real>(model: &Model<T>, data: &mut Data<T>) {
    let (mut mass, mut moment) = (T::zero(), Vector3::zeros());
    for (k, body) in model.bodies().iter().enumerate() {
        let com = data.origin[k] + times(&data.rotation[k], &body.com);
        mass += body.mass;
        moment = plus_scaled(moment, com, body.mass);
        data.inertia[k].moment = com;
    }
    data.inverse_mass = T::one() / mass;
    data.com = moment * data.inverse_mass;
    // Where masses differ much, the rounding of c is far for the massive ones: it is measured once more, from c.
    let mut moment = Vector3::zeros();
    for (k, body) in model.bodies().iter().enumerate() {
        data.origin[k] -= data.com;
        data.inertia[k].moment -= data.com;
        moment = plus_scaled(moment, data.inertia[k].moment, body.mass);
    }
    let rest = moment * data.inverse_mass;
    for (k, body) in model.bodies().iter().enumerate() {
        data.origin[k] -= rest;
        let com = data.inertia[k].moment - rest;
        let about_com = body.inertia.rotated_beside(&data.rotation[k], body.least_moment);
        data.inertia[k] = Inertia::from_com(body.mass, com, about_com);
        data.composite[k] = data.inertia[k];
    }
}

/// s_j, h_j, k_j, A_j, ŝ_j of every joint.
fn joint_columns<T: Real>(model: &Model<T>, data: &mut Data<T>) {
    for (k, body) in model.bodies().iter().enumerate().skip(1) {
        let axis = data.rotation[k].column(2).into_owned();
        let screw = match body.motion {
            Motion::Revolute => Twist::new(axis, cross(&data.origin[k], &axis)),
            Motion::Prismatic => Twist::new(Vector3::zeros(), axis),
        };
        let (j, inside, outside) = (k - 1, data.composite[k] * screw, data.complement[k] * screw);
        let connection = data.locked_solve(inside);
        data.screw[j] = screw;
        data.inside[j] = inside;
        data.outside[j] = outside;
        data.connection[j] = connection;
        data.reaction[j] = data.locked_solve(outside);
        data.inside_rows.set(j, inside.to_array());
        data.connection_rows.set(j, connection.to_array());
    }
}
