frs::frs_model!();

fn main() {}
