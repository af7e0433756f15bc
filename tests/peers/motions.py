"""The motion of a problem, sampled in time, by three programs: `frs simulate`, Pinocchio under DOP853, MuJoCo."""

import csv
import os
import re
import subprocess
from dataclasses import dataclass
from xml.etree import ElementTree

import mujoco
import numpy as np
import pinocchio as pin
from scipy.integrate import solve_ivp

from frs import Broken


@dataclass
class Motion:
    """One row a sample: base link in the world, shape, and the momentum about the world's origin, angular part first."""

    time: np.ndarray
    position: np.ndarray
    rotation: np.ndarray  # 3×3 each
    q: np.ndarray
    qd: np.ndarray
    momentum: np.ndarray


QUANTITIES = {"position": "m", "rotation": "rad", "q": "rad", "qd": "rad/s", "momentum": "kg·m²/s"}


def angle(relative):
    """Angle of each rotation; its sine alone is exact for small ones, its cosine tells the large ones."""
    axis = np.stack([relative[:, 2, 1] - relative[:, 1, 2], relative[:, 0, 2] - relative[:, 2, 0],
                     relative[:, 1, 0] - relative[:, 0, 1]], axis=1)
    return np.arctan2(np.linalg.norm(axis, axis=1) / 2, (np.trace(relative, axis1=1, axis2=2) - 1) / 2)


def differences(one, other):
    """The largest of each quantity over all samples."""
    found = {}
    for key in QUANTITIES:
        a, b = getattr(one, key), getattr(other, key)
        gap = angle(np.swapaxes(a, 1, 2) @ b) if key == "rotation" else np.abs(a - b)
        found[key] = float(gap.max()) if np.isfinite(gap).all() else np.inf
    return found


def ours(problem, accuracy, folder, moved=0.0, seed=0):
    """`frs simulate` on the scene, with another accuracy, from a shape that is moved by random numbers up to `moved`."""
    text = problem.path.read_text()
    shape = problem.x[7:] + np.random.default_rng(seed).uniform(-moved, moved, problem.robot.n)
    for key, value in ("robot", f'"{problem.urdf}"'), ("accuracy", f"{accuracy:g}"), ("q", [float(x) for x in shape]):
        text, count = re.subn(rf"(?m)^{key}\s*=.*$", lambda _: f"{key} = {value}", text)
        if count != 1:
            raise Broken(f"{problem.path.name}: expected one line `{key} = …`, found {count}")
    scene, out = folder / f"{problem.path.stem}_{accuracy:g}.toml", folder / f"{problem.path.stem}_{accuracy:g}"
    scene.write_text(text)
    done = subprocess.run([os.environ["FRS_BIN"], "simulate", scene, "--out", out], capture_output=True, text=True)
    if done.returncode != 0:
        raise Broken(f"frs simulate {problem.path.name} at accuracy {accuracy:g}: {done.stderr.strip() or 'no message'}")
    with open(out / "trajectory.csv", newline="") as file:
        header, *rows = csv.reader(file)
    table = np.array(rows, dtype=float)

    def take(*names):
        return table[:, [header.index(name) for name in names]]

    names = problem.robot.names
    rotation = take(*[f"pose.r_{row}{column}" for row in "xyz" for column in "xyz"]).reshape(-1, 3, 3)
    momentum = [f"spatial_momentum.{part}_{axis}" for part in ("moment", "force") for axis in "xyz"]
    return Motion(take("time")[:, 0], take("pose.x", "pose.y", "pose.z"), rotation, take(*[f"q.{name}" for name in names]),
                  take(*[f"qd.{name}" for name in names]), take(*momentum))


def pinocchio(problem, times, accuracy):
    """Articulated bodies in free flight under DOP853, `rtol = accuracy`, `atol` a hundredth of it.

    The state is (x, v) with the quaternion as four plain numbers of rate ½ h ω, which keeps their norm; every evaluation
    and every sample normalises it.
    """
    model, data = problem.robot.model, problem.robot.data

    def split(state):
        x = state[: model.nq].copy()
        x[3:7] /= np.linalg.norm(x[3:7])
        return x, state[model.nq :]

    def rate(_, state):
        x, v = split(state)
        q, qd = x[7:], v[6:]
        acceleration = pin.aba(model, data, x, v, np.r_[np.zeros(6), problem.torque(q, qd)])
        turn = pin.Quaternion(x[3:7])
        spin = (turn * pin.Quaternion(np.r_[v[3:6], 0.0])).coeffs() * (np.linalg.norm(state[3:7]) / 2)
        return np.r_[turn.matrix() @ v[:3], spin, qd, acceleration]

    done = solve_ivp(rate, (0.0, times[-1]), np.r_[problem.x, problem.v], method="DOP853", t_eval=times, rtol=accuracy,
                     atol=accuracy / 100)
    if not done.success:
        raise Broken(f"DOP853 on {problem.path.name}: {done.message}")
    states = [split(state) for state in done.y.T]
    x, v = (np.array(part) for part in zip(*states))
    rotation = np.array([pin.Quaternion(row).matrix() for row in x[:, 3:7]])
    return Motion(times, x[:, :3], rotation, x[:, 7:], v[:, 6:], np.array([problem.momentum(*state) for state in states]))


def mujoco_model(problem):
    """The same URDF hanging on a floating joint, with the scene's springs and friction; RK4 and nothing else."""
    root = ElementTree.parse(problem.urdf).getroot()
    for link in root.findall("link"):
        for shape in link.findall("visual") + link.findall("collision"):
            link.remove(shape)
    children = {joint.find("child").get("link") for joint in root.findall("joint")}
    (base,) = {link.get("name") for link in root.findall("link")} - children
    ElementTree.SubElement(root, "link", name="world")
    joint = ElementTree.SubElement(root, "joint", name="floating_base", type="floating")
    ElementTree.SubElement(joint, "parent", link="world")
    ElementTree.SubElement(joint, "child", link=base)
    ElementTree.SubElement(ElementTree.SubElement(root, "mujoco"), "compiler", fusestatic="false")

    model = mujoco.MjModel.from_xml_string(ElementTree.tostring(root, "unicode"))
    model.opt.gravity[:] = 0
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_LIMIT
    model.dof_armature[:] = model.dof_frictionloss[:] = model.dof_damping[:] = 0
    joints = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in problem.robot.names]
    q, qd = model.jnt_qposadr[joints], model.jnt_dofadr[joints]
    model.jnt_stiffness[joints], model.qpos_spring[q], model.dof_damping[qd] = problem.stiffness, problem.rest, problem.viscous
    return model, q, qd


def mujoco_rk4(problem, times, substeps):
    """RK4 with `substeps` equal steps between samples, which must be equally far apart.

    MuJoCo's base has its linear velocity in world axes, its angular velocity in its own, its quaternion real part first.
    """
    interval = times[1] - times[0]
    if np.abs(np.diff(times) - interval).max() > 1e-12:  # s; rounding of times of 10 s
        raise Broken(f"{problem.path.name}: its duration is not a whole number of samples, which fixed steps need")
    model, q, qd = mujoco_model(problem)
    model.opt.timestep = interval / substeps
    data = mujoco.MjData(model)
    data.qpos[:3], data.qpos[3:7], data.qpos[q] = problem.x[:3], problem.x[[6, 3, 4, 5]], problem.x[7:]
    data.qvel[:3] = pin.Quaternion(problem.x[3:7]).matrix() @ problem.v[:3]
    data.qvel[3:6], data.qvel[qd] = problem.v[3:6], problem.v[6:]

    mass, rotation, samples = model.body_mass.sum(), np.zeros(9), []
    for sample in range(len(times)):
        if sample:
            mujoco.mj_step(model, data, nstep=substeps)
        mujoco.mj_forward(model, data)
        mujoco.mj_subtreeVel(model, data)
        mujoco.mju_quat2Mat(rotation, data.qpos[3:7])
        force = mass * data.subtree_linvel[0]
        moment = data.subtree_angmom[0] + np.cross(data.subtree_com[0], force)
        samples.append((data.qpos[:3].copy(), rotation.reshape(3, 3).copy(), data.qpos[q], data.qvel[qd], np.r_[moment, force]))
    return Motion(times, *(np.array(part) for part in zip(*samples)))


def extrapolated(coarse, fine, order):
    """The motion without the error of order `order` (Richardson), from steps of one length and of half of it.

    Rotations are extrapolated entry by entry: they leave SO(3) by less than the square of the difference.
    """
    weight = 1 / (2**order - 1)
    parts = {key: (1 + weight) * getattr(fine, key) - weight * getattr(coarse, key) for key in QUANTITIES}
    return Motion(fine.time, **parts)
