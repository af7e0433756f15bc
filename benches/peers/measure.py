"""Compares the answers of all contestants, then times them in turn: work by work, round by round, on one core."""

import statistics
import sys

import build
import question

COMPARED = 16  # states
COMPARED_LARGE = 4  # of robots beyond a hundred joints
PASSES = 3  # over every 32 states, a sample; the fastest one counts
COLD_ROUNDS = 3
TOLD = 5  # differences, at most
SINGLE = "single"  # contestants of this name compute in single precision


def compare(programs, questions, n):
    """The largest error of each contestant's work; stops if one is not the same."""
    found, wrong = {}, []
    for state, asked in enumerate(questions[: COMPARED if n <= 100 else COMPARED_LARGE]):
        for program in programs:
            truth = getattr(asked, program.truth)
            for contestant, works in program.works.items():
                for work in works:
                    errors = truth.errors(program.ask("answer", contestant, work, state), program.order)
                    worst = max(errors.values(), default=0.0)
                    key = (contestant, work)
                    found[key] = max(found.get(key, 0.0), worst)
                    limit = question.SAME_SINGLE if contestant.startswith(SINGLE) else question.SAME
                    if not worst <= limit:
                        wrong.append(f"{contestant} {work} at state {state}: {errors}")
    if wrong:
        build.say(f"{questions[0].robot.path.stem}: not the same numbers:\n  " + "\n  ".join(wrong[:TOLD]))
        sys.exit(1)
    return found


def turns(programs, backwards):
    """(program, contestant, work), so that those who do the same work follow each other."""
    everyone = [(p, c, w) for p in programs for c, works in p.works.items() for w in works]
    return sorted(everyone, key=lambda turn: turn[2].removesuffix("_local").removesuffix("_world"), reverse=backwards)


def race(programs, rounds):
    """Samples {(contestant, work): [ns a round]}, warm and cold, and cycles a nanosecond round by round."""
    warm, cold, clock = {}, {}, []
    for number in range(rounds):
        # Whoever runs second finds the core warm: take turns at that, too.
        for program, contestant, work in turns(programs, number % 2 == 1):
            warm.setdefault((contestant, work), []).append(program.ask("time", contestant, work, PASSES))
            if number < COLD_ROUNDS:
                cold.setdefault((contestant, work), []).append(statistics.median(program.ask("cold", contestant, work)))
        clock.append(programs[0].ask("clock"))
    return warm, cold, clock


def measured(programs, questions, n, cpu, rounds):
    """All of one robot, as JSON has it."""
    for program in programs:
        program.start(cpu)
    errors = compare(programs, questions, n)
    warm, cold, clock = race(programs, rounds)
    for program in programs:
        program.end()
    found = {}
    for (contestant, work), times in warm.items():
        entry = {"error": errors[contestant, work], "ns": times, "cold_ns": cold[contestant, work]}
        found.setdefault(contestant, {})[work] = entry
    return {"n": n, "clock": clock, "contestants": found}
