frs::frs_model!(
    mod arm = "arm.urdf",
    root = hull,
    outputs = inertia,
    links("camera" = 3),
    momentum = 0,
    gravity,
    lock(elbow = "down", shoulder = 1e999),
    payload(camera),
    lanes = 3,
    scalar = f16,
    lenient =,
);

fn main() {
    let _ = arm::DOF;
}
