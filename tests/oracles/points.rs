//! Formulas, core and generated code at shapes whose numbers were made without any of them, and at random shapes.

use frs_core::{Evaluator, FloatingBase, Quantity};
use frs_oracles::{Answers, Case, ROUNDING, Robots, Values, compare, judged_shapes, points, shapes};

/// The known centres of mass are rounded to doubles.
const ROUNDED: f64 = 1e-15;

/// Shapes at which bits are compared.
const SHAPES: usize = 1000;

fn known(case: Case, way: impl Fn(&Answers) -> &Values<f64>) {
    let robots = Robots::new(case);
    let points = points(case);
    assert_eq!(points.len(), 24, "{case:?}");
    for point in points {
        let answers = robots.answers(&point.q);
        let found = way(&answers);
        let comparison = compare(&found.widened(), &point.values.widened());
        assert!(
            comparison.within(ROUNDING),
            "{case:?} at {:?}: {}; {}",
            point.q,
            comparison.connection,
            comparison.curvature
        );
        assert!((found.com - point.values.com).amax() <= ROUNDED, "{case:?} at {:?}: {found:?} and {point:?}", point.q);
    }
}

fn formulas_give_the_known_numbers(case: Case) {
    known(case, |answers| &answers.formula);
}

fn the_core_gives_the_known_numbers(case: Case) {
    known(case, |answers| &answers.core);
}

fn generated_code_gives_the_known_numbers(case: Case) {
    known(case, |answers| &answers.generated);
}

fn four_ways_agree_at_random_shapes(case: Case) {
    let robots = Robots::new(case);
    for q in judged_shapes(case) {
        let judgement = robots.answers(&q).judgement();
        assert!(judgement.holds(case), "{case:?} at {q:?}: {judgement:#?}");
    }
}

/// 𝓑 on two unit directions, which is computed from velocities of bodies, without 𝓑_v = c × 𝓑_ω.
fn curvature_on_unit_directions_is_the_formula(case: Case) {
    let model = case.model();
    let n = model.dof();
    let mut work = frs_core::Workspace::new(&model);
    for q in shapes(case, 100, 2) {
        let expected: Values<f64> = case.values(&q);
        let mut shape = work.shape(&q);
        let unit = |i: usize| (0..n).map(|k| f64::from(u8::from(k == i))).collect::<Vec<_>>();
        let on = |(i, j)| shape.curvature_on(&unit(i), &unit(j));
        let found = Values { curvature: Values::<f64>::pairs(n).map(on).collect(), ..expected.clone() };
        let worst = compare(&found.widened(), &expected.widened()).curvature;
        assert!(worst.relative <= ROUNDING, "{case:?} at {q:?}: {worst}");
    }
}

fn generated_code_has_the_bits_of_the_core(case: Case) {
    let model = case.model();
    let (mut core, mut generated) = (Evaluator::new(&model), case.generated());
    let n = model.dof();
    assert_eq!(generated.dof(), n, "{case:?}");
    for q in shapes(case, SHAPES, 3) {
        for quantity in [Quantity::Inertia, Quantity::Curvature] {
            let ask = |robot: &mut dyn FloatingBase| {
                let mut outputs: Vec<_> = quantity.outputs().map(|o| vec![f64::NAN; o.len(n)]).collect();
                let mut slices: Vec<&mut [f64]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
                robot.answer(quantity, &[&q], &mut slices);
                outputs
            };
            let (expected, found) = (ask(&mut core), ask(generated.as_mut()));
            for (output, (expected, found)) in quantity.outputs().zip(expected.iter().zip(&found)) {
                for (entry, (expected, found)) in expected.iter().zip(found).enumerate() {
                    let name = output.name;
                    assert!(expected.is_finite(), "{case:?} at {q:?}: {name}[{entry}]");
                    assert_eq!(expected.to_bits(), found.to_bits(), "{case:?} at {q:?}: {name}[{entry}]");
                }
            }
        }
    }
}

every_case!(formulas_give_the_known_numbers);
every_case!(the_core_gives_the_known_numbers);
every_case!(generated_code_gives_the_known_numbers);
every_case!(four_ways_agree_at_random_shapes);
every_case_with_pairs!(curvature_on_unit_directions_is_the_formula);
every_case!(generated_code_has_the_bits_of_the_core);
