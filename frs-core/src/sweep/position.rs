//! Position sweep: poses, inertias, screws and the connection at a shape. docs/mathematics.md §3.
//!
//! What a body needs of its parent is computed body by body; all else for several bodies side by side.

use nalgebra::{Matrix3, Vector3};

use super::composite::{outside_sums, subtree_sums};
use super::parts::{gather, scatter, splat};
use super::{Data, groups, locked_solve};
use crate::model::{Model, Motion};
use crate::spatial::{
    Inertia, LdlFactor3, Symmetric3, Twist, columns, compose, cross, minus_scaled, plus_scaled, times,
};
use crate::{Lanes, Real};

/// Fills everything in `data` that depends on `q` alone.
pub(super) fn position<T: Real>(model: &Model<T>, q: &[T], data: &mut Data<T>) {
    angles(model, q, data);
    kinematics(model, q, data);
    centres(model, data);
    centroidal_frame(model, data);
    subtree_sums(model.bodies(), &mut data.composite, &mut data.complement);
    data.inertia_before[0] = Inertia::zero();
    outside_sums(model.bodies(), &data.composite, &mut data.complement, &mut data.inertia_before);
    data.locked = data.composite[0].rotational.factor();
    joint_columns(model, data);
}

/// Sines and cosines of all joints, before anything waits for them.
fn angles<T: Real>(model: &Model<T>, q: &[T], data: &mut Data<T>) {
    let bodies = &model.bodies()[1..];
    for first in groups::<T>(0..bodies.len()) {
        let angle = T::Lanes::from_fn(|lane| match bodies.get(first + lane) {
            Some(body) if body.motion == Motion::Revolute => body.value(q),
            _ => T::zero(),
        });
        let (sin, cos) = angle.sin_cos();
        sin.write(&mut data.sin[first..]);
        cos.write(&mut data.cos[first..]);
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
                let (sin, cos) = (data.sin[k - 1], data.cos[k - 1]);
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

/// Each body's centre of mass, into `three_rows`.
fn centres<T: Real>(model: &Model<T>, data: &mut Data<T>) {
    for first in groups::<T>(0..model.joints()) {
        let rotation: Matrix3<T::Lanes> = gather(&data.rotation, first + 1);
        let origin: Vector3<T::Lanes> = gather(&data.origin, first + 1);
        let com: Vector3<T::Lanes> = data.tables.com.lanes(first);
        data.rotation_columns.set_lanes(first, rotation);
        data.origin_columns.set_lanes(first, origin);
        data.three_rows.set_lanes(first, origin + times(&rotation, &com));
    }
}

/// The robot's centre of mass, and every origin and inertia about it. `composite` starts as the bodies' own inertias.
fn centroidal_frame<T: Real>(model: &Model<T>, data: &mut Data<T>) {
    let (base, joints) = (&model.bodies()[0], model.joints());
    data.inverse_mass = T::one() / model.bodies().iter().fold(T::zero(), |sum, body| sum + body.mass);
    data.com = mean_com(model, data, base.com);
    let com: Vector3<T::Lanes> = splat(data.com);
    for first in groups::<T>(0..joints) {
        let from_centre: Vector3<T::Lanes> = data.three_rows.lanes(first);
        data.three_rows.set_lanes(first, from_centre - com);
    }
    // Where masses differ much, the rounding of c is far for the massive ones: it is measured once more, from c.
    let base_com = base.com - data.com;
    let rest = mean_com(model, data, base_com);

    data.origin[0] = data.origin[0] - data.com - rest;
    data.inertia[0] = Inertia::from_com(base.mass, base_com - rest, base.inertia);
    let rest: Vector3<T::Lanes> = splat(rest);
    for first in groups::<T>(0..joints) {
        let (rotation, origin): (Matrix3<T::Lanes>, Vector3<_>) =
            (data.rotation_columns.lanes(first), data.origin_columns.lanes(first));
        let origin = origin - com - rest;
        let from_centre: Vector3<T::Lanes> = data.three_rows.lanes(first);
        let mass = data.tables.mass.lanes(first);
        let spare: Symmetric3<T::Lanes> = data.tables.spare.lanes(first);
        let about_com = spare.rotated(&rotation).plus_multiple(data.tables.aside.lanes(first));
        let inertia = Inertia::from_com(mass, from_centre - rest, about_com);
        data.origin_columns.set_lanes(first, origin);
        scatter(&mut data.origin, first + 1, origin);
        scatter(&mut data.inertia, first + 1, inertia);
    }
    data.composite.copy_from_slice(&data.inertia);
}

/// The mean of `base_com` and the bodies' centres of mass in `three_rows`, each as often as it weighs.
fn mean_com<T: Real>(model: &Model<T>, data: &Data<T>, base_com: Vector3<T>) -> Vector3<T> {
    let (base, bodies) = (&model.bodies()[0], &model.bodies()[1..]);
    let mut sum = base_com * base.mass;
    for first in groups::<T>(0..bodies.len()) {
        let com: Vector3<T::Lanes> = data.three_rows.lanes(first);
        for (lane, body) in (0..T::Lanes::WIDTH).zip(&bodies[first..]) {
            sum = plus_scaled(sum, Vector3::new(com.x.lane(lane), com.y.lane(lane), com.z.lane(lane)), body.mass);
        }
    }
    sum * data.inverse_mass
}

/// s_j, h_j, k_j, A_j, ŝ_j of every joint.
fn joint_columns<T: Real>(model: &Model<T>, data: &mut Data<T>) {
    let (locked, inverse_mass): (LdlFactor3<T::Lanes>, _) = (splat(data.locked), T::Lanes::splat(data.inverse_mass));
    for first in groups::<T>(0..model.joints()) {
        let (rotation, origin): (Matrix3<T::Lanes>, Vector3<_>) =
            (data.rotation_columns.lanes(first), data.origin_columns.lanes(first));
        let axis = rotation.column(2).into_owned();
        data.screw.set_lanes(first, Twist::new(axis, cross(&origin, &axis)));
        for (k, body) in model.bodies().iter().enumerate().skip(first + 1).take(T::Lanes::WIDTH) {
            if body.motion == Motion::Prismatic {
                data.screw.set(k - 1, Twist::new(Vector3::zeros(), data.rotation[k].column(2).into_owned()));
            }
        }
        let screw: Twist<T::Lanes> = data.screw.lanes(first);
        let composite: Inertia<T::Lanes> = gather(&data.composite, first + 1);
        let inside = composite * screw;
        data.composite_columns.set_lanes(first, composite);
        data.inside.set_lanes(first, inside);
        let complement: Inertia<T::Lanes> = gather(&data.complement, first + 1);
        let outside = complement * screw;
        data.complement_columns.set_lanes(first, complement);
        data.outside.set_lanes(first, outside);
        data.connection.set_lanes(first, locked_solve(&locked, inverse_mass, inside));
        data.reaction.set_lanes(first, locked_solve(&locked, inverse_mass, outside));
    }
}
