frs::frs_model!(mod arm = "arm.urdf", root = "hul", outputs(inertia));

fn main() {
    let _ = arm::DOF;
}
