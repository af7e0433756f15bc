//! Another link as base: the formulas moved by the link's pose say what the core must give.

use frs_core::model::RobotDescription;
use frs_core::spatial::Twist;
use frs_core::{Evaluator, Workspace};
use frs_oracles::{Case, ROUNDING, Values, compare, shapes};
use nalgebra::Matrix6xX;

/// Shapes a link is tried at.
const SHAPES: usize = 10;

fn twist(column: &[f64]) -> Twist<f64> {
    Twist::from_array(std::array::from_fn(|i| column[i]))
}

/// A^k = Ad_{1k}⁻¹ A − J_k and 𝓑^k = Ad_{1k}⁻¹ 𝓑 for every link k.
fn another_base_moves_the_formulas(case: Case) {
    let here = case.model();
    let n = here.dof();
    let mut work = Workspace::new(&here);
    for (number, link) in here.links().iter().enumerate() {
        let rerooted = RobotDescription { root: Some(link.name.clone()), ..case.robot() };
        let there = rerooted.build().unwrap_or_else(|error| panic!("{case:?} from {}: {error}", link.name));
        let place = |name: &str| there.coordinates().iter().position(|c| c.name == name);
        // Where each coordinate stands when counted from the other base.
        let order: Vec<usize> = here.coordinates().iter().filter_map(|c| place(&c.name)).collect();
        assert_eq!(order.len(), n, "{case:?} from {}", link.name);
        for q in shapes(case, SHAPES, 9) {
            let mut jacobian = Matrix6xX::zeros(n);
            let shape = work.shape(&q);
            let pose = shape.link_pose(number);
            shape.link_jacobian(number, &mut jacobian);
            let formula: Values<f64> = case.values(&q);
            let moved = formula.connection.iter().zip(jacobian.column_iter());
            let expected = Values {
                connection: moved.map(|(column, own)| pose.act_inverse(*column) - twist(own.as_slice())).collect(),
                curvature: formula.curvature.iter().map(|twist| pose.act_inverse(*twist)).collect(),
                com: pose.inverse().transform(formula.com),
            };

            let mut reordered = vec![0.0; n];
            order.iter().zip(&q).for_each(|(&place, &value)| reordered[place] = value);
            let core = Values::of(&mut Evaluator::new(&there), &reordered);
            let found = Values {
                connection: order.iter().map(|&place| core.connection[place]).collect(),
                curvature: Values::<f64>::pairs(n).map(|(i, j)| core.curvature(order[i], order[j])).collect(),
                com: core.com,
            };
            let comparison = compare(&found.widened(), &expected.widened());
            assert!(
                comparison.within(ROUNDING),
                "{case:?} from {} at {q:?}: {}; {}",
                link.name,
                comparison.connection,
                comparison.curvature
            );
        }
    }
}

every_case!(another_base_moves_the_formulas);
