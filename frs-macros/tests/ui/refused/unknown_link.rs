frs::frs_model!(mod arm = "arm.urdf", outputs(kinematics), links("tool0", "camera"), payload = "hand");

fn main() {
    arm::kinematics_camera(&[0.0; 2], &mut [[0.0; 3]; 4], &mut [[0.0; 6]; 2]);
}
