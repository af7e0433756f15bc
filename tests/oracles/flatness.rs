//! Which connections are flat.

use frs_oracles::{Case, Robots, shapes};

/// Shapes a case is tried at.
const SHAPES: usize = 50;

/// What is left of zero in doubles.
const ROUNDING: f64 = 1e-15;

/// Far below what any of the other robots has somewhere, 0.009 at least.
const CURVED: f64 = 1e-3;

fn flat(case: Case) -> bool {
    matches!(case, Case::P1 | Case::P2 | Case::P3 | Case::P4 | Case::S0)
}

fn curvature_vanishes_where_it_should_and_only_there(case: Case) {
    let robots = Robots::new(case);
    let mut largest = [0.0_f64; 2];
    for q in shapes(case, SHAPES, 8) {
        let answers = robots.answers(&q);
        for (largest, values) in largest.iter_mut().zip([&answers.core, &answers.formula]) {
            *largest =
                values.curvature.iter().flat_map(|twist| twist.to_array()).map(f64::abs).fold(*largest, f64::max);
        }
        assert!(!answers.core.connection.is_empty());
    }
    let [core, formula] = largest;
    if flat(case) {
        assert!(core <= ROUNDING && formula == 0.0, "{case:?}: largest entry of 𝓑: core {core:e}, formula {formula:e}");
    } else {
        assert!(core > CURVED && formula > CURVED, "{case:?}: largest entry of 𝓑: core {core:e}, formula {formula:e}");
    }
}

every_case!(curvature_vanishes_where_it_should_and_only_there);
