"""Writes a robot and its states as plain numbers for pinocchio.cpp: describe.py FOLDER URDF...

Pinocchio's own URDF reader is compiled code of the wheel, built for another processor; without it the timing program
needs headers alone, and every algorithm in it is compiled for this machine. Each line is a list of words:

    robot NAME NQ NV JOINTS
    KIND PARENT AXIS(3) ROTATION(9, by rows) TRANSLATION(3) MASS CENTRE(3) INERTIA(9, by rows)     a line a joint
    states COUNT
    Q(nq) V(nv) TAU(nv)                                                                            a line a state
    expected C·V(nv) ACCELERATION(nv)                                                              of the first state
"""

import sys
from pathlib import Path

import numpy as np
import pinocchio as pin

sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "peers"))
from reference import angular_first  # noqa: E402
from robot import Robot  # noqa: E402

STATES = 128


def words(*parts):
    return " ".join(repr(float(x)) for part in parts for x in np.ravel(part))


def description(robot):
    model, data = robot.model, robot.data
    order = angular_first(model.nv)
    yield f"robot {robot.path.stem} {model.nq} {model.nv} {model.njoints - 1}"
    for j in range(1, model.njoints):
        joint, placement, body = model.joints[j], model.jointPlacements[j], model.inertias[j]
        axis = getattr(joint.extract(), "axis", np.zeros(3))
        numbers = words(axis, placement.rotation, placement.translation, body.mass, body.lever, body.inertia)
        yield f"{joint.shortname()} {model.parents[j]} {numbers}"
    yield f"states {STATES}"
    for number, state in enumerate(robot.states(STATES)):
        q = robot.configuration(state.q)
        v = np.concatenate([state.twist, robot.G @ state.qd])[order]
        tau = np.concatenate([state.wrench, robot.G @ state.tau])[order]
        if number == 0:
            bias = pin.nonLinearEffects(model, data, q, v).copy()
            acceleration = pin.aba(model, data, q, v, tau).copy()
        yield words(q, v, tau)
    yield f"expected {words(bias, acceleration)}"


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for path in map(Path, sys.argv[2:]):
        (folder / f"{path.stem}.txt").write_text("\n".join(description(Robot(path))) + "\n")
