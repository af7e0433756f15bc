frs::frs_model!(mod arm = "arm.urdf", outputs(inertia), lanes = 4, scalar = f32);

fn main() {
    let _ = arm::DOF;
}
