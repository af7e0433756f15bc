"""The tables of a race: report.py RACE.json [FILE]  prints Markdown, or puts it between the marks of a file."""

import contextlib
import io
import sys
from pathlib import Path

import growth
import plan
import scene
import targets
from figures import read

HEADINGS = {
    "position_sweep": "All that depends on q alone, against M (`crba`)",
    "inertia": "Λ_b, A_l, Λ_q, against `crba` + base solve + Schur complement",
    "matrices": "Λ_b, A_l, Λ_q, D_μ, B_2, against `crba` + `computeCoriolisMatrix`, both brought to (μ, q̇)",
    "all_d": "The same and D_q̇, against the same",
    "forward": "ξ̇, against `aba`",
    "forward_factored": "ξ̇ by factoring Λ_q, against `aba`",
    "curvature": "𝓑_ω of all pairs, against `crba`, split, and C in (μ, q̇) for three momenta",
}
BEGIN, END = "<!-- race -->", "<!-- /race -->"
PEERS = ["pinocchio_gcc", "pinocchio_wheel", "casadi", "mujoco", "dynibo"]
OURS = ["core", "core_4", "core_8", "compiled", "generated", "hybrid", "generated_4", "generated_8", "single_8", "single_16"]
TITLES = {
    "pinocchio_gcc": "gcc", "pinocchio_wheel": "wheel", "casadi": "CasADi", "mujoco": "MuJoCo", "core_4": "core, 4 lanes",
    "core_8": "core, 8 lanes", "compiled": "at run time", "generated_4": "4 lanes", "generated_8": "8 lanes", "single_8": "8 × f32",
    "single_16": "16 × f32",
}


def table(heading, columns, rows):
    print(f"\n**{heading}**\n")
    print(f"| {' | '.join(columns)} |")
    print("|---" * len(columns) + "|")
    for row in rows:
        print(f"| {' | '.join(row)} |")


def micro(ns):
    return f"{ns / 1000:.3g}" if ns < 1e6 else f"{ns / 1000:.0f}"


def times(value):
    return "–" if value is None else f"{value:.2f}" if value < 10 else f"{value:.1f}"


def work_table(work, robots):
    """Pinocchio's time, and how many times as fast everyone else is."""
    here = [one for one in PEERS + OURS if any(robot.times_faster(one, work) for robot in robots)]
    if not any(one in OURS for one in here):
        return
    # For comparison with tables that leave this out.
    untransformed = work == "matrices"
    rows = []
    for robot in robots:
        peer = plan.WORKS[work][1]
        if robot.time("pinocchio", peer) is None:
            continue
        low, high = robot.tenths("pinocchio", peer)
        time = f"{micro(robot.time('pinocchio', peer))} ({micro(low)}–{micro(high)})"
        alone = [times(robot.time("pinocchio", peer) / robot.time("pinocchio", "mass_coriolis"))] if untransformed else []
        rows.append([robot.name, str(robot.n), time, *alone, *(times(robot.times_faster(one, work)) for one in here)])
    titles = ["as they are"] * untransformed + [TITLES.get(one, one) for one in here]
    table(HEADINGS[work], ["robot", "n", "Pinocchio, clang, µs (10–90 %)", *titles], rows)


def code_table(robots):
    """Operations, machine code and distance from the limit."""
    rows = []
    for robot in robots:
        for work in ("inertia", "matrices", "forward", "curvature"):
            quantity = plan.WORKS[work][0][0]
            code = robot.code.get("generated", {}).get(quantity)
            if not code:
                continue
            kibibytes = f"{code['bytes'] / 1024:.0f}" if "bytes" in code else "–"
            stack = f"{100 * code['stack']:.0f} %" if "stack" in code else "–"
            limits = [times(robot.from_limit(form, work)) for form in ("generated", "generated_4", "generated_8", "single_8", "single_16")]
            hybrid = robot.code.get("hybrid", {}).get(quantity, {})
            hybrid = [f"{hybrid['operations']:,}" if hybrid else "–", f"{hybrid['bytes'] / 1024:.0f}" if "bytes" in hybrid else "–"]
            rows.append([robot.name, f"`{quantity}`", f"{code['operations']:,}", kibibytes, stack, *limits, *hybrid, times(robot.from_limit("hybrid", work))])
    columns = ["robot", "quantity", "operations", "code, KiB", "on the stack", "time / limit", "4 lanes", "8 lanes", "8 × f32", "16 × f32", "hybrid: operations", "code, KiB", "time / limit"]
    table("Generated code beside the limit of two operations a cycle", columns, rows)


def cold_table(robots):
    """One state at a time, with empty caches."""
    rows = []
    for robot in robots:
        for work in ("inertia", "matrices", "forward"):
            cells = []
            for one in ("pinocchio", "core", "compiled", "generated", "hybrid"):
                name = robot.peer_work(one, work)
                warm, cold = robot.time(one, name), robot.time(one, name, "cold_ns")
                cells.append("–" if warm is None else f"{micro(warm)} / {micro(cold)}")
            rows.append([robot.name, work, *cells])
    table("Warm / cold, µs a state", ["robot", "work", "Pinocchio, clang", "core", "at run time", "generated", "hybrid"], rows)


def tables(path):
    machine, robots, costs = read(path)
    print(" · ".join(f"{what} {which}" for what, which in machine.items()))
    print(f"\nLargest difference of answers: {worst(robots)}.")
    table("Targets", *targets.rows(robots))
    for work in HEADINGS:
        work_table(work, robots)
    code_table(robots)
    if any(robot.is_chain for robot in robots):
        table("Nanoseconds a joint on chains", *growth.rows([robot for robot in robots if robot.is_chain]))
    cold_table([robot for robot in robots if not robot.is_chain])
    if costs:
        table("The paper's scene, milliseconds a simulated second", *scene.rows(costs))


def worst(robots):
    """Of doubles and of singles."""
    found = {False: [], True: []}
    for robot in robots:
        for contestant, works in robot.contestants.items():
            for work, entry in works.items():
                found[contestant.startswith("single")].append((entry["error"], f"{contestant}, {work}, {robot.name}"))
    told = [f"{max(errors)[0]:.1e} ({max(errors)[1]})" for errors in found.values() if errors]
    return "; in single precision ".join(told)


def main(race, file=None):
    if file is None:
        return tables(race)
    text = io.StringIO()
    with contextlib.redirect_stdout(text):
        tables(race)
    before, _, rest = Path(file).read_text().partition(BEGIN)
    _, _, after = rest.partition(END)
    Path(file).write_text(f"{before}{BEGIN}\n{text.getvalue()}{END}{after}")


if __name__ == "__main__":
    main(*sys.argv[1:])
