"""Compares motions: `frs simulate` with Pinocchio under DOP853 and with MuJoCo's RK4, on two scenes (docs/scene_peers.md)."""

import argparse
import json
import math
import os
import sys
import tempfile
import time
from dataclasses import asdict, dataclass
from pathlib import Path

try:
    from frs import Broken
    from motions import QUANTITIES, differences, extrapolated, mujoco_rk4, ours, pinocchio
    from problem import Problem, Unreadable
    from robot import Unusable
except ImportError as missing:
    print(f"peers: {missing}; start this through tests/peers/run, which installs what it needs", file=sys.stderr)
    sys.exit(2)

# What is compared is the first; the difference to the second, ten times tighter, is its error estimate.
OURS = 1e-13, 1e-14
PINOCCHIO = 1e-12, 1e-13

# Two runs of ours from the very same numbers round alike for as long as they are alike: on the chain, whose joints start at 0, the
# base's turn ends up wrong by nearly the same in both. So the tighter ones start beside the first, by less (rad) than START covers; and
# several, as one difference of two random walks says little about their size.
MOVED = 1e-15
WALKS = 4

# Order of MuJoCo's integrator in smooth motion; the observed one is printed.
RK4 = 4

# An estimate is a difference of two runs. Where rounding is what is left, the second run is as wrong as the first, and the
# first may be wrong by twice as much as they differ by if they err to the same side.
SAFETY = 2

# Both runs of a program begin at the same rounded numbers, so no estimate sees that. Start, rates and stiffness moved by one
# or two last bits move position, rotation and q of these scenes by 1e-14 to 1e-13 (measured with Pinocchio).
START = 1e-13


@dataclass
class Scene:
    name: str
    substeps: int  # MuJoCo's longest step is the sample interval divided by this; then twice, then four times as many
    tolerance: float | None = None  # asked for beside the estimates, for Pinocchio


# The satellite's motion is so gentle that 1e-9 (m, rad, rad/s) over 10 s is far above all estimates: it is the promise.
SCENES = [Scene("tumbling", substeps=8, tolerance=1e-9), Scene("chain", substeps=16)]


@dataclass
class Row:
    scene: str
    peer: str
    quantity: str
    unit: str
    difference: float
    our_estimate: float
    peer_estimate: float
    allowed: float
    agrees: bool


def rows(scene, peer, motion, estimates, reference, our_estimates, tolerance=None):
    """One row a quantity; not a number does not agree."""
    for key, difference in differences(motion, reference).items():
        allowed = SAFETY * (our_estimates[key] + estimates[key]) + START
        allowed = min(allowed, tolerance or allowed)
        agrees = math.isfinite(allowed) and difference <= allowed
        yield Row(scene, peer, key, QUANTITIES[key], difference, our_estimates[key], estimates[key], allowed, agrees)


def compare(scene, folder):
    """The rows of one scene, and the order that MuJoCo's steps show."""
    problem = Problem(Path(__file__).parents[2] / "scenes" / f"{scene.name}.toml")
    frs = ours(problem, OURS[0], folder)
    walks = [differences(frs, ours(problem, OURS[1], folder, MOVED, seed)) for seed in range(WALKS)]
    our_estimates = {key: max(walk[key] for walk in walks) for key in QUANTITIES}

    pin, tighter = (pinocchio(problem, frs.time, accuracy) for accuracy in PINOCCHIO)
    found = list(rows(scene.name, "Pinocchio", pin, differences(pin, tighter), frs, our_estimates, scene.tolerance))

    ladder = [mujoco_rk4(problem, frs.time, scene.substeps * 2**rung) for rung in range(3)]
    coarse, fine = (extrapolated(*pair, RK4) for pair in (ladder[:2], ladder[1:]))
    found += rows(scene.name, "MuJoCo", fine, differences(fine, coarse), frs, our_estimates)
    steps = [differences(*pair) for pair in (ladder[:2], ladder[1:])]
    return found, {key: math.log2(steps[0][key] / steps[1][key]) for key in QUANTITIES}


def line(row):
    cells = [row.difference, row.our_estimate, row.peer_estimate, row.allowed]
    mark = "ok  " if row.agrees else "FAIL"
    return f"{mark} {row.scene:<9} {row.peer:<10} {row.quantity:<9} {row.unit:<8}" + "".join(f" {cell:>11.1e}" for cell in cells)


def main():
    parser = argparse.ArgumentParser(prog="tests/peers/run scenes", description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON document instead of the table")
    options = parser.parse_args()
    if "FRS_BIN" not in os.environ:
        parser.error("FRS_BIN is not set; start this through tests/peers/run")

    if not options.json:
        columns = ("difference", "error, frs", "error, peer", "allowed")
        print(f"     {'scene':<9} {'peer':<10} {'quantity':<9} {'unit':<8}" + "".join(f" {column:>11}" for column in columns))
    found, broken, orders, began = [], {}, {}, time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        for scene in SCENES:
            try:
                new, orders[scene.name] = compare(scene, Path(folder))
            except Broken as problem:
                broken[scene.name] = str(problem)
                print(f"FAIL {scene.name}: {problem}", file=sys.stderr)
                continue
            except (Unreadable, Unusable, OSError) as problem:
                print(f"peers: {scene.name}: {problem}", file=sys.stderr)
                sys.exit(2)
            found += new
            if not options.json:
                print("\n".join(map(line, new)), flush=True)
    failed = sum(not row.agrees for row in found) + len(broken)
    if options.json:
        document = {"safety": SAFETY, "start": START, "moved": MOVED, "walks": WALKS, "accuracies": OURS, "rtol": PINOCCHIO,
                    "rows": [asdict(row) for row in found], "mujoco_orders": orders, "broken": broken, "failed": failed}
        print(json.dumps(document, ensure_ascii=False, indent=1))
    else:
        for name, order in orders.items():
            print(f"{name}: order of MuJoCo's steps " + ", ".join(f"{key} {order[key]:.1f}" for key in QUANTITIES))
        most = "".join(f"; {scene.name} with Pinocchio at most {scene.tolerance:g}" for scene in SCENES if scene.tolerance)
        print(f"allowed: {SAFETY} × (error, frs + error, peer) + {START:g}{most}")
        print(f"{len(found) - failed + len(broken)} agree, {failed} do not; {time.monotonic() - began:.0f} s")
    sys.exit(1 if failed or not found else 0)


if __name__ == "__main__":
    main()
