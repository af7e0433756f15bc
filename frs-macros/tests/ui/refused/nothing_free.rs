frs::frs_model!(mod arm = "arm.urdf", outputs(inertia), lock(elbow = 1.2, shoulder = 0));

fn main() {
    let _ = arm::DOF;
}
