frs::frs_model!(mod arm = "arm.urdf", outputs(inertai, acceleration, b2));

fn main() {
    arm::inertia(&[0.0; 2], &mut [[0.0; 6]; 6], &mut [[0.0; 6]; 2], &mut [[0.0; 2]; 2]);
}
