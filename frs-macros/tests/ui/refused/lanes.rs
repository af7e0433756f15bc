frs::frs_model!(mod arm = "arm.urdf", outputs(inertia), lanes = 4, scalar = f32);
frs::frs_model!(mod wide = "arm.urdf", outputs(inertia), lanes = 16);

fn main() {
    let _ = arm::DOF + wide::DOF;
}
