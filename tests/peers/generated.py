"""Generates code for public robots and compares it with the core, bit by bit: `frs verify` on each."""

import json
import os
import subprocess
import sys

from catalogue import example_robots, label

# All quantities of small robots; of large ones those whose code a compiler digests in seconds.
ROBOTS = {
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
STATES = 1000


def verify(path, outputs):
    """The report of `frs verify`, or what it said instead."""
    command = [os.environ["FRS_BIN"], "verify", str(path), "--lenient", "--json", "--states", str(STATES)]
    done = subprocess.run(command + (["--outputs", outputs] if outputs else []), capture_output=True, text=True)
    return (json.loads(done.stdout) if done.returncode == 0 else None), done.stderr


def main():
    passed = failed = 0
    for robot, outputs in ROBOTS.items():
        path = example_robots() / robot
        report, words = verify(path, outputs)
        if report is None:
            failed += 1
            print(f"{label(path):40} FAILED\n{words}", flush=True)
            continue
        functions = report["functions"]
        compared = sum(function["compared"] for function in functions)
        passed += 1
        print(f"{label(path):40} {len(functions):3} functions, {compared:10,} numbers: the same bits", flush=True)
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
