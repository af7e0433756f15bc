"""A robot and its states for MuJoCo: write(FOLDER, ROBOT, QUESTIONS) leaves NAME.mjb and NAME.mujoco."""

from types import SimpleNamespace
from xml.etree import ElementTree

import mujoco
import numpy as np

from describe import words
from motions import mujoco_model


def renamed(folder, path):
    """A copy without a link called as MuJoCo calls the world."""
    root = ElementTree.parse(path).getroot()
    for element in root.iter():
        for key in ("name", "link"):
            if element.get(key) == "world":
                element.set(key, "world_link")
    copy = folder / f"{path.stem}.mujoco.urdf"
    copy.write_text(ElementTree.tostring(root, "unicode"))
    return copy


def write(folder, robot, questions):
    """Returns where MuJoCo has our velocities. Nothing but bodies and joints acts: no contact, limit, friction or follower."""
    names = [name for name, _ in robot.joints]
    still = SimpleNamespace(robot=SimpleNamespace(names=names), urdf=renamed(folder, robot.path), stiffness=0, rest=0, viscous=0)
    model, q, qd = mujoco_model(still)
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_EQUALITY
    order = np.concatenate([[3, 4, 5, 0, 1, 2], qd])
    lines = []
    for question in questions:
        qpos, velocity, force = np.zeros(model.nq), np.zeros(model.nv), np.zeros(model.nv)
        qpos[3] = 1.0  # the base stands in the world's origin, with the world's axes
        qpos[q], velocity[order], force[order] = question.angles, question.velocity, question.force
        lines.append(words(qpos, velocity, force))
    (folder / f"{robot.path.stem}.mujoco").write_text("\n".join(lines) + "\n")
    mujoco.mj_saveModel(model, str(folder / f"{robot.path.stem}.mjb"))
    return order
