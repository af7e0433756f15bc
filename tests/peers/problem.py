"""A scene file as numbers, for programs that are not `frs`: robot, start, linear torques.

The start is computed here, with Pinocchio, from what the file says; nothing is taken from what `frs` makes of it.
"""

import tomllib
from pathlib import Path

import numpy as np
import pinocchio as pin

from reference import angular_first
from robot import Robot

# What is understood; another key would be another motion, so it is refused.
KEYS = {
    "": {"robot", "duration", "accuracy", "samples_per_second", "start", "spring", "friction"},
    "start": {"pose", "q", "qd", "base_twist", "momentum"},
    "start.pose": {"position", "rpy"},
    "spring": {"stiffness", "rest"},
    "friction": {"viscous"},
}


class Unreadable(Exception):
    """The scene says something that this comparison does not understand."""


def section(parent, key, name):
    """The table `key`, all of its keys known."""
    table = parent.get(key, {}) if key else parent
    if not isinstance(table, dict):
        raise Unreadable(f"{name}: expected one table")
    if unknown := set(table) - KEYS[name]:
        raise Unreadable(f"{name or 'scene'}: {', '.join(sorted(unknown))} not understood; "
                         f"expected {', '.join(sorted(KEYS[name]))}")
    return table


class Problem:
    """`x = (p, quaternion, q)` and `v = (v₁, ω₁, q̇)` in Pinocchio's order, twist of the base in its own frame."""

    def __init__(self, path):
        self.path = Path(path)
        scene = section(tomllib.loads(self.path.read_text()), "", "")
        self.urdf = (self.path.parent / scene["robot"]).resolve()
        self.robot = Robot(self.urdf)
        self.duration = float(scene["duration"])
        if self.robot.has_mimic or self.robot.model.nq != 7 + self.robot.n:
            raise Unreadable(f"{self.urdf.name}: mimic and continuous joints are not understood")

        spring, friction = section(scene, "spring", "spring"), section(scene, "friction", "friction")
        self.stiffness = self.each(spring.get("stiffness", 0.0))
        self.rest = self.each(spring.get("rest", 0.0))
        self.viscous = self.each(friction.get("viscous", 0.0))
        start = section(scene, "start", "start")
        pose = section(start, "pose", "start.pose")
        quaternion = pin.Quaternion(pin.rpy.rpyToMatrix(np.array(pose.get("rpy", [0, 0, 0]), dtype=float)))
        self.x = np.r_[pose.get("position", [0, 0, 0]), quaternion.coeffs(), self.each(start.get("q", 0.0))]
        self.v = self.velocity(start, self.each(start.get("qd", 0.0)))

    def each(self, said):
        """One number for all coordinates, a list, or numbers by name (the others are 0)."""
        if isinstance(said, dict):
            if unknown := set(said) - set(self.robot.names):
                raise Unreadable(f"{self.urdf.name} has no coordinates {', '.join(sorted(unknown))}")
            said = [said.get(name, 0.0) for name in self.robot.names]
        return np.broadcast_to(np.array(said, dtype=float), self.robot.n).copy()

    def velocity(self, start, qd):
        """v from the base's twist, or from the momentum: h = A(x) v is solved for the twist."""
        if "momentum" not in start:
            return np.r_[np.array(start.get("base_twist", [0.0] * 6), dtype=float)[angular_first(6)], qd]
        matrix = self.momentum_matrix(self.x)
        base = np.linalg.solve(matrix[:, :6], np.array(start["momentum"], dtype=float) - matrix[:, 6:] @ qd)
        return np.r_[base, qd]

    def momentum_matrix(self, x):
        """A of h = A v, [moment; force] about the world's origin in world axes."""
        model, data = self.robot.model, self.robot.data
        centroidal = pin.computeCentroidalMap(model, data, x)[angular_first(6)]
        centroidal[:3] += pin.skew(pin.centerOfMass(model, data, x)) @ centroidal[3:]
        return centroidal

    def momentum(self, x, v):
        """h."""
        return self.momentum_matrix(x) @ v

    def torque(self, q, qd):
        """Springs and friction."""
        return -self.stiffness * (q - self.rest) - self.viscous * qd
