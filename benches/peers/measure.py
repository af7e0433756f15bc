"""Runs the two timing programs in turn, robot by robot and round by round, so that a disturbance hits both.

    measure.py --rounds N --samples N --cpu K SAMPLES.json URDF...

PINOCCHIO_TIMES and FRS_TIMES name the programs (without FRS_TIMES only Pinocchio is measured), DESCRIPTIONS the folder
that describe.py filled. SAMPLES.json receives [{"robot", "n", "side", "work", "ns": [[a round's samples], ...]}].
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path


def timings(command, pin):
    done = subprocess.run([*pin, *command], capture_output=True, text=True)
    if done.returncode:
        print(f"peers: {Path(command[0]).name} ended with code {done.returncode}: {done.stderr.strip()}", file=sys.stderr)
        sys.exit(2)
    return [json.loads(line) for line in done.stdout.splitlines()]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--samples", type=int, default=5)
    parser.add_argument("--cpu", default="1" if (os.cpu_count() or 1) > 1 else "0")
    parser.add_argument("output", type=Path)
    parser.add_argument("urdf", nargs="+", type=Path)
    options = parser.parse_args()

    pin = ["taskset", "-c", options.cpu] if shutil.which("taskset") else []
    if not pin:
        print("peers: no taskset here, so the programs may wander between cores", file=sys.stderr)
    samples = ["--samples", str(options.samples)]
    found = {}
    for turn in range(options.rounds):
        for path in options.urdf:
            if sys.stderr.isatty():
                print(f"\r\x1b[K[round {turn + 1}/{options.rounds}] {path.stem}", end="", file=sys.stderr, flush=True)
            description = f"{os.environ['DESCRIPTIONS']}/{path.stem}.txt"
            sides = {"pinocchio": [os.environ["PINOCCHIO_TIMES"], description, *samples]}
            if os.environ.get("FRS_TIMES"):
                sides["frs"] = [os.environ["FRS_TIMES"], str(path), *samples]
            # Whoever runs second finds the core warm: take turns at that too.
            for side in sorted(sides, reverse=turn % 2 == 1):
                for line in timings(sides[side], pin):
                    key = (path.stem, side, line["work"])
                    entry = {"robot": path.stem, "n": line["n"], "side": side, "work": line["work"], "ns": []}
                    found.setdefault(key, entry)["ns"].append(line["ns"])
    if sys.stderr.isatty():
        print("\r\x1b[K", end="", file=sys.stderr)
    options.output.write_text(json.dumps(list(found.values())))


if __name__ == "__main__":
    main()
