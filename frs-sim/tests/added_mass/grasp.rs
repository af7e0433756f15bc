//! A target that is caught under water.

use std::ops::ControlFlow;

use frs_core::Workspace;
use frs_core::spatial::Wrench;
use frs_sim::run::{End, Sample, run};
use frs_sim::scene::Scene;
use nalgebra::Vector3;

use super::lagrange::{Moved, gradient};
use super::{ACCUMULATED, SWING, WATER, added, satellite, scene, water};

/// A target brings its momenta, which are then those of robot, target and water: of the base, and of the shape.
#[test]
fn a_target_brings_its_momentum_to_robot_and_water() {
    /// Forces act for a hundredth of a millisecond between the grasp and the sample after it.
    const SOON: f64 = 1e-3;
    let model = satellite();
    let (mass, com, twist) = (8.0, Vector3::new(0.02, -0.03, 0.2), [0.3, -0.2, 0.4, 0.1, 0.2, -0.1]);
    let target = format!(
        "[payload]\nlink = 'link_7'\nmass = {mass}\ncom = [0.02, -0.03, 0.2]\ninertia = [0.1, 0.2, 0.15, 0, 0, 0]\n\
         twist = {twist:?}\ngrasp = 0.005\n[rotors]\ninertia = 0.1\n"
    );
    let course = "[prescribed]\njoint = 'joint_3'\nsinusoid = { amplitude = 0.5, rate = 2 }\n";
    for (swing, current) in
        [(SWING.to_owned(), ""), (format!("{}{course}", SWING.replace("joint_3 = 1, ", "")), "\ncurrent = [0.5, 0, 0]")]
    {
        let flows = WATER.replace("\ninertia", &format!("{current}\ninertia"));
        let text = format!("samples_per_second = 1e5\n{swing}{target}{flows}");
        let scene = Scene { duration: 0.006, ..scene(&model, &text) };
        let added = added(&model, &text);
        let record = run(&scene, &model, |_| ControlFlow::Continue(()));
        assert_eq!((record.end, record.samples.len()), (End::Whole, 601));
        let (before, after) = (&record.samples[500], &record.samples[501]);
        let last = record.samples.last().unwrap();
        assert!((last.kinetic_energy - record.samples[0].kinetic_energy - last.work()).abs() < ACCUMULATED);

        let momenta = |sample: &Sample, time: f64| {
            let laden = scene.laden(&model, time);
            let mut work = Workspace::new(&laden);
            let base_twist = work.shape(&sample.q).moving(&sample.qd).base_twist(sample.mu);
            let here = Moved { base_twist, q: sample.q.clone(), qd: sample.qd.clone() };
            gradient(&laden.cast(), &added, 0.1, &here, false)
        };
        let (had, has) = (momenta(before, 0.0), momenta(after, 0.005));
        let mut work = Workspace::new(&model);
        let shape = work.shape(&before.q);
        let link = model.link("link_7").unwrap();
        let turn = (before.pose.rotation * shape.link_pose(link).rotation).transpose();
        let [omega, v] = [0, 3].map(|i| turn * Vector3::from_column_slice(&twist[i..i + 3]));
        let brought = Wrench::new(Vector3::new(0.1, 0.2, 0.15).component_mul(&omega), v * mass).at(-com);
        let mut of_shape = [0.0; 7];
        let of_base = shape.add_link_wrench(link, brought, &mut of_shape);
        let expected = of_base.to_array().into_iter().chain(of_shape);
        for (i, ((had, has), brought)) in had.iter().zip(&has).zip(expected).enumerate() {
            // What drives a joint on its course gives it an impulse.
            let driven = swing.contains(course) && i == 6 + 2;
            assert!(driven || (has - had - brought).abs() < SOON, "{i}: {had} {has} {brought}");
        }
        assert!(of_base.to_array().iter().all(|brought| brought.abs() > 10.0 * SOON) && before.qd != after.qd);
        let jump = |name: &str| {
            let work = scene.works().iter().position(|work| work.name == name).unwrap();
            after.works[work] - before.works[work]
        };
        assert!(jump("added_mass").abs() > 0.01 && jump("payloads").abs() > 0.01);
        // μ is that of the robot with what it holds.
        let lost = water(&model, &added, before).0 - water(&scene.laden(&model, 0.005), &added, after).0;
        assert!(
            !current.is_empty() || (jump("added_mass") - lost).abs() < ACCUMULATED,
            "{} {lost}",
            jump("added_mass")
        );
    }
}
