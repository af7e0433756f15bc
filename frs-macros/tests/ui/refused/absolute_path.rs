frs::frs_model!("/robots/arm.urdf");

fn main() {
    let _ = (arm::DOF, arm::Arm);
}
