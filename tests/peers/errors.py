"""How far apart two answers are, as numbers without units.

Each velocity coordinate is measured in the unit that gives it the same kinetic energy, d_i = √M_ii: a matrix of inertias
is divided by d_i d_j, a force by d_i, a velocity multiplied by d_i. Entries of M are then at most one, a fingertip counts
as much as a torso, and neither metres nor joint order matter. What is left of the unit is a power of time, divided out
by the largest rate of the state. The scale comes from M and the state, never from the difference under test.
"""

import numpy as np

# Both sides round at 1e-16, magnified by lever arms (a finger's inertia, summed up at the pelvis) and by the conditioning
# of the scaled Λ_b: plain sums over links differ from Pinocchio by up to 1e-13 on these robots. Two digits of margin.
TOLERANCE = 1e-11

KEYS = {
    "M": "hamel_m", "Λ_b": "locked_inertia", "A_l": "connection", "Λ_q": "shape_inertia", "P": "p", "C": "hamel_c",
    "C V": "hamel_bias", "Λ_b μ": "momentum", "energy": "energy", "D ξ": "drift", "ξ̇": "xi_dot",
}


def worst(difference):
    """Largest entry; infinite where an entry is not a number, zero where there are none."""
    if not np.isfinite(difference).all():
        return np.inf
    return np.abs(difference).max(initial=0.0)


def errors(ours, theirs, state):
    """The scaled error of each quantity in `KEYS` that the reference has."""
    M, d = theirs.M, np.sqrt(theirs.M.diagonal())
    base, joints = d[:6], d[6:]
    V = np.concatenate([state.twist, state.qd])
    F = np.concatenate([state.wrench, state.tau])
    rate = np.abs(V).max()
    impulse = worst(M @ V / d)
    inertial = impulse * rate

    connection = base[:, None] * theirs.connection / joints
    found = {
        "M": worst((ours.M - M) / np.outer(d, d)),
        "Λ_b": worst((ours.locked - theirs.locked) / np.outer(base, base)),
        "A_l": worst(base[:, None] * (ours.connection - theirs.connection) / joints) / max(1.0, worst(connection)),
        "Λ_q": worst((ours.shape - theirs.shape) / np.outer(joints, joints)),
        "P": worst((ours.p - theirs.p) / np.outer(base, base)) / rate,
        # C_ij as the force that it makes at the largest rate: its entries cancel more than their product with V does.
        "C": worst((ours.C - theirs.C) / d[:, None]) / impulse,
        "C V": worst((ours.bias - theirs.bias) / d) / inertial,
        "Λ_b μ": worst((ours.momentum - theirs.momentum) / base) / impulse,
        "energy": worst(np.array(ours.energy - theirs.energy)) / theirs.energy,
        "D ξ": worst((ours.drift - theirs.drift) / d) / inertial,
    }
    if theirs.xi_dot is not None:
        # Backward error: the force that the difference of accelerations stands for, beside the forces that were
        # balanced. An ill-conditioned Λ magnifies the rounding of both sides in ξ̇ itself, without either being wrong.
        Lambda = np.zeros_like(M)
        Lambda[:6, :6], Lambda[6:, 6:] = theirs.locked, theirs.shape
        balanced = max(worst(F / d), inertial, worst(np.abs(Lambda) @ np.abs(theirs.xi_dot) / d))
        found["ξ̇"] = worst(Lambda @ (ours.xi_dot - theirs.xi_dot) / d) / balanced
    return found
