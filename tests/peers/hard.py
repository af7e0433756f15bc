"""Hard cases beside Pinocchio (docs/hard.md): Λ_q as the Schur complement of `crba`, and `aba`, against 40 digits."""

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

mp.mp.dps = 40
SHAPES = 5
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
    links, names = [], []
    for link in robot.iter("link"):
        inertial, joint = link.find("inertial"), joint_of.get(link.get("name"))
        turned = [origin.get("rpy") for origin in link.iter("origin")] + [joint.find("origin").get("rpy")] * (joint is not None)
        assert not any(turned), "frames must not be turned"
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


def cross(a):
    return mp.matrix([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def shape_inertia(links, q):
    """Λ_q with 40 digits: the sum over links that defines the inertia, and its Schur complement."""
    n = len(links) - 1
    places, total = [], mp.zeros(6 + n)
    for k, link in enumerate(links):
        if k == 0:
            rotation, origin, moved = mp.eye(3), mp.zeros(3, 1), []
        else:
            base_rotation, base_origin, before = places[link.parent]
            axis, angle = cross(link.axis), mp.mpf(q[k - 1])
            rotation = base_rotation * (mp.eye(3) + mp.sin(angle) * axis + (1 - mp.cos(angle)) * axis * axis)
            origin = base_origin + base_rotation * mp.matrix(link.origin)
            moved = before + [(5 + k, base_rotation * mp.matrix(link.axis), origin)]
        places.append((rotation, origin, moved))
        com = origin + rotation * mp.matrix(link.com)
        inertia = rotation * mp.matrix(link.inertia) * rotation.T
        # Columns: number, angular velocity, velocity of the centre of mass.
        columns = [(a, mp.eye(3)[:, a], -cross(com) * mp.eye(3)[:, a]) for a in range(3)]
        columns += [(3 + a, mp.zeros(3, 1), mp.eye(3)[:, a]) for a in range(3)]
        columns += [(a, axis, cross(axis) * (com - start)) for a, axis, start in moved]
        momenta = [(inertia * w, link.mass * v) for _, w, v in columns]
        for a, w, v in columns:
            for (b, _, _), (spin, momentum) in zip(columns, momenta):
                if b <= a:
                    total[a, b] += (w.T * spin)[0] + (v.T * momentum)[0]
    for a in range(6 + n):
        for b in range(a):
            total[b, a] = total[a, b]
    connection = mp.lu_solve(total[:6, :6], total[:6, 6:])
    return total[6:, 6:] - total[6:, :6] * connection


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
CASES = {
    "1 base of 3.5 kg": (default("base", 3.5), 3.0),
    "1 base of 3.5e-12 kg": (default("base", 3.5e-12), 3.0),
    "2 tool of 1e-9 kg": (default("link_7", 1e-9), 3.0),
    "2 tip of 1e6 kg": (default("link_7", 1e6), 3.0),
    "3 straight chain, 50 links": (line([0.5, 0, 0], [(Y, THIN), (Z, THIN)] * 25), 0.0),
    "3 random chain, 50 links": (line([0.5, 0, 0], [(Y, THIN), (Z, THIN)] * 25), 3.0),
    "4 root frame 2^20 m away": (line([2.0**20, -(2.0**20), 2.0**19], [(Y, THIN), (Z, THIN)] * 3), 3.0),
    "12 needle of 1 mm": (line([0.5, 0, 0], [(Y, THIN), (Z, THIN), (X, 1e-3)]), 3.0),
    "12 needle of 10 μm": (line([0.5, 0, 0], [(Y, THIN), (Z, THIN), (X, 1e-5)]), 3.0),
}


def judged(urdf, size):
    """Worst errors over shapes: Λ_q and q̈ of frs, then of Pinocchio."""
    links, random = read(urdf), np.random.default_rng(1)
    n = len(links) - 1
    worst = np.zeros(4)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "robot.urdf"
        path.write_text(urdf)
        model = pin.buildModelFromUrdf(str(path), pin.JointModelFreeFlyer())
        model.gravity.setZero()
        data = model.createData()
        for _ in range(SHAPES if size else 1):
            q, tau = random.uniform(-size, size, n), random.uniform(-1, 1, n)
            state = json.dumps({"q": list(q), "tau": list(tau)})
            (answer,) = frs.evaluate(path, [state], keys=["shape_inertia", "xi_dot"])
            ours = np.array(answer["shape_inertia"]), np.array(answer["xi_dot"][6:])

            free = np.concatenate([pin.neutral(model)[:7], q])
            mass = np.triu(pin.crba(model, data, free))
            mass += np.triu(mass, 1).T
            schur = mass[6:, 6:] - mass[6:, :6] @ np.linalg.solve(mass[:6, :6], mass[:6, 6:])
            force = np.concatenate([np.zeros(6), tau])
            theirs = schur, np.array(pin.aba(model, data, free, np.zeros(6 + n), force))[6:]

            truth = shape_inertia(links, q)
            acceleration = mp.lu_solve(truth, mp.matrix(tau))
            energy = (acceleration.T * mp.matrix(tau))[0]
            for place, (inertia, rates) in enumerate([ours, theirs]):
                off = max(abs(mp.mpf(inertia[a, b]) - truth[a, b]) / mp.sqrt(truth[a, a] * truth[b, b])
                          for a in range(n) for b in range(n))
                apart = mp.matrix(rates) - acceleration
                late = mp.sqrt((apart.T * truth * apart)[0] / energy)
                worst[2 * place:2 * place + 2] = np.fmax(worst[2 * place:2 * place + 2], [float(off), float(late)])
    return worst


def main():
    print(f"{'case':32}{'frs Λ_q':>12}{'frs q̈':>12}{'crba Λ_q':>12}{'aba q̈':>12}")
    for name, (urdf, size) in CASES.items():
        print(f"{name:32}" + "".join(f"{error:12.1e}" for error in judged(urdf, size)), flush=True)


if __name__ == "__main__":
    if "FRS_BIN" not in os.environ:
        sys.exit("peers: start this through tests/peers/run hard")
    main()
