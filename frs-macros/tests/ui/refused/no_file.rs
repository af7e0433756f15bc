frs::frs_model!(mod arm);

fn main() {}
