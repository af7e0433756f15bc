"""How far apart two answers are, as numbers without units.

Each velocity coordinate is measured in the unit that gives it the same kinetic energy, d_i = √M_ii: an inertia between
i and j is divided by d_i d_j, a force by d_i, a velocity multiplied by d_i. A fingertip then counts as much as a torso,
and neither metres nor the order of joints matter. What is left of the unit is a power of time, divided out by the largest
rate of the state. Only M and Λ_q, where small entries remain of large terms, are measured by those terms instead of by
d (`term_sizes`). Every scale comes from the reference and the state, never from the difference under test.
"""

import numpy as np

# Both sides round at 1e-16; solving with Λ_b and Λ_q makes that up to 3e-14 on these robots, which leaves two digits for
# others. A relative error of 1e-8 in B_2 alone shows as 1e-8.
TOLERANCE = 1e-11

KEYS = ["M", "Λ_b", "A_l", "Λ_q", "P", "C", "C V", "Λ_b μ", "energy", "D ξ", "ξ̇"]


def worst(difference):
    """Largest entry; infinite where an entry is not a number, zero where there are none."""
    if not np.isfinite(difference).all():
        return np.inf
    return np.abs(difference).max(initial=0.0)


def errors(ours, theirs, state):
    """The scaled error of each quantity in `KEYS`."""
    M, d = theirs.M, np.sqrt(theirs.M.diagonal())
    base, joints = d[:6], d[6:]
    V = np.concatenate([state.twist, state.qd])
    F = np.concatenate([state.wrench, state.tau])
    rate = np.abs(V).max()
    impulse = worst(M @ V / d)
    inertial = impulse * rate

    connection = base[:, None] * theirs.connection / joints
    # The difference of accelerations is judged backwards: as the force that it stands for, beside the forces that were
    # balanced. An ill-conditioned Λ magnifies the rounding of both sides in ξ̇ itself, without either being wrong.
    Lambda = np.zeros_like(M)
    Lambda[:6, :6], Lambda[6:, 6:] = theirs.locked, theirs.shape
    balanced = max(worst(F / d), inertial, worst(np.abs(Lambda) @ np.abs(theirs.xi_dot) / d))

    return {
        "M": worst((ours.M - M) / np.outer(theirs.terms, theirs.terms)),
        "Λ_b": worst((ours.locked - theirs.locked) / np.outer(base, base)),
        "A_l": worst(base[:, None] * (ours.connection - theirs.connection) / joints) / max(1.0, worst(connection)),
        "Λ_q": worst((ours.shape - theirs.shape) / np.outer(theirs.terms[6:], theirs.terms[6:])),
        "P": worst((ours.p - theirs.p) / np.outer(base, base)) / rate,
        # C_ij as the force that it makes at the largest rate: its entries cancel more than their product with V does.
        "C": worst((ours.C - theirs.C) / d[:, None]) / impulse,
        "C V": worst((ours.bias - theirs.bias) / d) / inertial,
        "Λ_b μ": worst((ours.momentum - theirs.momentum) / base) / impulse,
        "energy": worst(np.array(ours.energy - theirs.energy)) / theirs.energy,
        "D ξ": worst((ours.drift - theirs.drift) / d) / inertial,
        "ξ̇": worst(Lambda @ (ours.xi_dot - theirs.xi_dot) / d) / balanced,
    }
