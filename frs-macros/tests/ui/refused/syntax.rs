frs::frs_model!(mod arm = "arm.urdf", gravity = off lanes = 8, 3, color =, outputs(inertia));

fn main() {
    let _ = arm::DOF;
}
