//! The tables of operations in docs/generated.md say what generated functions perform, without fused products and with them.

use std::fs;
use std::path::Path;

use frs_codegen::{Options, generate};
use frs_core::{Model, Quantity};

/// The columns of the table.
const ROBOTS: [&str; 6] =
    ["planar_three_link", "chaser", "lwr_satellite", "quadruped", "dual_arm_satellite", "humanoid"];

/// 1234567 as 1,234,567.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let groups: Vec<&str> = digits.as_bytes().rchunks(3).rev().map(|group| str::from_utf8(group).unwrap()).collect();
    groups.join(",")
}

#[test]
fn the_table_of_operations_is_what_a_call_performs() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let robots = ROBOTS.map(|robot| {
        let text = fs::read_to_string(root.join(format!("robots/{robot}.urdf"))).unwrap();
        generate(&Model::from_urdf(&text).unwrap(), &Options::default()).unwrap()
    });
    let row = |quantity: Quantity| {
        let counts = robots.each_ref().map(|robot| {
            let mut functions = robot.functions.iter();
            grouped(functions.find(|function| function.quantity == quantity).unwrap().counts.flops())
        });
        let meaning = if quantity == Quantity::Matrices { " (all of the above)" } else { "" };
        format!("| `{}`{meaning} | {} |", quantity.name(), counts.join(" | "))
    };
    let rows: Vec<String> = Quantity::ALL.map(row).into();
    let page = fs::read_to_string(root.join("docs/generated.md")).unwrap();
    let stale: Vec<&String> = rows.iter().filter(|row| !page.lines().any(|line| line == **row)).collect();
    let table = rows.join("\n");
    assert!(stale.is_empty(), "docs/generated.md does not have {stale:#?}; if it should, its table is\n{table}");
}
