frs::frs_model!(mod arm = "arm.urdf", gravty = off, color = red, outputs(inertia));

fn main() {
    let _ = arm::DOF;
}
