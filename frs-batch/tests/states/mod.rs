//! Random states, and the answers to them.

use frs_batch::{Group, answer};
use frs_core::{Model, Quantity};
use ndarray::{Array2, ArrayBase, Ix2, RawData, s};

/// How states lie in memory.
#[derive(Clone, Copy, Debug)]
pub enum Order {
    /// A state after the other.
    Rows,
    /// A number of all states after the other.
    Columns,
}

/// A robot of `robots/`.
pub fn model(name: &str) -> Model {
    let path = format!("{}/../robots/{name}.urdf", env!("CARGO_MANIFEST_DIR"));
    Model::from_urdf(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Inputs of `quantity` at random states, a row each; every tenth number is 0 or far from it.
pub fn states(model: &Model, quantity: Quantity, count: usize, seed: u64) -> Vec<Array2<f64>> {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut number = || match random.u8(0..20) {
        0 => 0.0,
        1 => 1e4 * (random.f64() - 0.5),
        _ => 6.0 * (random.f64() - 0.5),
    };
    quantity.inputs().map(|input| Array2::from_shape_simple_fn((count, input.len(model.dof())), &mut number)).collect()
}

impl Order {
    /// An array with a state a row, of one that lies in this order, or the reverse.
    fn rows<S: RawData<Elem = f64>>(self, array: ArrayBase<S, Ix2>) -> ArrayBase<S, Ix2> {
        match self {
            Self::Rows => array,
            Self::Columns => array.reversed_axes(),
        }
    }

    /// NaN around `states` × `numbers` of NaN, as they lie in memory.
    fn nothing(self, states: usize, numbers: usize) -> Array2<f64> {
        let [rows, columns] = match self {
            Self::Rows => [states, numbers],
            Self::Columns => [numbers, states],
        };
        Array2::from_elem((rows + 2, columns + 2), f64::NAN)
    }
}

/// The answers to the first `count` states. All arrays lie within larger ones of NaN: what is read outside would spoil answers, and what is
/// written there is seen.
#[allow(clippy::reversed_empty_ranges, reason = "of an array, −1 is the last row")]
pub fn answers<G: Group<Element = f64>>(
    robot: impl Fn() -> G + Sync,
    quantity: Quantity,
    inputs: &[Array2<f64>],
    count: usize,
    order: Order,
    threads: usize,
) -> Vec<Array2<f64>> {
    let (n, inside) = (inputs[0].ncols(), s![1..-1, 1..-1]);
    let given = inputs.iter().map(|array| {
        let mut all = order.nothing(count, array.ncols());
        order.rows(all.slice_mut(inside)).assign(&array.slice(s![..count, ..]));
        all
    });
    let given: Vec<_> = given.collect();
    let mut asked: Vec<_> = quantity.outputs().map(|output| order.nothing(count, output.len(n))).collect();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let robot = &robot;
    pool.install(|| {
        let given: Vec<_> = given.iter().map(|array| order.rows(array.slice(inside))).collect();
        let asked = asked.iter_mut().map(|array| order.rows(array.slice_mut(inside))).collect();
        answer(robot, quantity, &given, asked).unwrap();
    });
    let found = asked.iter_mut().map(|array| {
        let found = order.rows(array.slice(inside)).to_owned();
        array.slice_mut(inside).fill(f64::NAN);
        assert!(array.iter().all(|number| number.is_nan()), "something was written outside of the outputs");
        found
    });
    found.collect()
}

/// The bits of an array, state by state.
pub fn bits(array: &Array2<f64>) -> impl Iterator<Item = u64> {
    array.rows().into_iter().flat_map(|row| row.to_vec()).map(|number| number.to_bits())
}
