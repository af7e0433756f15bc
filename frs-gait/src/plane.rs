//! The shapes in which two coordinates vary while all others are held.

/// A plane of shapes: `q(x, y) = q₀` with coordinates `i`, `j` at x and y.
///
/// ```
/// let plane = frs_gait::ShapePlane::new(vec![0.1, 0.2, 0.3], [2, 0]);
/// assert_eq!(plane.shape([7.0, 8.0]), [8.0, 0.2, 7.0]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ShapePlane {
    q0: Vec<f64>,
    coordinates: [usize; 2],
}

impl ShapePlane {
    /// The plane through `q0` (rad, m) in which `coordinates` vary.
    ///
    /// # Panics
    /// If the two coordinates are the same, or one is not a coordinate of `q0`.
    pub fn new(q0: Vec<f64>, coordinates: [usize; 2]) -> Self {
        let [i, j] = coordinates;
        assert!(i != j && i < q0.len() && j < q0.len(), "two different coordinates of q0 span a plane");
        Self { q0, coordinates }
    }

    /// How many coordinates the robot has, n.
    pub fn dof(&self) -> usize {
        self.q0.len()
    }

    /// The two coordinates that vary, `[i, j]`.
    pub fn coordinates(&self) -> [usize; 2] {
        self.coordinates
    }

    /// `q(x, y)`, the shape at a point of the plane.
    pub fn shape(&self, point: [f64; 2]) -> Vec<f64> {
        let mut q = self.q0.clone();
        self.put(point, &mut q);
        q
    }

    /// A direction in the plane as a shape direction: 0 but for coordinates i and j.
    pub fn direction(&self, direction: [f64; 2]) -> Vec<f64> {
        let mut dq = vec![0.0; self.q0.len()];
        self.put(direction, &mut dq);
        dq
    }

    /// The point of the plane below a shape: its coordinates i and j.
    pub fn point(&self, q: &[f64]) -> [f64; 2] {
        self.coordinates.map(|coordinate| q[coordinate])
    }

    fn put(&self, pair: [f64; 2], vector: &mut [f64]) {
        for (coordinate, value) in self.coordinates.into_iter().zip(pair) {
            vector[coordinate] = value;
        }
    }
}
