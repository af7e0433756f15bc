"""`frs accuracy --peers`: MuJoCo and Pinocchio under RK4 come to the motion that frs is judged by, with order 4 and the same errors."""

import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

# Steps are halved: errors fall by 2⁴, by which they fall once both terms of the next order are small.
ORDER = 4.0
NEAR = 0.2
# Errors between these are of the method: larger ones have higher orders in them, smaller ones rounding, too.
METHOD = 1e-11, 1e-6
# By how much both may differ there: they turn the base by other formulas.
ALIKE = 0.1

SCENE = """robot = 'lwr_satellite.urdf'
duration = 0.5
[start]
q = { joint_2 = 0.6, joint_4 = 1.0 }
qd = { joint_3 = 0.4, joint_6 = -0.5 }
mu = [0.1, 0.2, -0.1, 0, 0.02, 0]
[gravity]
acceleration = [0.5, 0, -1]
[[wrench]]
moment = [5, 4, 3]
force = [1, 2, 3]
start = 0.11
end = 0.152
[[wrench]]
force = [3, 0, -2]
axes = 'world'
[[joint_torque]]
tau = { joint_1 = 0.5, joint_5 = -0.2 }
start = 0.2
[spring]
stiffness = 0.5
rest = { joint_2 = 0.1 }
[friction]
viscous = 0.05
[regulator]
set_point = { joint_2 = 0.5, joint_4 = 1.1 }
stiffness = [2, 6, 4, 10, 0.4, 0.6, 0.03]
damping = [0.6, 1.8, 1.1, 2.7, 0.12, 0.16, 0.008]
decoupling = "coupling"
"""


def main():
    robots = Path(__file__).parents[2] / "robots"
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.toml"
        path.write_text(SCENE.replace("lwr_satellite.urdf", str(robots / "lwr_satellite.urdf")))
        command = [os.environ["FRS_BIN"], "accuracy", str(path), "--seconds", "0.5", "--json", f"--peers={sys.executable}"]
        done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        print(f"peers: frs accuracy: {done.stderr.strip() or 'no message'}", file=sys.stderr)
        return 2
    peers, kept, curves = json.loads(done.stdout)["peers"], True, {}
    for motion in peers["motions"]:
        curves.setdefault((motion["program"], motion["method"]), {})[motion["step"]] = motion["error"]
    for program in ("Pinocchio", "MuJoCo"):
        errors = list(curves.get((program, "RK4"), {}).values())
        best = min(errors, default=float("inf"))
        pairs = [a / b for a, b in zip(errors, errors[1:]) if METHOD[0] < b < a < METHOD[1]]
        orders = [math.log2(ratio) for ratio in pairs]
        good = best <= METHOD[0] and len(orders) >= 2 and all(abs(order - ORDER) <= NEAR for order in orders)
        kept &= good
        print(f"{'ok' if good else 'BAD':4}{program:10} RK4: error down to {best:.1e}, order {', '.join(f'{order:.2f}' for order in orders)}")
    one, other = (curves.get((program, "RK4"), {}) for program in ("Pinocchio", "MuJoCo"))
    both = [(one[step], other[step]) for step in one if step in other and METHOD[0] < one[step] < METHOD[1]]
    apart = max((abs(a - b) / a for a, b in both), default=float("inf"))
    kept &= apart <= ALIKE
    print(f"{'ok' if apart <= ALIKE else 'BAD':4}their errors at the same steps differ by {apart:.1%} at most")
    for reason in peers["left_out"]:
        print(f"BAD {reason}")
        kept = False
    return 0 if kept else 1


if __name__ == "__main__":
    if "FRS_BIN" not in os.environ:
        sys.exit("peers: start this through tests/peers/run accuracy")
    sys.exit(main())
