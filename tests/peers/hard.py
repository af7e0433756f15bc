"""Hard cases beside Pinocchio (docs/hard.md): Λ_q as the Schur complement of `crba`, and `aba`, against 60 digits."""

import json
import os
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from pathlib import Path

try:
    import mpmath as mp
    import numpy as np
    import pinocchio as pin

    import frs
except ImportError as missing:
    print(f"peers: {missing}; start this through tests/peers/run, which installs what it needs", file=sys.stderr)
    sys.exit(2)

mp.mp.dps = 60
SHAPES = 5
# Of the terms that make an entry of Λ_q, each about as large as the entry times its lever ratio.
ROUNDINGS = 3.0
DEFAULT = Path(__file__).parents[2] / "robots" / "lwr_satellite.urdf"


@dataclass
class Link:
    """A link with its joint, all axes parallel at q = 0."""

    parent: int  # -1 for the root link
    origin: list  # of the joint, in the parent's frame
    axis: list
    mass: float
    com: list
    inertia: list  # rows


def numbers(element, key, default):
    return [float(x) for x in (element.get(key) if element is not None else default).split()]


def read(urdf):
    """Links from the root outwards; frames are not turned."""
    robot = ElementTree.fromstring(urdf)
    joint_of = {joint.find("child").get("link"): joint for joint in robot.iter("joint")}
    assert not any(float(x) for origin in robot.iter("origin") for x in origin.get("rpy", "").split()), "frames must not be turned"
    links, names = [], []
    for link in robot.iter("link"):
        inertial, joint = link.find("inertial"), joint_of.get(link.get("name"))
        i = {key: float(value) for key, value in inertial.find("inertia").attrib.items()}
        rows = [[i["i" + "".join(sorted(a + b))] for b in "xyz"] for a in "xyz"]
        at_rest = joint is None
        links.append(Link(
            parent=-1 if at_rest else names.index(joint.find("parent").get("link")),
            origin=[0.0] * 3 if at_rest else numbers(joint.find("origin"), "xyz", "0 0 0"),
            axis=[0.0] * 3 if at_rest else numbers(joint.find("axis"), "xyz", "1 0 0"),
            mass=float(inertial.find("mass").get("value")),
            com=numbers(inertial.find("origin"), "xyz", "0 0 0"),
            inertia=rows,
        ))
        names.append(link.get("name"))
    return links


exact = np.vectorize(mp.mpf, otypes=[object])


def cross(a):
    return exact([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def shape_inertia(links, q):
    """Λ_q with 60 digits: the sum over links that defines the inertia, and its Schur complement."""
    n, one = len(links) - 1, exact(np.eye(3))
    total, places = exact(np.zeros((6 + n, 6 + n))), []
    for k, link in enumerate(links):
        rotation, origin, hinges = places[link.parent] if k else (one, exact(np.zeros(3)), [])
        if k:
            axis, angle = exact(link.axis), mp.mpf(q[k - 1])
            origin = origin + rotation @ exact(link.origin)
            hinges = hinges + [(5 + k, rotation @ axis, origin)]
            rotation = rotation @ (one + mp.sin(angle) * cross(axis) + (1 - mp.cos(angle)) * cross(axis) @ cross(axis))
        places.append((rotation, origin, hinges))
        com = origin + rotation @ exact(link.com)
        # Columns: angular velocity, velocity of the centre of mass.
        spin, slide = exact(np.zeros((3, 6 + n))), exact(np.zeros((3, 6 + n)))
        spin[:, :3], slide[:, :3], slide[:, 3:6] = one, -cross(com), one
        for column, axis, start in hinges:
            spin[:, column], slide[:, column] = axis, cross(axis) @ (com - start)
        total = total + spin.T @ (rotation @ exact(link.inertia) @ rotation.T) @ spin + link.mass * slide.T @ slide
    inverse = np.array(mp.inverse(mp.matrix(total[:6, :6].tolist())).tolist(), dtype=object)
    return total[6:, 6:] - total[6:, :6] @ inverse @ total[:6, 6:]


def line(base_com, links):
    """A base and bars of 1 kg, 1 m one after the other along x: (axis, thickness) each. `base_com`: where the base's masses are in its frame."""
    xyz = lambda v: " ".join(repr(float(x)) for x in v)
    inertial = lambda com, t: (
        f'<inertial><origin xyz="{xyz(com)}"/><mass value="1"/><inertia ixx="{t * t / 6!r}" iyy="{(1 + t * t) / 12!r}" '
        f'izz="{(1 + t * t) / 12!r}" ixy="0" ixz="0" iyz="0"/></inertial>')
    text = ['<robot name="line">', f'<link name="l0">{inertial(base_com, 0.1)}</link>']
    start = np.array(base_com) + [0.5, 0, 0]
    for k, (axis, thickness) in enumerate(links, 1):
        text.append(f'<link name="l{k}">{inertial([0.5, 0, 0], thickness)}</link>')
        text.append(f'<joint name="j{k}" type="revolute"><parent link="l{k - 1}"/><child link="l{k}"/><origin xyz="{xyz(start)}"/>'
                    f'<axis xyz="{xyz(axis)}"/><limit lower="-9" upper="9" effort="1" velocity="1"/></joint>')
        start = np.array([1.0, 0, 0])
    return "\n".join(text + ["</robot>"])


def default(link, mass):
    """The default robot with another mass of a link, its inertia in proportion."""
    robot = ElementTree.parse(DEFAULT).getroot()
    inertial = next(l for l in robot.iter("link") if l.get("name") == link).find("inertial")
    ratio = mass / float(inertial.find("mass").get("value"))
    inertial.find("mass").set("value", repr(mass))
    for key, value in inertial.find("inertia").attrib.items():
        inertial.find("inertia").set(key, repr(float(value) * ratio))
    return ElementTree.tostring(robot, encoding="unicode")


X, Y, Z = np.eye(3)
THIN = 0.1
CHAIN = [(Y, THIN), (Z, THIN)] * 25
# By how much the terms of Λ_q exceed what is left, by lever arms: (0.92 m / 2.04 cm)² of the default robot's last link, and less
# elsewhere; of the needles, what turns at right angles to the needle over what turns about it.
LEVER = 2.1e3
CASES = {
    "1 base of 3.5 kg": (default("base", 3.5), 3.0, LEVER),
    "1 base of 3.5e-6 kg": (default("base", 3.5e-6), 3.0, LEVER),
    "1 base of 3.5e-12 kg": (default("base", 3.5e-12), 3.0, LEVER),
    "1 base of 3.5e12 kg": (default("base", 3.5e12), 3.0, LEVER),
    "2 tool of 1e-9 kg": (default("link_7", 1e-9), 3.0, LEVER),
    "2 tip of 1e6 kg": (default("link_7", 1e6), 3.0, LEVER),
    "3 straight chain, 50 links": (line([0.5, 0, 0], CHAIN), 0.0, LEVER),
    "3 random chain, 50 links": (line([0.5, 0, 0], CHAIN), 3.0, LEVER),
    "4 root frame 2^20 m away": (line([2.0**20, -(2.0**20), 2.0**19], CHAIN[:6]), 3.0, LEVER),
    "12 needle of 1 mm": (line([0.5, 0, 0], [*CHAIN[:2], (X, 1e-3)]), 3.0, 10 / 1e-3**2),
    "12 needle of 10 μm": (line([0.5, 0, 0], [*CHAIN[:2], (X, 1e-5)]), 3.0, 10 / 1e-5**2),
}
ERRORS = ["frs Λ_q", "frs q̈", "crba Λ_q", "aba q̈"]


def judged(urdf, size):
    """Worst errors over shapes, in the order of `ERRORS`, and the worst condition of Λ_q in the scales of its coordinates."""
    links, random = read(urdf), np.random.default_rng(1)
    n = len(links) - 1
    worst, condition = np.zeros(len(ERRORS)), 1.0
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "robot.urdf"
        path.write_text(urdf)
        model = pin.buildModelFromUrdf(str(path), pin.JointModelFreeFlyer())
        model.gravity.setZero()
        data = model.createData()
        for _ in range(SHAPES if n < 10 else 1):
            q, tau = random.uniform(-size, size, n), random.uniform(-1, 1, n)
            state = json.dumps({"q": list(q), "tau": list(tau)})
            (answer,) = frs.evaluate(path, [state], keys=["shape_inertia", "xi_dot"])
            free = np.concatenate([pin.neutral(model)[:7], q])
            mass = np.triu(pin.crba(model, data, free))
            mass += np.triu(mass, 1).T
            inertias = answer["shape_inertia"], mass[6:, 6:] - mass[6:, :6] @ np.linalg.solve(mass[:6, :6], mass[:6, 6:])
            force = np.concatenate([np.zeros(6), tau])
            accelerations = answer["xi_dot"][6:], pin.aba(model, data, free, np.zeros(6 + n), force)[6:]

            truth = shape_inertia(links, q)
            own = np.sqrt(np.diag(truth))
            acceleration = np.array(list(mp.lu_solve(mp.matrix(truth.tolist()), mp.matrix(tau))), dtype=object)
            off = [np.max(np.abs(exact(inertia) - truth) / np.outer(own, own)) for inertia in inertias]
            apart = [exact(rates) - acceleration for rates in accelerations]
            # By the kinetic energy of the difference.
            late = [mp.sqrt((rates @ truth @ rates) / (acceleration @ tau)) for rates in apart]
            worst = np.fmax(worst, np.array([off[0], late[0], off[1], late[1]], dtype=float))
            condition = max(condition, np.linalg.cond((truth / np.outer(own, own)).astype(float)))
    return worst, condition


def main():
    print(f"{'case':28}" + "".join(f"{title:>12}" for title in [*ERRORS, "allowed Λ_q", "allowed q̈"]))
    kept = True
    for name, (urdf, size, lever) in CASES.items():
        errors, condition = judged(urdf, size)
        allowed = ROUNDINGS * lever * np.finfo(float).eps
        bounds = np.array([allowed, allowed * condition])
        print(f"{name:28}" + "".join(f"{number:12.1e}" for number in [*errors, *bounds]), flush=True)
        kept &= bool(np.all(errors[:2] <= bounds))
    if not kept:
        print("peers: frs errs by more than its lever arms allow", file=sys.stderr)
    return 0 if kept else 1


if __name__ == "__main__":
    if "FRS_BIN" not in os.environ:
        sys.exit("peers: start this through tests/peers/run hard")
    sys.exit(main())
