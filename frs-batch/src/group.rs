//! Who answers for several states at a time.

use frs_core::lanes::Lane;
use frs_core::{FloatingBase, Quantity};
use ndarray::{ArrayView2, ArrayViewMut2, Axis};

/// A robot that answers for up to [`states`](Self::states) states at a time.
pub trait Group {
    /// The numbers of arrays.
    type Element: Copy + Send + Sync;

    /// How many states it takes at a time, at most.
    fn states(&self) -> usize;

    /// Number n of coordinates.
    fn dof(&self) -> usize;

    /// Whether [`answer`](Self::answer) knows `quantity`.
    fn answers(&self, quantity: Quantity) -> bool;

    /// Computes `quantity` at every row: inputs and outputs are those that it lists, with a row for each of 1 to [`states`](Self::states)
    /// states.
    ///
    /// # Panics
    /// If [`answers`](Self::answers) says no, or if an array has not the shape that the quantity lists. [`crate::answer`] checks before.
    fn answer(
        &mut self,
        quantity: Quantity,
        inputs: &[ArrayView2<'_, Self::Element>],
        outputs: &mut [ArrayViewMut2<'_, Self::Element>],
    );
}

/// Any robot as a [`Group`]: over plain numbers a state at a time, over [lanes](frs_core::lanes) as many as there are lanes.
///
/// The robot is an [`Evaluator`](frs_core::Evaluator) over [`Model::cast`](frs_core::Model::cast), or a generated one.
///
/// ```
/// use frs_batch::{Side, answer};
/// use frs_core::lanes::F64x8;
/// use frs_core::{Evaluator, Model, Quantity};
/// use ndarray::Array2;
///
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?.cast::<F64x8>();
/// let (q, mut curvature, mut com) = (Array2::zeros((20, 7)), Array2::zeros((20, 147)), Array2::zeros((20, 3)));
/// let robot = || Side::new(Evaluator::new(&model));
/// answer(robot, Quantity::Curvature, &[q.view()], [curvature.view_mut(), com.view_mut()].into())?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Side<T, R> {
    robot: R,
    inputs: Vec<Vec<T>>,
    outputs: Vec<Vec<T>>,
}

impl<T: Lane, R: FloatingBase<T>> Side<T, R> {
    /// States side by side for `robot`.
    pub fn new(robot: R) -> Self {
        Self { robot, inputs: Vec::new(), outputs: Vec::new() }
    }
}

impl<T: Lane, R: FloatingBase<T>> Group for Side<T, R> {
    type Element = T::Element;

    fn states(&self) -> usize {
        T::WIDTH
    }

    fn dof(&self) -> usize {
        self.robot.dof()
    }

    fn answers(&self, quantity: Quantity) -> bool {
        self.robot.answers(quantity)
    }

    fn answer(
        &mut self,
        quantity: Quantity,
        inputs: &[ArrayView2<'_, T::Element>],
        outputs: &mut [ArrayViewMut2<'_, T::Element>],
    ) {
        self.inputs.resize_with(inputs.len(), Vec::new);
        for (side, array) in self.inputs.iter_mut().zip(inputs) {
            side.clear();
            let last = array.nrows() - 1;
            // What is missing is the last state once more.
            side.extend(array.columns().into_iter().map(|column| T::from_fn(|lane| column[lane.min(last)])));
        }
        self.outputs.resize_with(outputs.len(), Vec::new);
        for (side, array) in self.outputs.iter_mut().zip(outputs.iter()) {
            side.resize(array.ncols(), T::zero());
        }
        let given: Vec<&[T]> = self.inputs.iter().map(Vec::as_slice).collect();
        let mut asked: Vec<&mut [T]> = self.outputs.iter_mut().map(Vec::as_mut_slice).collect();
        self.robot.answer(quantity, &given, &mut asked);
        for (side, array) in self.outputs.iter().zip(outputs) {
            for (lane, mut row) in array.axis_iter_mut(Axis(0)).enumerate() {
                row.iter_mut().zip(side).for_each(|(entry, lanes)| *entry = lanes.lane(lane));
            }
        }
    }
}
