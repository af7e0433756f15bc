"""Compares generated code with the core, bit by bit, by `frs verify`: of public robots, and of the project's own in lanes."""

import json
import os
import subprocess
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from catalogue import example_robots, label

# All quantities of small robots; of large ones those whose code a compiler digests in seconds.
PUBLIC = {
    "asr_twodof_description/urdf/TwoDofs.urdf": None,
    "finger_edu_description/robots/finger_edu.urdf": None,
    "iris_description/robots/iris.urdf": None,
    "hextilt_description/urdf/hextilt_flying_arm_5.urdf": None,
    "ur_description/urdf/ur5_robot.urdf": None,
    "xarm_description/urdf/xarm7.urdf": None,
    "panda_description/urdf/panda.urdf": "inertia,matrices,forward_dynamics",
    "solo_description/robots/solo12.urdf": "inertia,matrices,forward_dynamics",
    "allegro_hand_description/urdf/allegro_left_hand.urdf": "inertia,forward_dynamics",
    "g1_description/urdf/g1_29dof_rev_1_0.urdf": "inertia,forward_dynamics",
    "talos_data/robots/talos_full_v2.urdf": "inertia,momentum",
    "g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf": "inertia",
}
# Enough that an operation done otherwise would show in some bit of some output; hard states come on top.
PUBLIC_STATES = 1000

# The checked-in robots, with the quantities that are checked in.
OWN = {
    "planar_three_link": None,
    "chaser": None,
    "lwr_satellite": None,
    "quadruped": None,
    "dual_arm_satellite": None,
    "humanoid": "inertia,momentum,velocity_of_momentum,base_twist,forward_dynamics",
}
OWN_STATES = 10000
# Without optimisation each operation is what is written, and lanes compile in seconds; generated/ itself is tested optimised.
KINDS = [["--lanes", "4"], ["--lanes", "8"], ["--f32"], ["--f32", "--lanes", "16"], []]
# The hybrid form of the small ones; of all robots it is interpreted in frs-codegen/tests/options.rs.
HYBRID = {"planar_three_link", "chaser", "lwr_satellite"}


# Where each thread's builds stand: what lanes stand on is compiled once.
BUILDS = threading.local()


def verify(path, outputs, states, options):
    """The report of `frs verify`, or what it said instead."""
    if not hasattr(BUILDS, "folder"):
        BUILDS.folder = tempfile.TemporaryDirectory()
    command = [os.environ["FRS_BIN"], "verify", str(path), "--lenient", "--json", "--states", str(states), *options]
    command += ["--outputs", outputs] if outputs else []
    done = subprocess.run(command, capture_output=True, text=True, env=os.environ | {"CARGO_TARGET_DIR": BUILDS.folder.name})
    return (json.loads(done.stdout) if done.returncode == 0 else None), done.stderr


def cases():
    """What is verified: its name, and the arguments of `verify`."""
    for robot, outputs in PUBLIC.items():
        path = example_robots() / robot
        yield label(path), (path, outputs, PUBLIC_STATES, [])
    robots = Path(__file__).parents[2] / "robots"
    for robot, outputs in OWN.items():
        for kind in KINDS + [["--form", "hybrid"]] * (robot in HYBRID):
            arguments = (robots / f"{robot}.urdf", outputs, OWN_STATES, ["--opt-level", "0", *kind])
            yield " ".join([robot, *kind]), arguments


def main():
    passed = failed = 0
    names, arguments = zip(*cases())
    # A compiler without optimisation takes one core.
    pool = ThreadPoolExecutor(os.cpu_count())
    for name, (report, words) in zip(names, pool.map(lambda each: verify(*each), arguments)):
        if report is None:
            failed += 1
            print(f"{name:40} FAILED\n{words}", flush=True)
            continue
        functions = report["functions"]
        compared = sum(function["compared"] for function in functions)
        passed += 1
        print(f"{name:40} {len(functions):3} functions, {compared:10,} numbers: the same bits", flush=True)
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
