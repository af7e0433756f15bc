"""One scene by MuJoCo's integrators and by Pinocchio's ABA under RK4: a request as JSON in, a line of JSON out for each motion.

A program that is not installed, or does not take the robot, is told in a line {"left_out": …}.
"""

import json
import statistics
import sys
import time
from xml.etree import ElementTree

try:
    import numpy as np
except ImportError:
    np = None
try:
    import pinocchio as pin
except ImportError:
    pin = None
try:
    import mujoco
except ImportError:
    mujoco = None

FEWEST = 20  # steps of the coarsest motion
LONGEST = 2.0  # s; after a motion that took longer there is no finer one


def tell(**line):
    print(json.dumps(line), flush=True)


class Rigid:
    """The robot in Pinocchio: x = (p, quaternion, q), v = (v, ω, q̇), the base's twist in its own axes."""

    def __init__(self, asked):
        self.model = pin.buildModelFromXML(asked["urdf"], pin.JointModelFreeFlyer())
        if {self.model.names[k] for k in range(2, self.model.njoints)} != set(asked["joints"]):
            raise ValueError("its movable joints are not the robot's coordinates")
        if self.model.nq != 7 + len(asked["joints"]):
            raise ValueError("it takes a continuous joint as a point on a circle")
        self.order = [self.model.joints[self.model.getJointId(name)].idx_v - 6 for name in asked["joints"]]
        self.model.gravity.setZero()
        self.weightless = self.model.createData()
        self.falling = self.model.copy()
        self.falling.gravity.linear[:] = asked["gravity"]
        self.data = self.falling.createData()

    def joints(self, values):
        """Numbers of coordinates, in Pinocchio's order."""
        out = np.zeros(len(self.order))
        out[self.order] = values
        return out

    def holding(self, x, v):
        """The torque that keeps the shape of a robot that turns with the same momentum and q̇ = 0."""
        mass = np.triu(pin.crba(self.model, self.weightless, x))
        mass += np.triu(mass, 1).T
        connection = np.linalg.solve(mass[:6, :6], mass[:6, 6:])
        mu = np.r_[v[:6] + connection @ v[6:], np.zeros(len(v) - 6)]
        bias = pin.rnea(self.model, self.weightless, x, mu, np.zeros(len(v)))
        return bias[6:] - connection.T @ bias[:6]


class Scene:
    """What acts: linear torques in the joints, and between knots constant torques and wrenches on the base."""

    def __init__(self, asked):
        self.asked, self.piece = asked, asked["pieces"][0]
        self.rigid = None  # until Pinocchio has taken it
        self.start = np.array(asked["position"]), np.array(asked["rotation"])

    def enter(self, moment):
        """The piece that holds from here on."""
        self.piece = next(piece for piece in self.asked["pieces"] if piece["until"] > moment)

    def base_wrench(self, rotation):
        """Moment and force in the base's axes."""
        own, world = (np.array(self.piece[key]) for key in ("base", "world"))
        return own[:3] + rotation.T @ world[:3], own[3:] + rotation.T @ world[3:]

    def stops(self):
        """Where steps end: knots and times that are judged."""
        knots = [piece["until"] for piece in self.asked["pieces"]]
        return sorted({*knots, *self.asked["times"]} - {0.0})

    def plan(self, step):
        """(from, to, steps) from stop to stop, no step longer than `step`."""
        begin = 0.0
        for stop in self.stops():
            yield begin, stop, max(1, int(np.ceil((stop - begin) / step - 1e-9)))
            begin = stop


def ladder(scene, program, method, fly):
    """Finer and finer motions; `fly(step)` gives states at the judged times, evaluations and seconds."""
    step = scene.asked["times"][-1] / FEWEST
    while True:
        begin = time.perf_counter()
        states, evaluations, seconds = fly(step)
        if all(np.isfinite(np.concatenate([position, rotation.ravel(), q])).all() for position, rotation, q in states):
            told = [{"position": p.tolist(), "rotation": r.tolist(), "q": q.tolist()} for p, r, q in states]
            tell(program=program, method=method, step=step, evaluations=evaluations, seconds=seconds, states=told)
        if time.perf_counter() - begin > LONGEST:
            return
        step /= 2


def pinocchio(scene):
    asked, rigid = scene.asked, Rigid(scene.asked)
    scene.rigid = rigid
    model, data = rigid.falling, rigid.data
    stiffness, rest, damping = (rigid.joints(asked[key]) for key in ("stiffness", "rest", "damping"))
    position, rotation = scene.start
    first = np.r_[position, pin.Quaternion(rotation).coeffs(), rigid.joints(asked["q"])]
    twist = np.array(asked["twist"])
    start = np.r_[first, twist[3:], twist[:3], rigid.joints(asked["qd"])]
    nq, seen = model.nq, []

    def rate(state):
        x, v = state[:nq].copy(), state[nq:]
        x[3:7] /= np.linalg.norm(x[3:7])
        turn = pin.Quaternion(x[3:7])
        moment, force = scene.base_wrench(turn.matrix())
        tau = rigid.joints(scene.piece["tau"]) - stiffness * (x[7:] - rest) - damping * v[6:]
        if asked["decoupling"]:
            tau += rigid.holding(x, v)
        seen.append((x, v, np.r_[force, moment, tau]))
        acceleration = pin.aba(model, data, *seen[-1])
        spin = (turn * pin.Quaternion(np.r_[v[3:6], 0.0])).coeffs() * (np.linalg.norm(state[3:7]) / 2)
        return np.r_[turn.matrix() @ v[:3], spin, v[6:], acceleration]

    def fly(step):
        state, states, evaluations = start, [], 0
        seen.clear()
        for begin, stop, steps in scene.plan(step):
            scene.enter(begin)
            h = (stop - begin) / steps
            for _ in range(steps):
                a = rate(state)
                b = rate(state + h / 2 * a)
                c = rate(state + h / 2 * b)
                state = state + h / 6 * (a + 2 * b + 2 * c + rate(state + h * c))
                evaluations += 4
            if stop in asked["times"]:
                turn = pin.Quaternion(state[3:7] / np.linalg.norm(state[3:7]))
                states.append((state[:3], turn.matrix(), state[7:nq][rigid.order]))
        return states, evaluations, evaluations * articulated(seen)

    def articulated(seen):
        """Seconds of one ABA, in C++: Python and what acts are not counted."""
        some = seen[:: max(1, len(seen) // 500)]
        x, v, tau = (np.array([one[k] for one in some]).T for k in range(3))
        pool, out = pin.ModelPool(model, 1), np.zeros_like(v)
        runs = []
        for _ in range(9):
            begin = time.perf_counter()
            pin.abaInParallel(1, pool, x, v, tau, out)
            runs.append((time.perf_counter() - begin) / x.shape[1])
        return statistics.median(runs)

    ladder(scene, "Pinocchio", "RK4", fly)


def mujoco_model(asked):
    """The URDF on a floating joint, with the linear torques as MuJoCo's own, so that its implicit integrators see them."""
    root = ElementTree.fromstring(asked["urdf"])
    for link in root.findall("link"):
        for shape in link.findall("visual") + link.findall("collision"):
            link.remove(shape)
    children = {joint.find("child").get("link") for joint in root.findall("joint")}
    (base,) = {link.get("name") for link in root.findall("link")} - children
    # MuJoCo knows the world by this name.
    ElementTree.SubElement(root, "link", name="world")
    joint = ElementTree.SubElement(root, "joint", name="floating base of the peers", type="floating")
    ElementTree.SubElement(joint, "parent", link="world")
    ElementTree.SubElement(joint, "child", link=base)
    for extension in root.findall("mujoco"):
        root.remove(extension)
    ElementTree.SubElement(ElementTree.SubElement(root, "mujoco"), "compiler", fusestatic="false")
    model = mujoco.MjModel.from_xml_string(ElementTree.tostring(root, "unicode"))
    model.opt.gravity[:] = asked["gravity"]
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_LIMIT
    model.dof_armature[:] = model.dof_frictionloss[:] = model.dof_damping[:] = 0
    joints = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in asked["joints"]]
    if -1 in joints or model.nv != 6 + len(joints):
        raise ValueError("its movable joints are not the robot's coordinates")
    q, qd = model.jnt_qposadr[joints], model.jnt_dofadr[joints]
    model.jnt_stiffness[joints], model.qpos_spring[q], model.dof_damping[qd] = asked["stiffness"], asked["rest"], asked["damping"]
    return model, q, qd


def mujoco_methods(scene):
    asked, rigid = scene.asked, scene.rigid
    if asked["decoupling"] and rigid is None:
        raise ValueError("the regulator's decoupling torque is computed with Pinocchio, which is left out")
    model, q, qd = mujoco_model(asked)
    acts = asked["decoupling"] or any(any(piece[key]) for piece in asked["pieces"] for key in ("tau", "base", "world"))

    def act(model, data):
        rotation = np.zeros(9)
        mujoco.mju_quat2Mat(rotation, data.qpos[3:7])
        rotation = rotation.reshape(3, 3)
        moment, force = scene.base_wrench(rotation)
        data.qfrc_passive[:3] += rotation @ force
        data.qfrc_passive[3:6] += moment
        data.qfrc_passive[qd] += scene.piece["tau"]
        if asked["decoupling"]:
            x = np.r_[data.qpos[:3], data.qpos[[4, 5, 6, 3]] / np.linalg.norm(data.qpos[3:7]), rigid.joints(data.qpos[q])]
            v = np.r_[rotation.T @ data.qvel[:3], data.qvel[3:6], rigid.joints(data.qvel[qd])]
            data.qfrc_passive[qd] += rigid.holding(x, v)[rigid.order]

    def started():
        data = mujoco.MjData(model)
        position, rotation = scene.start
        quaternion = np.zeros(4)
        mujoco.mju_mat2Quat(quaternion, rotation.ravel())
        twist = np.array(asked["twist"])
        data.qpos[:3], data.qpos[3:7], data.qpos[q] = position, quaternion, asked["q"]
        data.qvel[:3], data.qvel[3:6], data.qvel[qd] = rotation @ twist[3:], twist[:3], asked["qd"]
        return data

    def flown(step, stages):
        data, states, evaluations = started(), [], 0
        for begin, stop, steps in scene.plan(step):
            scene.enter(begin)
            model.opt.timestep = (stop - begin) / steps
            mujoco.mj_step(model, data, nstep=steps)
            evaluations += stages * steps
            if stop in asked["times"]:
                rotation = np.zeros(9)
                mujoco.mju_quat2Mat(rotation, data.qpos[3:7] / np.linalg.norm(data.qpos[3:7]))
                states.append((data.qpos[:3].copy(), rotation.reshape(3, 3), data.qpos[q].copy()))
        bad = mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQVEL, mujoco.mjtWarning.mjWARN_BADQACC
        if any(data.warning[kind].number for kind in bad):
            states = [(position * np.nan, rotation, q) for position, rotation, q in states]
        return states, evaluations

    def fly(step, stages):
        mujoco.set_mjcb_passive(act if acts else None)
        states, evaluations = flown(step, stages)
        # The same steps once more without what Python does in them.
        mujoco.set_mjcb_passive(None)
        begin = time.perf_counter()
        flown(step, stages)
        return states, evaluations, time.perf_counter() - begin

    for name in ("Euler", "implicit", "implicitfast", "discrete", "RK4"):
        integrator = getattr(mujoco.mjtIntegrator, f"mjINT_{name.upper()}", None)
        if integrator is not None:  # older ones have four
            model.opt.integrator, stages = integrator, 4 if name == "RK4" else 1
            ladder(scene, "MuJoCo", name, lambda step: fly(step, stages))


def main():
    asked = json.load(sys.stdin)
    if mujoco is not None:
        mujoco.set_mju_user_warning(lambda _: None)
    scene = Scene(asked)
    for library, name, package, motions in [(pin, "Pinocchio", "pin", pinocchio), (mujoco, "MuJoCo", "mujoco", mujoco_methods)]:
        if library is None or np is None:
            tell(left_out=f"{name} is not installed for this Python; pip install {package}")
            continue
        try:
            motions(scene)
        except Exception as error:  # whatever a library refuses a robot by
            tell(left_out=f"{name}: {' '.join(str(error).split())}")


main()
