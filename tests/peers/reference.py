"""What Pinocchio says about one state, in the notation of `frs`: angular part first, velocity (V₁, q̇)."""

from dataclasses import dataclass

import numpy as np
import pinocchio as pin


@dataclass
class Reference:
    M: np.ndarray  # mass matrix of the Hamel form
    C: np.ndarray  # its Coriolis matrix
    bias: np.ndarray  # C V
    locked: np.ndarray  # Λ_b
    connection: np.ndarray  # A_l
    shape: np.ndarray  # Λ_q
    p: np.ndarray  # dΛ_b/dt
    momentum: np.ndarray  # Λ_b μ
    energy: float
    drift: np.ndarray  # (D_q̇ − D_μ) ξ
    xi: np.ndarray  # [μ; q̇]
    xi_dot: np.ndarray | None  # [μ̇; q̈]; none where M is singular


# An eigenvalue of M below this, with M scaled to a unit diagonal, is rounding: the robot has a motion without inertia.
SINGULAR = 1e-13


def angular_first(nv):
    """Pinocchio's order of velocities (linear, angular, joints) as an index into ours."""
    return np.r_[3:6, 0:3, 6:nv]


def ad(V):
    """`ad_V` of a twist [ω; v]."""
    omega, v = pin.skew(V[:3]), pin.skew(V[3:])
    return np.block([[omega, np.zeros((3, 3))], [v, omega]])


def is_singular(M):
    if M.diagonal().min() <= 0:
        return True
    d = np.sqrt(M.diagonal())
    return np.linalg.eigvalsh(M / np.outer(d, d))[0] < SINGULAR


def reference(robot, state):
    model, data = robot.model, robot.data
    order = angular_first(model.nv)
    H = np.zeros((model.nv, 6 + robot.n))
    H[:6, :6] = np.eye(6)
    H[6:, 6:] = robot.G

    V = np.concatenate([state.twist, state.qd])
    q, v = robot.configuration(state.q), (H @ V)[order]  # `order` swaps two triples: it is its own inverse
    upper = np.triu(pin.crba(model, data, q))
    M = H.T @ (upper + np.triu(upper, 1).T)[np.ix_(order, order)] @ H
    C = H.T @ pin.computeCoriolisMatrix(model, data, q, v)[np.ix_(order, order)] @ H
    bias = H.T @ pin.nonLinearEffects(model, data, q, v)[order]
    F = np.concatenate([state.wrench, state.tau])

    b, s = slice(0, 6), slice(6, None)
    locked, A = M[b, b], np.linalg.solve(M[b, b], M[b, s])
    mu = state.twist + A @ state.qd
    momentum = M[b] @ V

    # Pinocchio's C obeys dM/dt = C + Cᵀ, and Λ_b depends on q̇ alone: its rate comes without a finite difference.
    p = C[b, b] + C[b, b].T
    # Balance of momentum h = Λ_b μ in the moving base frame, ḣ = ad_{V₁}ᵀ h + F₁, gives the upper rows exactly:
    # Λ_b μ̇ = F₁ − (P μ − ad_{V₁}ᵀ h). The lower rows are the Hamel form's, less A_lᵀ times its base rows.
    drift = np.concatenate([p @ mu - ad(state.twist).T @ momentum, bias[s] - A.T @ bias[b]])

    xi_dot = None
    if not is_singular(M):
        if robot.has_mimic:
            acceleration = np.linalg.solve(M, F - bias)
        else:
            acceleration = pin.aba(model, data, q, v, F[order])[order]
        mu_dot = np.linalg.solve(locked, F[b] - drift[b])
        xi_dot = np.concatenate([mu_dot, acceleration[s]])

    return Reference(
        M=M, C=C, bias=bias, locked=locked, connection=A, shape=M[s, s] - A.T @ M[b, s], p=p,
        momentum=momentum, energy=0.5 * V @ M @ V, drift=drift, xi=np.concatenate([mu, state.qd]), xi_dot=xi_dot,
    )
