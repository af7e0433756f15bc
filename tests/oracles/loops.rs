//! Finite loops, and the limit of small ones: what the connection does to a robot at rest.

use frs_core::spatial::{Pose, Twist};
use frs_core::{Evaluator, Model};
use frs_gait::{Gait, Path, displacement};
use frs_oracles::{Case, Kind, Loop, Values, loops, shapes};

/// Rotation and translation (rad and m); the paths are followed to a hundredth of this.
const DISPLACEMENT: f64 = 1e-10;

/// Sides of small squares, rad or m.
const SIDES: [f64; 2] = [1.0 / 64.0, 1.0 / 128.0];

/// Displacement plus area times 𝓑 falls with the third power of the side.
const ORDER: f64 = 2.9;

/// What following a square leaves, in doubles.
const ROUNDING: f64 = 1e-13;

/// A loop of `data/loops.json` as a path.
struct Followed<'l>(&'l Loop, usize);

impl Path for Followed<'_> {
    fn dof(&self) -> usize {
        self.1
    }

    fn pieces(&self) -> usize {
        self.0.path.pieces()
    }

    fn at(&self, piece: usize, t: f64, q: &mut [f64], dq: &mut [f64]) {
        let [shape, rate] = self.0.path.at(piece, t);
        q.copy_from_slice(&shape);
        dq.copy_from_slice(&rate);
    }
}

fn follow(model: &Model, path: &impl Path, tolerance: f64) -> Pose<f64> {
    displacement(&mut Evaluator::new(model), path, tolerance).expect("no shape on the path is singular").pose
}

/// Follows every loop of a kind; all that end elsewhere are named.
fn displacements(kind: Kind) {
    let known: Vec<_> = loops().into_iter().filter(|known| known.kind == kind).collect();
    assert_eq!(known.len(), if kind == Kind::Exact { 21 } else { 9 });
    let elsewhere: Vec<String> = known
        .iter()
        .filter_map(|known| {
            let model = known.case.model();
            let found = follow(&model, &Followed(known, model.dof()), 0.01 * DISPLACEMENT);
            let expected = known.displacement;
            let turn = (found.rotation - expected.rotation).amax();
            let shift = (found.translation - expected.translation).amax();
            let name = format!("{:?}, {}: {found:?} and {expected:?}: {turn:.1e}, {shift:.1e}", known.case, known.name);
            (turn.max(shift).is_nan() || turn.max(shift) > DISPLACEMENT).then_some(name)
        })
        .collect();
    assert!(elsewhere.is_empty(), "{}", elsewhere.join("\n"));
}

/// g₀⁻¹g_T is what a closed form says.
#[test]
fn finite_loops_displace_the_base_as_in_closed_form() {
    displacements(Kind::Exact);
}

/// g₀⁻¹g_T is what was found in extended arithmetic.
#[test]
fn finite_loops_displace_the_base_as_in_extended_arithmetic() {
    displacements(Kind::Reference);
}

/// log(g₀⁻¹g_T) = −side²·𝓑(e_i, e_j) + O(side³), corner at q.
fn small_squares_displace_the_base_by_minus_area_times_curvature(case: Case) {
    let model = case.model();
    for q in shapes(case, 2, 15) {
        let formula: Values<f64> = case.values(&q);
        for (i, j) in Values::<f64>::pairs(q.len()) {
            let [coarse, fine] = SIDES.map(|side| {
                let moved = |first: f64, second: f64| {
                    let mut q = q.clone();
                    (q[i], q[j]) = (q[i] + first, q[j] + second);
                    q
                };
                let corners = [moved(0.0, 0.0), moved(side, 0.0), moved(side, side), moved(0.0, side)];
                let square = Gait::polygon(&corners).expect("four corners");
                let left: Twist<f64> =
                    follow(&model, &square, 0.01 * ROUNDING).log() + formula.curvature(i, j) * (side * side);
                left.to_vector().norm()
            });
            let order = (coarse / fine).log2();
            assert!(
                coarse <= ROUNDING || order >= ORDER,
                "{case:?} at {q:?}, ({i}, {j}): {coarse:e} and {fine:e} are of order {order}"
            );
            assert!(coarse < SIDES[0] * SIDES[0] * 0.1, "{case:?} at {q:?}, ({i}, {j}): {coarse:e}");
        }
    }
}

/// The way back undoes the way there, so another way ends elsewhere and the comparison can fail.
#[test]
fn a_loop_walked_backwards_is_another_one() {
    let known = loops().into_iter().find(|known| known.case == Case::P5).expect("P5 has a rectangle");
    let model = Case::P5.model();
    let back = follow(&model, &frs_gait::Reversed(Followed(&known, 2)), DISPLACEMENT);
    assert!((back.rotation - known.displacement.rotation).amax() > 1e-3);
    assert!((back.rotation * known.displacement.rotation - nalgebra::Matrix3::identity()).amax() <= DISPLACEMENT);
}

every_case_with_pairs!(small_squares_displace_the_base_by_minus_area_times_curvature);
