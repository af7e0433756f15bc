//! Robots of the project, and shapes of them.

use frs_core::Model;

macro_rules! robots {
    ($($name:ident),*) => {
        $(pub fn $name() -> Model {
            Model::from_urdf(include_str!(concat!("../../../robots/", stringify!($name), ".urdf"))).unwrap()
        })*
        pub fn all() -> Vec<Model> {
            vec![$($name()),*]
        }
    };
}
robots!(lwr_satellite, planar_three_link, quadruped, dual_arm_satellite);

/// A shape without symmetry.
pub fn middle(model: &Model) -> Vec<f64> {
    (0..model.dof()).map(|i| 0.7 * ((3 * i + 1) as f64).sin()).collect()
}
