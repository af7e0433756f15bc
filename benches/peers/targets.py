"""What was aimed at, and whether it is met."""

from figures import SIDE_BY_SIDE, ONE_STATE

SMALL, LARGE = "n ≤ 12", "29 ≤ n ≤ 44"

# What, whose fastest counts, work, and how many times as fast as Pinocchio at least.
FASTER = [
    ("Λ_b, A_l, Λ_q", ONE_STATE, "inertia", 6, 4),
    ("the same with D_μ, B_2", ONE_STATE, "matrices", 8, 6),
    ("the same, 4 or 8 lanes", SIDE_BY_SIDE, "matrices", 25, 15),
    ("ξ̇", ONE_STATE, "forward", 3, 2.5),
    ("ξ̇, 4 or 8 lanes", SIDE_BY_SIDE, "forward", 15, 10),
    ("generic core: Λ_b, A_l, Λ_q, D_μ, B_2", ["core"], "matrices", 2, 3),
]
COMPILED = 0.7  # of rustc's speed, at least
LIMIT, LIMIT_IN_LANES = 3, 4  # of the time that two operations a cycle would take, at most


def verdict(values, bound, at_least):
    """The range, the robot at its bad end, and whether that is good enough; `values` are (value, robot)."""
    values = sorted((value, name) for value, name in values if value is not None)
    if not values:
        return "–"
    (least, slow), (most, far) = values[0], values[-1]
    met = least >= bound if at_least else most <= bound
    sign = "≥" if at_least else "≤"
    return f"{least:.2g}–{most:.2g} ({slow if at_least else far}); {sign} {bound}: {'met' if met else '**not met**'}"


def rows(robots):
    groups = {
        SMALL: [robot for robot in robots if robot.n <= 12 and not robot.is_chain],
        LARGE: [robot for robot in robots if 29 <= robot.n <= 44 and not robot.is_chain],
    }
    found = []
    for what, contestants, work, *bounds in FASTER:
        cells = [
            verdict([(robot.best(contestants, work), robot.name) for robot in group], bound, True)
            for group, bound in zip(groups.values(), bounds)
        ]
        found.append([what, *cells])
    works = ["inertia", "matrices", "forward"]

    def speed(robot, work):
        ready, rustc = robot.time("compiled", work), robot.time("generated", work)
        return rustc / ready if ready and rustc else None

    def line(what, of, bound, at_least):
        found.append([what, *(verdict([(of(robot, work), robot.name) for robot in group for work in works], bound, at_least)
                              for group in groups.values())])

    line("compiled at run time, speed of rustc's", speed, COMPILED, True)
    line("time / limit, one state", lambda robot, work: robot.from_limit("generated", work), LIMIT, False)
    line("time / limit, 8 lanes", lambda robot, work: robot.from_limit("generated_8", work), LIMIT_IN_LANES, False)
    return ["times as fast as Pinocchio (clang)", *groups], found
