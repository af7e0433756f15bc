frs::frs_model!(mod arm = "arm.urdf", outputs(inertia, d_mu, forward_dynamics, b2), momentum = zero);

fn main() {
    let _ = arm::DOF;
}
