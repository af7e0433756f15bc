"""Pictures of a race: picture.py RACE.json FOLDER  draws peers.svg (ratios) and growth.svg (chains)."""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("svg")
from matplotlib import pyplot  # noqa: E402

import growth  # noqa: E402
from figures import read  # noqa: E402

WORKS = {"inertia": "Λ_b, A_l, Λ_q", "matrices": "Λ_b, A_l, Λ_q, D_μ, B_2", "forward": "ξ̇", "curvature": "curvature"}
COLOURS = {
    "casadi": ("CasADi's C", "#b0b0b0"), "mujoco": ("MuJoCo", "#8a8a8a"), "dynibo": ("dynibo", "#666666"),
    "core": ("core", "#9ecae1"), "compiled": ("compiled at run time", "#4292c6"), "generated": ("generated", "#08519c"), "hybrid": ("generated, hybrid form", "#31a354"),
    "core_8": ("core, 8 lanes", "#fdae6b"), "generated_8": ("generated, 8 lanes", "#d94801"),
}
STYLES = {"pinocchio": "#666666", "core": "#4292c6", "generated": "#08519c"}


def ratios(robots, path):
    figure, axes = pyplot.subplots(len(WORKS), 1, figsize=(12, 13), layout="constrained")
    for axis, (work, title) in zip(axes, WORKS.items()):
        here = [one for one in COLOURS if any(robot.times_faster(one, work) for robot in robots)]
        width = 0.85 / max(len(here), 1)
        for place, one in enumerate(here):
            label, colour = COLOURS[one]
            bars = [(k + (place - (len(here) - 1) / 2) * width, robot.times_faster(one, work)) for k, robot in enumerate(robots)]
            bars = [(x, height) for x, height in bars if height]
            places, heights = zip(*bars)
            # From the line up, or down.
            drawn = axis.bar(places, [height - 1 for height in heights], width, bottom=1, label=label, color=colour)
            axis.bar_label(drawn, [f"{height:.2g}" for height in heights], fontsize=6, rotation=90, padding=2)
        axis.axhline(1.0, color="black", linewidth=0.8)
        axis.set_yscale("log")
        axis.margins(y=0.15)
        axis.set_title(f"{title}: times as fast as Pinocchio, clang -O3 -march=native (the line)", loc="left")
        axis.set_xticks(range(len(robots)), [f"{robot.name} ({robot.n})" for robot in robots])
    handles = dict(zip(*reversed([sum(parts, []) for parts in zip(*(axis.get_legend_handles_labels() for axis in axes))])))
    figure.legend(handles.values(), handles.keys(), loc="outside lower center", ncols=(len(handles) + 1) // 2)
    figure.savefig(path, metadata={"Date": None})


def chains(robots, path):
    figure, axes = pyplot.subplots(1, 2, figsize=(12, 4.5), layout="constrained")
    for axis, work in zip(axes, ("matrices", "forward")):
        for one, colour in STYLES.items():
            points = [(robot.n, growth.per_joint(robot, one, work)) for robot in robots]
            points = [(n, time) for n, time in points if time]
            if points:
                axis.plot(*zip(*points), "o-", label=one, color=colour)
        axis.set(xlabel="joints", ylabel="ns a joint", xscale="log", title=WORKS[work])
        axis.set_ylim(bottom=0)
        axis.set_xticks([robot.n for robot in robots], [str(robot.n) for robot in robots], minor=False)
        axis.legend()
    figure.savefig(path, metadata={"Date": None})


def main(race, folder):
    # The same text gives the same file.
    matplotlib.rcParams["svg.hashsalt"] = "peers"
    _, robots, _ = read(race)
    ratios([robot for robot in robots if not robot.is_chain], Path(folder) / "peers.svg")
    of_chains = [robot for robot in robots if robot.is_chain]
    if of_chains:
        chains(of_chains, Path(folder) / "growth.svg")


if __name__ == "__main__":
    main(*sys.argv[1:])
