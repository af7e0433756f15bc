//! The variants than which none is both cheaper and more accurate.

/// Whether a point (error, cost) is beaten by one that is at least as accurate and `factor` times cheaper.
pub fn dominated([error, cost]: [f64; 2], points: impl IntoIterator<Item = [f64; 2]>, factor: f64) -> bool {
    points.into_iter().any(|[other, price]| other <= error && price * factor < cost)
}

/// The numbers of the points (error, cost) that no other one beats, by falling error.
///
/// ```
/// let points = [[1e-3, 1.0], [1e-6, 5.0], [1e-4, 9.0], [1e-9, 7.0]];
/// assert_eq!(frs_sim::study::front(&points), [0, 1, 3]); // the third costs more than the second and is worse
/// ```
pub fn front(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).filter(|&i| points[i].iter().all(|x| x.is_finite())).collect();
    order.sort_by(|&i, &k| points[i][1].total_cmp(&points[k][1]).then(points[i][0].total_cmp(&points[k][0])));
    let mut best = f64::INFINITY;
    order.retain(|&i| {
        let better = points[i][0] < best;
        best = best.min(points[i][0]);
        better
    });
    order
}
