"""What is asked of every contestant at a state, and what every answer must be.

The yardstick is Pinocchio's wheel in the notation of `frs` (angular part first), as in tests/peers/reference.py. What a
contestant answers is compared part by part, relative to the part's largest number; accelerations are compared by the
force that they leave unbalanced, relative to the forces in balance, since a light last link of a long chain makes any two
algorithms differ by more than their rounding.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pinocchio as pin
from reference import ad, angular_first

SAME = 1e-12  # of a part's largest number
SAME_SINGLE = 2e-3  # of it, in single precision

# Parts of answers. Rows and columns of a matrix; whether a vector holds velocities or their like.
MATRICES = {
    "mass": ("all", "all"), "locked_inertia": ("base", "base"), "connection": ("base", "joints"),
    "shape_inertia": ("joints", "joints"), "coriolis": ("all", "all"), "d_mu": ("all", "all"), "d_qdot": ("all", "all"),
    "b2": ("joints", "joints"),
}
VECTORS = {"com": False, "acceleration": True, "classical_acceleration": True, "xi_dot": True}


@dataclass
class Own:
    """A state in the coordinates of `frs`."""

    q: np.ndarray
    qd: np.ndarray
    mu: np.ndarray
    wrench: np.ndarray
    tau: np.ndarray


class Question:
    """One state of the tree of all joints and, where joints follow others, of the coordinates."""

    def __init__(self, robot, state):
        self.robot = robot
        self.order = angular_first(robot.model.nv)
        self.angles = robot.G @ state.q + robot.offset
        self.configuration = robot.configuration(state.q)
        self.velocity = np.concatenate([state.twist, robot.G @ state.qd])
        self.force = np.concatenate([state.wrench, robot.G @ state.tau])
        self.tree = Truth(self.mass(), self.coriolis, self.velocity, self.force)
        lift = np.block([[np.eye(6), np.zeros((6, robot.n))], [np.zeros((robot.model.nv - 6, 6)), robot.G]])
        force = np.concatenate([state.wrench, state.tau])
        coriolis = lambda V: lift.T @ self.coriolis(lift @ V) @ lift
        velocity = np.concatenate([state.twist, state.qd])
        self.reduced = Truth(lift.T @ self.mass() @ lift, coriolis, velocity, force)
        self.own = Own(state.q, state.qd, self.reduced.mu, state.wrench, state.tau)

    def mass(self):
        upper = np.triu(pin.crba(self.robot.model, self.robot.data, self.configuration))
        return (upper + np.triu(upper, 1).T)[np.ix_(self.order, self.order)]

    def coriolis(self, V):
        model, data = self.robot.model, self.robot.data
        return pin.computeCoriolisMatrix(model, data, self.configuration, V[self.order])[np.ix_(self.order, self.order)]


class Truth:
    """The quantities at a state, from M and from C(V) of the velocities V = [V₁; q̇]."""

    def __init__(self, M, C, V, force):
        self.M, self.C, self.V, self.force = M, C, V, force
        self.locked = M[:6, :6]
        self.connection = np.linalg.solve(self.locked, M[:6, 6:])
        self.shape = M[6:, 6:] - self.connection.T @ M[:6, 6:]
        self.mu = V[:6] + self.connection @ V[6:]
        self.xi = np.concatenate([self.mu, V[6:]])

    @cached_property
    def bias(self):
        return self.C(self.V) @ self.V

    @cached_property
    def drift(self):
        return self.drift_at(self.mu, self.V[6:])

    def drift_at(self, mu, qd):
        """(D_q̇ − D_μ) ξ: upper rows by the balance of momentum in the moving base, lower ones less A_lᵀ times the base's."""
        V = np.concatenate([mu - self.connection @ qd, qd])
        C = self.C(V)
        rate, bias = C[:6, :6] + C[:6, :6].T, C @ V
        upper = rate @ mu - ad(V[:6]).T @ (self.locked @ mu)
        return np.concatenate([upper, bias[6:] - self.connection.T @ bias[:6]])

    def d_qdot_xi(self):
        """Of a body that does not turn as one, and half of what Λ_b's rate makes of μ."""
        C = self.C(np.concatenate([-self.connection @ self.V[6:], self.V[6:]]))
        rate = C[:6, :6] + C[:6, :6].T
        return np.concatenate([0.5 * rate @ self.mu, self.drift_at(0 * self.mu, self.V[6:])[6:]])

    def shape_coriolis(self, mu):
        """The joints' block of C in (μ, q̇) while the joints rest, which is B_2(μ)."""
        n = self.M.shape[0] - 6
        C = self.C(np.concatenate([mu, np.zeros(n)]))
        A, base = self.connection, self.M[:6, 6:]
        gathered = C[:6, 6:] + C[6:, :6].T - (C[:6, :6] + C[:6, :6].T) @ A
        upper = C[:6, 6:] - C[:6, :6] @ A - gathered
        lower = C[6:, 6:] - C[6:, :6] @ A - base.T @ np.linalg.solve(self.locked, gathered)
        return lower - A.T @ upper

    def curvature(self):
        """𝓑_ω, three n×n layers: what a momentum of one about each axis of the base feels, times −2."""
        return np.stack([-2.0 * self.shape_coriolis(np.linalg.solve(self.locked, axis)) for axis in np.eye(6)[:3]])

    def errors(self, parts, order):
        """How far each part of an answer is; `order` is where the contestant has our velocities."""
        found = {}
        for name, numbers in parts.items():
            ours, truth, scale = getattr(self, f"see_{name}")(self.laid_out(name, np.array(numbers), order))
            found[name] = float(np.abs(ours - truth).max() / (np.abs(truth).max() if scale is None else scale))
        return found

    def laid_out(self, name, numbers, order):
        """A part as a matrix or a vector, in our order; matrices come by columns."""
        n = self.M.shape[0] - 6
        if name == "curvature":
            return numbers.reshape(3, n, n).transpose(0, 2, 1)
        if name in VECTORS:
            return numbers[order] if VECTORS[name] else numbers
        places = {"base": order[:6], "joints": order[6:] - 6, "all": order}
        rows, columns = (places[side] for side in MATRICES[name])
        return numbers.reshape(len(columns), len(rows)).T[np.ix_(rows, columns)]

    def see_mass(self, value):
        return value, self.M, None

    def see_locked_inertia(self, value):
        return value, self.locked, None

    def see_connection(self, value):
        return value, self.connection, None

    def see_shape_inertia(self, value):
        return value, self.shape, None

    def see_coriolis(self, value):
        return value @ self.xi, self.drift, None

    def see_d_mu(self, value):
        return value @ self.xi, self.d_qdot_xi() - self.drift, None

    def see_d_qdot(self, value):
        return value @ self.xi, self.d_qdot_xi(), None

    def see_b2(self, value):
        return value, self.shape_coriolis(self.mu), None

    def see_curvature(self, value):
        return value, self.curvature(), None

    def see_com(self, value):
        corner = self.locked[:3, 3:] / self.locked[5, 5]
        return value, np.array([corner[2, 1], corner[0, 2], corner[1, 0]]), None

    def see_acceleration(self, value):
        """V̇ = [V̇₁; q̈]."""
        scale = np.abs(self.M) @ np.abs(value) + np.abs(self.bias) + np.abs(self.force)
        return self.M @ value + self.bias, self.force, scale.max()

    def see_classical_acceleration(self, value):
        """V̇ with the acceleration of the base's origin as a point: its velocity turns with the base."""
        turned = value.copy()
        turned[3:6] -= np.cross(self.V[:3], self.V[3:6])
        return self.see_acceleration(turned)

    def see_xi_dot(self, value):
        """ξ̇ = [μ̇; q̈]."""
        locked, shape = self.locked @ value[:6], self.shape @ value[6:]
        A, F = self.connection, self.force
        force = np.concatenate([F[:6], F[6:] - A.T @ F[:6]])
        size = [np.abs(self.locked) @ np.abs(value[:6]), np.abs(self.shape) @ np.abs(value[6:])]
        scale = np.concatenate(size) + np.abs(self.drift) + np.abs(force)
        return np.concatenate([locked, shape]) + self.drift, force, scale.max()
