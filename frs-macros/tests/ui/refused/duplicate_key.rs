frs::frs_model!(mod arm = "arm.urdf", lanes = 1, outputs(inertia, inertia), lanes = 8);

fn main() {
    let _ = arm::DOF;
}
