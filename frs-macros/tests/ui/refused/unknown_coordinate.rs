frs::frs_model!(mod arm = "arm.urdf", outputs(inertia), lock(elbow = 1.2, "wrist 1" = -0.5));

fn main() {
    let _ = [""; 1] == arm::COORDINATES;
}
