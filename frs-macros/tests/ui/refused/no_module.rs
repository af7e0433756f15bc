frs::frs_model!(arm = "arm.urdf");

fn main() {}
