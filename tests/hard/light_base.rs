//! A base from 10⁻¹² to 10¹² of its own mass.
//!
//! As the base gets lighter, a joint near it moves less and less mass against it: Λ_q loses a digit for each digit of the ratio
//! where it is formed as a difference. Here nothing is: every entry is as good as rounding allows, in the scale of its own joints.

use frs::extended::DoubleDouble;
use frs::nalgebra::DMatrix;
use frs::spatial::{Symmetric3, Twist};
use frs::{Model, Real, Workspace, urdf};

/// Asked of every entry relative to the natural scale of its two joints. Moments are taken about the total centre of mass, at about
/// a metre from the last link, whose radius of inertia about its own joint is 2.6 cm: its inertia is the difference of terms 1,500
/// times as large, and each of them is rounded a few times.
const ENTRY: f64 = 1e-12;

/// Shapes a ratio.
const SHAPES: u32 = 20;

/// What the mass of the base enters.
struct Answers<T> {
    shape_inertia: DMatrix<T>,
    gamma_q: DMatrix<T>,
    b2: DMatrix<T>,
    coupling: Vec<T>,
}

fn answers<T: Real>(model: &Model<T>, [q, qd, mu]: [&[T]; 3]) -> Answers<T> {
    let n = model.dof();
    let square = || DMatrix::zeros(n, n);
    let mut answers =
        Answers { shape_inertia: square(), gamma_q: square(), b2: square(), coupling: vec![T::zero(); n] };
    let mu = Twist::from_array(std::array::from_fn(|i| mu[i]));
    let mut work = Workspace::new(model);
    let mut shape = work.shape(q);
    shape.shape_inertia(&mut answers.shape_inertia);
    shape.b2(mu, &mut answers.b2);
    shape.coupling_torque(mu, &mut answers.coupling);
    shape.moving(qd).gamma_q(&mut answers.gamma_q);
    answers
}

/// lwr_satellite with the inertia of its base times `ratio`.
fn robot(ratio: f64) -> Model {
    let model = Model::from_urdf(urdf::LWR_SATELLITE).expect("the robot is well formed");
    let root = &model.links()[0];
    let mut inertial = root.inertial;
    inertial.mass *= ratio;
    let Symmetric3 { xx, yy, zz, xy, xz, yz } = inertial.inertia;
    let [xx, yy, zz, xy, xz, yz] = [xx, yy, zz, xy, xz, yz].map(|entry| entry * ratio);
    inertial.inertia = Symmetric3 { xx, yy, zz, xy, xz, yz };
    model.with_inertial(&root.name.clone(), inertial).expect("the link is there")
}

/// Numbers in (−1, 1) that are the same everywhere.
fn number(seed: u32) -> f64 {
    (f64::from(seed) * 12.9898).sin() * 43758.5453 % 1.0
}

/// Worst errors of Λ_q, Γ'_q, B_2 and the coupling torque in the scales √(Λ_ii Λ_jj), that times ‖q̇‖, that times ‖ω‖,
/// √(Λ_jj) ‖ω‖ √(2 T(μ)).
fn worst(ratio: f64) -> [f64; 4] {
    let model = robot(ratio);
    let precise: Model<DoubleDouble> = model.cast();
    let mut worst = [0.0_f64; 4];
    for state in 0..SHAPES {
        let numbers = |from: u32, count: usize, scale: f64| -> Vec<f64> {
            (0..count as u32).map(|i| scale * number(100 * state + from + i)).collect()
        };
        let inputs = [numbers(0, 7, 3.0), numbers(20, 7, 1.0), numbers(40, 6, 1.0)];
        let exact_inputs = inputs.each_ref().map(|x| x.iter().map(|&x| DoubleDouble::from(x)).collect::<Vec<_>>());
        let got = answers(&model, inputs.each_ref().map(Vec::as_slice));
        let exact = answers(&precise, exact_inputs.each_ref().map(Vec::as_slice));
        let size = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
        let (rate, turn) = (size(&inputs[1]), size(&inputs[2][..3]));
        let mu = Twist::from_array(std::array::from_fn(|i| inputs[2][i]));
        let energy = mu.dot(Workspace::new(&model).shape(&inputs[0]).body_momentum(mu));
        let natural = |j: usize| exact.shape_inertia[(j, j)].high().sqrt();
        let off = |got: f64, exact: DoubleDouble| (DoubleDouble::from(got) - exact).high().abs();
        for j in 0..7 {
            for i in 0..7 {
                let scale = natural(i) * natural(j);
                let at = (i, j);
                worst[0] = worst[0].max(off(got.shape_inertia[at], exact.shape_inertia[at]) / scale);
                worst[1] = worst[1].max(off(got.gamma_q[at], exact.gamma_q[at]) / (scale * rate));
                worst[2] = worst[2].max(off(got.b2[at], exact.b2[at]) / (scale * turn));
            }
            worst[3] = worst[3].max(off(got.coupling[j], exact.coupling[j]) / (natural(j) * turn * energy.sqrt()));
        }
    }
    worst
}

#[test]
fn a_light_base_costs_no_digits() {
    for power in (-12..=12).step_by(3) {
        let worst = worst(10.0_f64.powi(power));
        assert!(worst.iter().all(|&worst| worst <= ENTRY), "base times 1e{power}: {worst:?}");
    }
}
