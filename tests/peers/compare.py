"""Compares `frs eval` with Pinocchio: every quantity of every state within TOLERANCE, and every expected refusal."""

import argparse
import json
import os
import sys
import tempfile
from dataclasses import asdict, dataclass, field
from pathlib import Path

try:
    import catalogue
    from errors import KEYS, TOLERANCE, errors
    from expected import REFUSALS
    from frs import Broken, Refused, evaluate, reading
    from reference import reference
    from robot import Robot, Unusable
except ImportError as missing:
    print(f"peers: {missing}; start this through tests/peers/run, which installs what it needs", file=sys.stderr)
    sys.exit(2)


@dataclass
class Outcome:
    robot: str
    verdict: str  # passed, failed or skipped
    n: int | None = None
    errors: dict = field(default_factory=dict)
    note: str = ""


def compare(path, count, folder):
    """One robot; `folder` takes a repaired copy, if it needs one."""
    label = catalogue.label(path)
    refusal = REFUSALS.get(label)
    note = ""
    if refusal:
        try:
            evaluate(path, ["{}"])
            return Outcome(label, "failed", note=f"accepted, but should be refused for “{refusal.words}” (see expected.py)")
        except Refused as said:
            if refusal.words not in str(said):
                return Outcome(label, "failed", note=f"refused, but not for “{refusal.words}”: {said.first}")
        note = f"refused as it should be: {refusal.words}"
        if not refusal.comparable:
            return Outcome(label, "passed", note=note)
        if refusal.without_products:
            path = catalogue.copy_without_products(path, refusal.without_products, folder)
    try:
        robot = Robot(path)
    except Unusable as reason:
        return Outcome(label, "skipped", note=str(reason))
    try:
        worst = worst_errors(robot, count, lenient=bool(refusal and refusal.lenient))
    except Refused as said:
        return Outcome(label, "failed", robot.n, note=said.first)
    except (Broken, KeyError, ValueError) as problem:
        return Outcome(label, "failed", robot.n, note=f"unusable answer: {type(problem).__name__}: {problem}")
    good = all(error <= TOLERANCE for error in worst.values())
    return Outcome(label, "passed" if good else "failed", robot.n, worst, note)


def worst_errors(robot, count, lenient):
    """The worst error of each quantity over the states."""
    states = list(robot.states(count))
    answers = evaluate(robot.path, [state.line(robot.names) for state in states], lenient=lenient)
    worst = dict.fromkeys(KEYS, 0.0)
    for state, ours in zip(states, answers):
        if "error" in ours:
            raise Broken(ours["error"])
        theirs = reference(robot, state)
        for key, error in errors(reading(ours, robot.names, theirs.xi), theirs, state).items():
            worst[key] = max(error, worst[key])
    return worst


def row(outcome):
    """One line of the table; an error above the tolerance is marked."""
    mark = {"passed": "ok  ", "failed": "FAIL", "skipped": "skip"}[outcome.verdict]
    cells = f"{mark} {outcome.robot:<42} {'' if outcome.n is None else outcome.n:>3}"
    if outcome.errors:
        for key in KEYS:
            error = outcome.errors[key]
            cells += f" {error:>7.0e}" + ("!" if error > TOLERANCE else " ")
    return cells + (f"  {outcome.note}" if outcome.note else "")


def shown(path, number, total, options, folder):
    """Compares one robot, with its name on the terminal meanwhile and its row afterwards."""
    if sys.stderr.isatty():
        print(f"\r\x1b[K[{number}/{total}] {catalogue.label(path)}", end="", file=sys.stderr, flush=True)
    outcome = compare(path, options.states, folder)
    if sys.stderr.isatty():
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)
    if not options.json:
        print(row(outcome), flush=True)
    return outcome


def main():
    parser = argparse.ArgumentParser(prog="tests/peers/run", description=__doc__)
    parser.add_argument("urdf", nargs="*", type=Path, help="compare only these (default: all)")
    parser.add_argument("--states", type=int, default=20, help="random states a robot (default %(default)s)")
    parser.add_argument("--json", action="store_true", help="print one JSON document instead of the table")
    options = parser.parse_args()
    try:
        if "FRS_BIN" not in os.environ:
            raise FileNotFoundError("FRS_BIN is not set; start this through tests/peers/run")
        paths = [path.resolve() for path in options.urdf] or catalogue.urdfs()
        for path in paths:
            if not path.is_file():
                raise FileNotFoundError(f"there is no file {path}")
        unknown = set(REFUSALS) - {catalogue.label(path) for path in paths}
        if unknown and not options.urdf:
            raise FileNotFoundError(f"expected.py names robots that do not exist: {', '.join(sorted(unknown))}")
    except FileNotFoundError as missing:
        print(f"peers: {missing}", file=sys.stderr)
        sys.exit(2)

    if not options.json:
        print(f"     {'robot':<42} {'n':>3}" + "".join(f" {key:>7} " for key in KEYS))
    with tempfile.TemporaryDirectory() as folder:
        outcomes = [shown(path, number, len(paths), options, folder) for number, path in enumerate(paths, 1)]
    counts = {v: sum(o.verdict == v for o in outcomes) for v in ("passed", "failed", "skipped")}
    if options.json:
        print(json.dumps({"tolerance": TOLERANCE, "states": options.states, **counts, "robots": [asdict(o) for o in outcomes]},
                         ensure_ascii=False, indent=1))
    else:
        print(f"worst scaled error of {options.states} states a robot, at most {TOLERANCE:g} (! marks more; errors.py defines the scales)")
        print("{passed} passed, {failed} failed, {skipped} skipped".format(**counts))
    sys.exit(1 if counts["failed"] or not counts["passed"] else 0)


if __name__ == "__main__":
    main()
