//! The connection and its curvature at a shape: what a case's formulas, the core and generated code all give.

use frs_core::extended::DoubleDouble;
use frs_core::spatial::Twist;
use frs_core::{FloatingBase, Quantity, Real};
use nalgebra::Vector3;

/// A_l, 𝓑 and c of a robot at a shape, in the base frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Values<T: Real> {
    /// The columns of A_l, one a coordinate.
    pub connection: Vec<Twist<T>>,
    /// 𝓑(e_i, e_j) for i < j, in the order of [`pairs`](Self::pairs).
    pub curvature: Vec<Twist<T>>,
    /// The total centre of mass c, m.
    pub com: Vector3<T>,
}

const ROWS: [&str; 6] = ["ω_x", "ω_y", "ω_z", "v_x", "v_y", "v_z"];

impl<T: Real> Values<T> {
    /// From how the base turns: `A_v = c × A_ω + J_c` and `𝓑_v = c × 𝓑_ω`, with the angular columns A_ω, the centre of mass c,
    /// the columns ∂c/∂q of J_c, and 𝓑_ω by pairs. Source: docs/mathematics.md §3.9.
    pub(crate) fn turning(
        connection: &[Vector3<T>],
        com: Vector3<T>,
        com_jacobian: &[Vector3<T>],
        curvature: &[Vector3<T>],
    ) -> Self {
        let columns = connection.iter().zip(com_jacobian);
        Self {
            connection: columns.map(|(turn, slide)| Twist::new(*turn, com.cross(turn) + slide)).collect(),
            curvature: curvature.iter().map(|turn| Twist::new(*turn, com.cross(turn))).collect(),
            com,
        }
    }

    /// The same for a robot in the plane z = 0, of which `connection` and `curvature` are the turns about z.
    pub(crate) fn planar(connection: &[T], com: Vector3<T>, com_jacobian: &[Vector3<T>], curvature: &[T]) -> Self {
        let about_z = |turns: &[T]| turns.iter().map(|&turn| Vector3::z() * turn).collect::<Vec<_>>();
        Self::turning(&about_z(connection), com, com_jacobian, &about_z(curvature))
    }

    /// What `robot` answers at shape `q`; it must know the inertia and the curvature.
    pub fn of(robot: &mut dyn FloatingBase<T>, q: &[T]) -> Self {
        let n = robot.dof();
        // An entry that nobody writes stays NaN.
        let mut answer = |quantity: Quantity| {
            let mut outputs: Vec<Vec<T>> = quantity.outputs().map(|o| vec![T::from_f64(f64::NAN); o.len(n)]).collect();
            let mut slices: Vec<&mut [T]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
            robot.answer(quantity, &[q], &mut slices);
            outputs
        };
        let [inertia, curvature] = [answer(Quantity::Inertia), answer(Quantity::Curvature)];
        let com = Vector3::from_column_slice(&curvature[1]);
        let turn = |(i, j)| Vector3::from_fn(|layer, _| curvature[0][layer * n * n + j * n + i]);
        Self {
            connection: inertia[1].chunks(6).map(|six| Twist::from_array(std::array::from_fn(|i| six[i]))).collect(),
            curvature: Self::pairs(n).map(turn).map(|turn| Twist::new(turn, com.cross(&turn))).collect(),
            com,
        }
    }

    /// The pairs (i, j) of `n` coordinates with i < j: (0, 1), (0, 2), …, (1, 2), ….
    pub fn pairs(n: usize) -> impl Iterator<Item = (usize, usize)> {
        (0..n).flat_map(move |i| (i + 1..n).map(move |j| (i, j)))
    }

    /// All entries of A_l and then of 𝓑 with their names: `A_l[v_x, 1]`, `𝓑[ω_z](0, 1)`; coordinates count from 0.
    pub fn entries(&self) -> Vec<(String, T)> {
        let columns = self.connection.iter().enumerate();
        let connection = columns.flat_map(|(j, column)| {
            ROWS.into_iter().zip(column.to_array()).map(move |(row, entry)| (format!("A_l[{row}, {j}]"), entry))
        });
        let pairs = Self::pairs(self.connection.len()).zip(&self.curvature);
        let curvature = pairs.flat_map(|((i, j), pair)| {
            ROWS.into_iter().zip(pair.to_array()).map(move |(row, entry)| (format!("𝓑[{row}]({i}, {j})"), entry))
        });
        connection.chain(curvature).collect()
    }

    /// 𝓑(e_i, e_j) for any i and j.
    ///
    /// # Panics
    /// If there are not so many coordinates.
    pub fn curvature(&self, i: usize, j: usize) -> Twist<T> {
        let n = self.connection.len();
        assert!(i.max(j) < n, "there are {n} coordinates");
        let position = |wanted| Self::pairs(n).zip(&self.curvature).find(|(pair, _)| *pair == wanted);
        match position((i.min(j), i.max(j))) {
            Some((_, twist)) if i < j => *twist,
            Some((_, twist)) => -*twist,
            None => Twist::zero(),
        }
    }
}

impl Values<f64> {
    /// The same numbers in double-double.
    pub fn widened(&self) -> Values<DoubleDouble> {
        let twist = |twist: &Twist<f64>| Twist::from_array(twist.to_array().map(DoubleDouble::from));
        Values {
            connection: self.connection.iter().map(twist).collect(),
            curvature: self.curvature.iter().map(twist).collect(),
            com: self.com.map(DoubleDouble::from),
        }
    }
}
