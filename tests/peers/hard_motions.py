"""Hard motions beside MuJoCo and Pinocchio (docs/hard.md): what is known of each, and how far every program is from it."""

import csv
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import mpmath as mp
    import mujoco
    import numpy as np
    import pinocchio as pin

    from frs import Broken
    from motions import mujoco_model
    from problem import Problem
except ImportError as missing:
    print(f"peers: {missing}; start this through tests/peers/run, which installs what it needs", file=sys.stderr)
    sys.exit(2)

ROBOTS = Path(__file__).parents[2] / "robots"
EPSILON = np.finfo(float).eps
INTEGRATORS = {"Euler": "mjINT_EULER", "implicit": "mjINT_IMPLICIT", "implicitfast": "mjINT_IMPLICITFAST",
               "discrete": "mjINT_DISCRETE", "RK4": "mjINT_RK4"}


def simulated(folder, scene, robot):
    """What `frs simulate` tells, and a function that gives columns of its table by their names."""
    path, out = folder / "scene.toml", folder / "out"
    path.write_text(f"robot = '{robot}'\n{scene}")
    command = [os.environ["FRS_BIN"], "simulate", str(path), "--out", str(out), "--json"]
    done = subprocess.run(command, capture_output=True, text=True)
    if not done.stdout:
        raise Broken(f"frs simulate: {done.stderr.strip() or 'no message'}")
    with open(out / "trajectory.csv", newline="") as file:
        header, *rows = csv.reader(file)
    table = np.array(rows, dtype=float)
    return json.loads(done.stdout), lambda *names: table[:, [header.index(name) for name in names]]


def started(folder, scene, robot):
    """The same scene in MuJoCo, at its start: the model, its data, and where joints are in them."""
    path = folder / "peers.toml"
    path.write_text(f"robot = '{robot}'\n{scene}")
    problem = Problem(path)
    model, q, qd = mujoco_model(problem)
    data = mujoco.MjData(model)
    data.qpos[:3], data.qpos[3:7], data.qpos[q] = problem.x[:3], problem.x[[6, 3, 4, 5]], problem.x[7:]
    data.qvel[:3] = pin.Quaternion(problem.x[3:7]).matrix() @ problem.v[:3]
    data.qvel[3:6], data.qvel[qd] = problem.v[3:6], problem.v[6:]
    return problem, model, data, q, qd


def given_up(data):
    """Whether MuJoCo found a rate or an acceleration too large, and began anew."""
    kinds = mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQVEL, mujoco.mjtWarning.mjWARN_BADQACC
    return any(data.warning[kind].number for kind in kinds)


class Table:
    """What was found, a row a case; `kept` is whether frs keeps what it must everywhere."""

    PEERS = [*INTEGRATORS, "Pinocchio"]

    def __init__(self):
        self.kept = True
        print("\nMotions: frs, what it is allowed, MuJoCo's five integrators, Pinocchio under RK4")
        print(f"{'case':34}{'off by':20}" + "".join(f"{title:>13}" for title in ["frs", "allowed", *self.PEERS]))

    def row(self, case, what, frs, allowed, **peers):
        self.kept &= bool(frs <= allowed)
        numbers = [frs, allowed, *(peers.get(name, "–") for name in self.PEERS)]
        told = [number if isinstance(number, str) else f"{number:.1e}" for number in numbers]
        print(f"{case:34}{what:20}" + "".join(f"{number:>13}" for number in told), flush=True)


# The body of frs-sim/tests/hard/spinning.rs, as near to the separatrix.
INERTIA = np.array([1.0, 2.0, 2.5])
BESIDE = 1e-3
FLIPS = 100
BODY = ('<robot name="body"><link name="body"><inertial><mass value="3"/><inertia ixx="1" iyy="2" izz="2.5" ixy="0" ixz="0" iyz="0"/>'
        "</inertial></link></robot>")


def flips(table, folder, b):
    """Case 6: a body that flips about its intermediate axis, at times that elliptic functions give."""
    i1, i2, i3 = INERTIA.tolist()
    a = b * float(np.sqrt((1 - BESIDE) * i3 * (i3 - i2) / (i1 * (i2 - i1))))
    between = float(2 * mp.ellipk(1 - mp.mpf(BESIDE))) / (b * float(np.sqrt((i3 - i2) * (i3 - i1) / (i1 * i2))))
    duration, growth = FLIPS * between, a * b * (i3 - i1) / i2
    energy = lambda turn: 0.5 * turn**2 @ INERTIA
    first = energy(np.array([a, 0, b]))
    robot = folder / "body.urdf"
    robot.write_text(BODY)
    accuracy = 1e-13
    scene = (f"duration = {duration!r}\naccuracy = {accuracy}\nsamples_per_second = {1 / between!r}\n"
             f"[start]\nmu = [{a!r}, 0, {b!r}, 0, 0, 0]\n")
    told, take = simulated(folder, scene, robot)
    rotation = take(*[f"pose.r_{row}{column}" for row in "xyz" for column in "xyz"]).reshape(-1, 3, 3)[1 : FLIPS + 1]
    turn = np.einsum("kji,j->ki", rotation, INERTIA * [a, 0, b]) / INERTIA
    late, lost = np.abs(turn[:, 1] / growth).max() / duration, np.abs(energy(turn) / first - 1).max()

    model = mujoco.MjModel.from_xml_string(
        '<mujoco><option gravity="0 0 0"/><worldbody><body><freejoint/>'
        '<inertial pos="0 0 0" mass="3" diaginertia="1 2 2.5"/></body></worldbody></mujoco>')
    lates, losts = {}, {}
    for name, integrator in INTEGRATORS.items():
        model.opt.integrator = getattr(mujoco.mjtIntegrator, integrator)
        # As many evaluations as frs took.
        substeps = max(1, round(told["evaluations"] / FLIPS / (4 if name == "RK4" else 1)))
        model.opt.timestep = between / substeps
        data = mujoco.MjData(model)
        data.qvel[3:6] = [a, 0, b]
        lates[name] = losts[name] = 0.0
        for _ in range(FLIPS):
            mujoco.mj_step(model, data, nstep=substeps)
            turn = data.qvel[3:6]
            lates[name] = max(lates[name], abs(turn[1] / growth) / duration)
            losts[name] = max(losts[name], abs(energy(turn) / first - 1))
        if given_up(data):
            lates[name] = losts[name] = "gives up"
        elif losts[name] > 0.01:
            lates[name] = "lost"
    allowed = told["steps"] * accuracy
    # How the time between flips answers to the energy, as derived in spinning.rs.
    of_m = 2 * first * (i3 / (i1 * a * a) + i1 / (i3 * b * b)) / (i3 - i1)
    sensitivity = 1 + of_m / (2 * BESIDE * float(mp.ellipk(1 - mp.mpf(BESIDE))))
    case = f"6 flips at {b:.0e} rad/s"
    table.row(case, "energy, relative", lost, allowed, **losts)
    table.row(case, "time, relative", late, sensitivity * max(lost, EPSILON) + allowed, **lates)


def gait(table, folder):
    """Case 7: turns of a closed gait, beside as many times the holonomy of one."""
    turns, steps, rate = 2_000, 16, 2 * np.pi
    courses = [(0.4, 0.8, 0.0), (-0.7, 0.6, np.pi / 2)]
    robot = ROBOTS / "planar_three_link.urdf"
    prescribed = "".join(
        f"[[prescribed]]\njoint = 'joint_{k}'\nsinusoid = {{ offset = {offset}, amplitude = {amplitude}, rate = {rate!r}, phase = {phase!r} }}\n"
        for k, (offset, amplitude, phase) in enumerate(courses, 1))

    def turned(count):
        solver = f"[solver]\nmethod = 'rkmk4'\nstep = {1 / steps}\n"
        _, take = simulated(folder, f"duration = {count}\nsamples_per_second = 1\n{prescribed}{solver}", robot)
        return np.arctan2(*take("pose.r_yx", "pose.r_xx")[-1])

    def apart(angle, once):
        return abs(np.remainder(angle - turns * once + np.pi, 2 * np.pi) - np.pi)

    model = pin.buildModelFromUrdf(str(robot), pin.JointModelFreeFlyer())
    model.gravity.setZero()
    data = model.createData()

    def spin(time):
        q = [offset + amplitude * np.sin(rate * time + phase) for offset, amplitude, phase in courses]
        qd = [amplitude * rate * np.cos(rate * time + phase) for _, amplitude, phase in courses]
        momentum = pin.computeCentroidalMap(model, data, np.concatenate([pin.neutral(model)[:7], q]))
        return -np.linalg.solve(momentum[:, :6], momentum[:, 6:] @ qd)[5]

    # About one axis RK4 is Simpson's rule. Times are within the turn: sines of far angles are another question.
    h, angle, once = 1 / steps, 0.0, 0.0
    rates = [(h / 6) * (spin(k * h) + 4 * spin((k + 0.5) * h) + spin((k + 1) * h)) for k in range(steps)]
    for _ in range(turns):
        for rate_of_step in rates:
            angle += rate_of_step
        once = once or angle
    # The rates are of order 1, rounded a few times in each evaluation; the one turn's angle counts as many times as there are turns.
    allowed = turns * (steps + 1) * 4 * EPSILON
    table.row(f"7 gait, {turns} turns", "angle, rad", apart(turned(turns), turned(1)), allowed, Pinocchio=apart(angle, once))


def stiff(table, folder, kind, limit, force, share):
    """Case 8: steps a thousand times as long as an explicit method bears."""
    stiffness = 1e8
    steps, robot = 300, ROBOTS / "planar_three_link.urdf"
    step = 1e3 * float(limit(stiffness))
    start = "[start]\nq = { joint_1 = 1e-3, joint_2 = -1e-3 }\nqd = { joint_1 = 1e-3 }\nmomentum = [0, 0, 0, 0, 0, 0]\n"
    head = f"duration = {steps * step!r}\nsamples_per_second = {1 / step!r}\n"
    solver = f"[solver]\nmethod = 'implicit_midpoint'\nstep = {step!r}\n"
    told, take = simulated(folder, head + start + force(stiffness) + solver, robot)
    stored = 0.5 * stiffness * share
    energies = take("kinetic_energy")[:, 0] + stored * (take("q.joint_1", "q.joint_2") ** 2).sum(axis=1)
    grown = energies.max() / energies[0] - 1 if told["end"] == "whole" else np.inf
    found = {}
    for name, integrator in INTEGRATORS.items():
        _, model, data, q, _ = started(folder, head + start + force(stiffness), robot)
        model.opt.integrator, model.opt.timestep = getattr(mujoco.mjtIntegrator, integrator), step
        model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
        mujoco.mj_forward(model, data)
        first = most = data.energy.sum()
        for _ in range(steps):
            mujoco.mj_step(model, data)
            most = max(most, data.energy.sum())
        found[name] = "gives up" if given_up(data) else max(most / first - 1, 0.0)
    # Of springs, the share by which Λ_q changes within these angles.
    table.row(f"8 {kind} of 1e8, step {step:.0e} s", "energy grows by", max(float(grown), 0.0), 1e-2 if share else 1e-9, **found)


def fall(table, folder):
    """Case 9: an hour of fall beside an hour of flight."""
    hour, step, gravity, robot = 3600.0, 0.0625, np.array([1.5, -2.0, -9.81]), ROBOTS / "chaser.urdf"
    momentum = np.array([0.01, -0.02, 0.03, 0.5, 0.25, 7.0])
    names = [f"joint_{k}" for k in (1, 2, 3)]
    start = (f"duration = {hour}\nsamples_per_second = 0.1\n[start]\nq = {{ joint_1 = 0.4, joint_2 = -0.7, joint_3 = 1.1 }}\n"
             f"qd = {{ joint_1 = 0.02, joint_2 = 0.05, joint_3 = -0.03 }}\nmomentum = {momentum.tolist()}\n[spring]\nstiffness = 0.1\n")
    solver = f"[solver]\nmethod = 'rkmk4'\nstep = {step}\n"
    _, floating = simulated(folder, start + solver, robot)
    columns = ["q." + name for name in names] + ["com." + axis for axis in "xyz"]
    before = floating(*columns)
    _, falling = simulated(folder, f"{start}{solver}[gravity]\nacceleration = {gravity.tolist()}\n", robot)
    after, time = falling(*columns), falling("time")
    way = 0.5 * gravity * time**2
    expected = before[:, 3:] + way
    shape = np.abs(after[:, :3] - before[:, :3]).max()
    com = (np.abs(after[:, 3:] - expected).max(axis=1) / np.maximum(np.abs(expected).max(axis=1), 1)).max()

    tracks = []
    for pull in (np.zeros(3), gravity):
        _, model, data, q, _ = started(folder, start, robot)
        model.opt.gravity[:], model.opt.timestep = pull, step
        track = []
        for sample in range(361):
            if sample:
                mujoco.mj_step(model, data, nstep=160)
            mujoco.mj_kinematics(model, data)
            mujoco.mj_comPos(model, data)
            track.append(np.concatenate([data.qpos[q], data.subtree_com[0]]))
        tracks.append(np.array(track))
    times = 10.0 * np.arange(361)[:, None]
    truth = tracks[0][0, 3:] + momentum[3:] / model.body_mass.sum() * times
    apart = np.abs(tracks[1][:, 3:] - truth - 0.5 * gravity * times**2).max(axis=1)
    off = apart / np.maximum(np.abs(truth + 0.5 * gravity * times**2).max(axis=1), 1)
    table.row("9 an hour of fall and of flight", "q of both, rad", shape, 0.0, RK4=np.abs(tracks[1] - tracks[0])[:, :3].max())
    table.row("9", "com from the parabola", com, 16 * EPSILON, RK4=off.max())


def blows(table, folder):
    """Case 11: blows of 0.5 N·s, shorter and shorter; MuJoCo with steps of 1 ms samples a force where its steps begin."""
    robot = ROBOTS / "lwr_satellite.urdf"
    for length in (1e-3, 1e-6, 1e-9):
        start, end = 0.5004, 0.5004 + length
        force = 0.5 / length
        head = "duration = 1\naccuracy = 1e-8\nsamples_per_second = 10\n"
        blow = f"[[wrench]]\nforce = [{force!r}, 0, 0]\naxes = 'world'\nstart = {start!r}\nend = {end!r}\n"
        told, take = simulated(folder, f"{head}{blow}", robot)
        given = force * (end - start)
        missed = abs(take("spatial_momentum.force_x")[-1, 0] / given - 1)
        found = {}
        for name, integrator in INTEGRATORS.items():
            _, model, data, _, _ = started(folder, head, robot)
            model.opt.integrator, model.opt.timestep = getattr(mujoco.mjtIntegrator, integrator), 1e-3
            for _ in range(1000):
                data.xfrc_applied[1, 0] = force if start <= data.time < end else 0.0
                mujoco.mj_step(model, data)
            mujoco.mj_forward(model, data)
            mujoco.mj_subtreeVel(model, data)
            found[name] = abs(model.body_mass.sum() * data.subtree_linvel[0][0] / given - 1)
        table.row(f"11 a blow of {length:.0e} s", "impulse, relative", missed, told["steps"] * 1e-8, **found)


def main():
    # It would write them to a file; what it warns of is in the table.
    mujoco.set_mju_user_warning(lambda _: None)
    table = Table()
    planar = pin.buildModelFromUrdf(str(ROBOTS / "planar_three_link.urdf"), pin.JointModelFreeFlyer())
    mass = pin.crba(planar, planar.createData(), np.concatenate([pin.neutral(planar)[:7], [0.0, 0.0]]))
    mass = np.triu(mass) + np.triu(mass, 1).T
    lightest = 1 / np.linalg.eigvalsh(mass[6:, 6:] - mass[6:, :6] @ np.linalg.solve(mass[:6, :6], mass[:6, 6:])).min()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for b in (1.0, 1e4, 1e6):
            flips(table, folder, b)
        gait(table, folder)
        # |hλ| up to which RK4 is stable, on the imaginary axis and on the real one.
        stiff(table, folder, "springs", lambda k: 2.828 / np.sqrt(k * lightest), lambda k: f"[spring]\nstiffness = {k}\n", 1.0)
        stiff(table, folder, "dampers", lambda d: 2.785 / (d * lightest), lambda d: f"[friction]\nviscous = {d}\n", 0.0)
        fall(table, folder)
        blows(table, folder)
    if not table.kept:
        print("peers: frs is off by more than is allowed", file=sys.stderr)
    return 0 if table.kept else 1


if __name__ == "__main__":
    if "FRS_BIN" not in os.environ:
        sys.exit("peers: start this through tests/peers/run hard")
    try:
        sys.exit(main())
    except Broken as error:
        print(f"peers: {error}", file=sys.stderr)
        sys.exit(2)
