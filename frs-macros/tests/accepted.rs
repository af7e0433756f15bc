//! What `frs_model!` accepts: both forms, and every key.

frs::frs_model!("tests/ui/arm.urdf");
frs::frs_model!(
    /// The arm without its freedom.
    pub(crate) mod held = "tests/ui/arm.urdf",
    root = "upper",
    outputs(inertia, forward_dynamics, kinematics),
    links("hull", "camera"),
    momentum = conserved,
    gravity = off,
    lock("elbow" = -1.2),
    payload = "camera",
    lanes = 8,
    scalar = f32,
    lenient = true,
);

frs::frs_model!(mod grouped = "tests/ui/arm.urdf", form = hybrid, outputs(inertia));

use frs::lanes::F32x8;

#[test]
fn both_forms_and_every_key_are_accepted() {
    assert_eq!((arm::COORDINATES, held::COORDINATES), (["shoulder", "elbow"], ["shoulder"]));
    assert_eq!(grouped::DOF, 2);
    let zero = F32x8::splat(0.0);
    let (mut pose, mut jacobian) = ([[zero; 3]; 4], [zero; 6]);
    held::kinematics_camera(&[zero; 10], &[zero], &mut pose, &mut jacobian);
    assert!(pose[0][0].to_array()[7] != 0.0);
}
