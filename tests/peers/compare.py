"""Compares `frs eval` with Pinocchio: every quantity of every state within TOLERANCE, or the expected refusal."""

import argparse
import json
import os
import sys
from dataclasses import asdict, dataclass, field
from pathlib import Path

try:
    import catalogue
    import expected
    from errors import KEYS, TOLERANCE, errors
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


def refused_as_expected(label, refusal, words):
    """An expected refusal passes if its message says the right thing."""
    first = str(refusal).splitlines()[0] if str(refusal) else "no message"
    if words in str(refusal):
        return Outcome(label, "passed", note=f"refused, as it should be: {first}")
    return Outcome(label, "failed", note=f"refused, but not for “{words}”: {first}")


def compare(path, count):
    label = catalogue.label(path)
    words = expected.REFUSED.get(label) or expected.LENIENT.get(label)
    if words:
        try:
            evaluate(path, ["{}"])
            return Outcome(label, "failed", note=f"accepted, but should be refused for “{words}” (see expected.py)")
        except Refused as refusal:
            refusal = refused_as_expected(label, refusal, words)
            if label in expected.REFUSED or refusal.verdict == "failed":
                return refusal
    try:
        robot = Robot(path)
    except Unusable as reason:
        return Outcome(label, "skipped", note=str(reason))

    states = list(robot.states(count))
    theirs = [reference(robot, state) for state in states]
    lines = [state.line(robot.names) for state in states]
    lenient, note = label in expected.LENIENT, ""
    try:
        if all(one.xi_dot is not None for one in theirs):
            answers = evaluate(path, lines, lenient=lenient)
        else:
            # A motion without inertia: no acceleration exists, ours must say so, and the rest is still compared.
            note = "singular mass matrix: ξ̇ refused by both"
            for answer in evaluate(path, lines, lenient=lenient):
                if "singular" not in answer.get("error", ""):
                    return Outcome(label, "failed", robot.n, note="M is singular, but frs returned an acceleration")
            answers = evaluate(path, lines, with_acceleration=False, lenient=lenient)
        worst = {}
        for state, ours, reference_ in zip(states, answers, theirs):
            if "error" in ours:
                raise Broken(ours["error"])
            found = errors(reading(ours, robot.names, reference_.xi), reference_, state)
            for key, error in found.items():
                worst[key] = max(error, worst.get(key, 0.0))
    except (Refused, Broken) as problem:
        return Outcome(label, "failed", robot.n, note=str(problem).splitlines()[0])
    except (KeyError, ValueError) as problem:
        return Outcome(label, "failed", robot.n, note=f"unreadable answer: {type(problem).__name__}: {problem}")
    good = all(error <= TOLERANCE for error in worst.values())
    return Outcome(label, "passed" if good else "failed", robot.n, worst, note)


def row(outcome):
    """One line of the table; an error above the tolerance is marked."""
    mark = {"passed": "ok  ", "failed": "FAIL", "skipped": "skip"}[outcome.verdict]
    cells = f"{mark} {outcome.robot:<42} {'' if outcome.n is None else outcome.n:>3}"
    if outcome.errors:
        for key in KEYS:
            error = outcome.errors.get(key)
            shown = "-" if error is None else f"{error:.0e}" + ("!" if error > TOLERANCE else " ")
            cells += f" {shown:>8}"
    return cells + (f"  {outcome.note}" if outcome.note else "")


def main():
    parser = argparse.ArgumentParser(prog="tests/peers/run", description=__doc__)
    parser.add_argument("urdf", nargs="*", type=Path, help="compare only these (default: all)")
    parser.add_argument("--states", type=int, default=20, help="random states a robot (default %(default)s)")
    parser.add_argument("--json", action="store_true", help="print one JSON document instead of the table")
    options = parser.parse_args()
    try:
        if "FRS_BIN" not in os.environ:
            raise FileNotFoundError("FRS_BIN is not set; start this through tests/peers/run")
        paths = [path.resolve(strict=True) for path in options.urdf] or catalogue.urdfs()
    except FileNotFoundError as missing:
        print(f"peers: {missing}", file=sys.stderr)
        sys.exit(2)

    outcomes = []
    if not options.json:
        print(f"     {'robot':<42} {'n':>3}" + "".join(f" {key:>7} " for key in KEYS))
    for number, path in enumerate(paths, 1):
        if sys.stderr.isatty():
            print(f"\r\x1b[K[{number}/{len(paths)}] {catalogue.label(path)}", end="", file=sys.stderr, flush=True)
        outcomes.append(compare(path, options.states))
        if sys.stderr.isatty():
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)
        if not options.json:
            print(row(outcomes[-1]), flush=True)

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
