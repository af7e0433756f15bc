"""One URDF as a Pinocchio model, seen in the coordinates of `frs`.

Pinocchio's model (the *tree*) has every movable joint; `frs` eliminates mimic joints. The two are related by
`q_tree = G q + offset` with a constant `G`, so `M = Gᵀ M_tree G`, `C = Gᵀ C_tree G`, `bias = Gᵀ bias_tree` are exact.
(Pinocchio's own mimic joints are not used: its articulated-body pass does not take them, and its loader refuses them in
some of these robots.)
"""

import json
import xml.etree.ElementTree as ElementTree
import zlib
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pinocchio as pin

RATE = 2.0  # bound of the random twists and joint rates, rad/s or m/s
SLIDE = 0.5  # travel of a prismatic joint without limits, m


class Unusable(Exception):
    """This robot cannot be compared; the message says why."""


def planar_as_three_joints(root):
    """Replaces each planar joint by its three coordinates: x, y, then the turn about the normal.

    Pinocchio's planar joint has body-fixed rates, so the constant `G` above could not describe it.
    """
    for joint in root.findall("joint"):
        if joint.get("type") != "planar":
            continue
        name, child = joint.get("name"), joint.find("child").get("link")
        axis = joint.find("axis")
        normal = [1.0, 0.0, 0.0] if axis is None else [float(a) for a in axis.get("xyz").split()]
        if normal[:2] != [0.0, 0.0]:
            raise Unusable(f"planar joint {name} has normal {normal}; only z leaves no choice of x and y")
        root.remove(joint)
        parent, origin = joint.find("parent").get("link"), joint.find("origin")
        steps = [("x", "prismatic", "1 0 0"), ("y", "prismatic", "0 1 0"), ("yaw", "continuous", "0 0 1")]
        for suffix, kind, direction in steps:
            last = suffix == "yaw"
            step = ElementTree.SubElement(root, "joint", name=f"{name}_{suffix}", type=kind)
            if suffix == "x" and origin is not None:
                step.append(origin)
            ElementTree.SubElement(step, "parent", link=parent)
            parent = child if last else f"{name}_{suffix}_carrier"
            ElementTree.SubElement(step, "child", link=parent)
            ElementTree.SubElement(step, "axis", xyz=direction)
            if not last:
                ElementTree.SubElement(step, "limit", lower=str(-SLIDE), upper=str(SLIDE), effort="0", velocity="0")
                ElementTree.SubElement(root, "link", name=parent)


def mimics(root):
    """Each follower's leader, multiplier and offset, as written (a leader may itself follow)."""
    movable = {j.get("name") for j in root.findall("joint") if j.get("type") != "fixed"}
    found = {}
    for joint in root.findall("joint"):
        mimic = joint.find("mimic")
        if mimic is None or joint.get("name") not in movable:
            continue
        leader = mimic.get("joint")
        if leader not in movable:
            raise Unusable(f"joint {joint.get('name')} mimics {leader}, which is not a movable joint")
        found[joint.get("name")] = (leader, float(mimic.get("multiplier", 1)), float(mimic.get("offset", 0)))
    return found


def resolve(name, followers, seen=()):
    """The coordinate that moves joint `name`, with the multiplier and offset of the whole chain."""
    if name in seen:
        raise Unusable(f"joint {name} mimics itself, through {' -> '.join(seen)}")
    if name not in followers:
        return name, 1.0, 0.0
    leader, multiplier, offset = followers[name]
    root, m, o = resolve(leader, followers, (*seen, name))
    return root, multiplier * m, multiplier * o + offset


@dataclass
class State:
    """One random state; `tau` and `wrench` are the applied torques and base wrench, angular part first."""

    q: np.ndarray
    qd: np.ndarray
    twist: np.ndarray
    wrench: np.ndarray
    tau: np.ndarray

    def line(self, names):
        """The line that `frs eval` reads."""
        named = lambda values: dict(zip(names, values.tolist()))
        return json.dumps({
            "q": named(self.q), "qd": named(self.qd), "tau": named(self.tau),
            "base_twist": self.twist.tolist(), "base_wrench": self.wrench.tolist(),
        })


class Robot:
    """`names`: the n coordinates. `model`: the tree on a free-flyer. `G`, `offset`: tree = G q + offset."""

    def __init__(self, path):
        root = ElementTree.parse(path).getroot()
        planar_as_three_joints(root)
        try:
            model = pin.buildModelFromXML(ElementTree.tostring(root, "unicode"), pin.JointModelFreeFlyer())
        except Exception as error:
            raise Unusable(f"Pinocchio does not load it: {str(error).strip().splitlines()[0]}") from None
        followers = mimics(root)
        model.gravity = pin.Motion.Zero()

        self.path, self.model, self.data = Path(path), model, model.createData()
        self.joints = [(model.names[j], model.joints[j]) for j in range(2, model.njoints)]
        self.names = [name for name, _ in self.joints if name not in followers]
        self.G = np.zeros((model.nv - 6, len(self.names)))
        self.offset = np.zeros(model.nv - 6)
        for name, joint in self.joints:
            if joint.nv != 1:
                raise Unusable(f"joint {name} is a {joint.shortname()}")
            leader, multiplier, offset = resolve(name, followers)
            self.G[joint.idx_v - 6, self.names.index(leader)] = multiplier
            self.offset[joint.idx_v - 6] = offset

    @property
    def n(self):
        return len(self.names)

    @property
    def has_mimic(self):
        return self.n != self.model.nv - 6

    def configuration(self, q):
        """Pinocchio's configuration: base at the origin, (cos, sin) for a continuous joint."""
        angles = self.G @ q + self.offset
        out = pin.neutral(self.model)
        for _, joint in self.joints:
            angle = angles[joint.idx_v - 6]
            out[joint.idx_q : joint.idx_q + joint.nq] = angle if joint.nq == 1 else (np.cos(angle), np.sin(angle))
        return out

    def limits(self):
        """Range of each coordinate: the URDF's where it has one, else a full turn or `SLIDE`."""
        ranges = dict()
        for name, joint in self.joints:
            reach = SLIDE if joint.shortname().startswith("JointModelP") else np.pi
            low, high = -reach, reach
            if joint.nq == 1:
                written = self.model.lowerPositionLimit[joint.idx_q], self.model.upperPositionLimit[joint.idx_q]
                if written[0] < written[1]:
                    low, high = max(written[0], -2 * reach), min(written[1], 2 * reach)
            ranges[name] = (low, high)
        return np.array([ranges[name] for name in self.names]).reshape(self.n, 2)

    def states(self, count):
        """`count` random states, the same on every machine: the seed is the robot's own file name.

        A torque is drawn relative to the joint's own inertia, so that a fingertip is not torn off by a hip's torque.
        """
        random = np.random.default_rng(zlib.crc32(self.path.name.encode()))
        low, high = self.limits().T
        for _ in range(count):
            q = random.uniform(low, high)
            inertia = np.diag(pin.crba(self.model, self.data, self.configuration(q)))
            inertia = np.concatenate([inertia[3:6], inertia[:3], (self.G**2).T @ inertia[6:]])
            force = 10 * inertia * random.uniform(-1, 1, 6 + self.n)
            rates = RATE * random.uniform(-1, 1, 6 + self.n)
            yield State(q, rates[6:], rates[:6], force[:6], force[6:])
