//! The reduced-mass matrix of bodies that move relative to another one.

use frs_core::Real;

/// `μ_ab = m_a δ_ab − m_a m_b/M` of the `moving` bodies, their positions measured from the centre of mass of the body `base`,
/// M being the mass of all: relative to the total centre of mass, `Σ_k m_k y_k y_kᵀ = Σ_ab μ_ab r_a r_bᵀ`.
pub fn reduced_masses<T: Real, const N: usize>(base: f64, moving: [f64; N]) -> [[T; N]; N] {
    let total = T::from_f64(base + moving.iter().sum::<f64>());
    let mass = moving.map(T::from_f64);
    std::array::from_fn(|a| {
        std::array::from_fn(|b| {
            let own = if a == b { mass[a] } else { T::zero() };
            own - mass[a] * mass[b] / total
        })
    })
}

/// `ε = m₀ m₁/(m₀ + m₁)`, the reduced mass of two bodies.
pub fn reduced_mass<T: Real>(base: f64, moving: f64) -> T {
    reduced_masses::<T, 1>(base, [moving])[0][0]
}
