"""Joins the samples of both sides: report.py SAMPLES.json REPORT.json prints Markdown, writes JSON.

A time is the median over the rounds of a round's least sample: the least is the one that no other program interrupted,
the median keeps a lucky round out. A ratio is ours / theirs, so that below one we are faster.
"""

import json
import os
import platform
import statistics
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

# Heading, our work, their works: where Pinocchio has two algorithms, the faster one on that robot counts.
PAIRS = [
    ("position sweep / crba", "position_sweep", ["crba_local", "crba_world"]),
    ("Λ_b, A_l, Λ_q / crba + split", "inertia", ["crba_split_local", "crba_split_world"]),
    ("Λ_b, A_l, Λ_q, D_μ, B_2 / crba + coriolis", "inertia_coupling", ["crba_coriolis_local", "crba_coriolis_world"]),
    ("the same / both split", "inertia_coupling", ["crba_coriolis_split_local", "crba_coriolis_split_world"]),
    ("ξ̇ factored / aba", "forward_factored", ["aba_local", "aba_world"]),
    ("ξ̇ articulated / aba", "forward_articulated", ["aba_local", "aba_world"]),
]
ALONE = ["kinematics", "rnea", "coriolis"]  # of Pinocchio, to compare machines


def first_line(*command):
    return subprocess.run(command, capture_output=True, text=True).stdout.partition("\n")[0]


def processor():
    cpuinfo = Path("/proc/cpuinfo")
    lines = cpuinfo.read_text().splitlines() if cpuinfo.exists() else []
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), platform.processor())


def main(samples, output):
    robots = {}
    for entry in json.loads(Path(samples).read_text()):
        robot = robots.setdefault(entry["robot"], {"n": {}, "frs": {}, "pinocchio": {}})
        robot["n"][entry["side"]] = entry["n"]
        robot[entry["side"]][entry["work"]] = statistics.median(map(min, entry["ns"]))
    built = {
        "processor": processor(), "pinocchio": version("pin"), "eigen": version("cmeel-eigen"),
        "clang": first_line(os.environ.get("CXX", "clang++"), "--version"), "rustc": first_line("rustc", "--version"),
    }

    rows = []
    for name, robot in robots.items():
        row = {"robot": name, "n": robot["n"], "pairs": {}, "ns": {"frs": robot["frs"], "pinocchio": robot["pinocchio"]}}
        for heading, ours, theirs in PAIRS:
            mine = robot["frs"].get(ours)
            peer = min((robot["pinocchio"][work] for work in theirs if work in robot["pinocchio"]), default=None)
            ratio = mine / peer if mine and peer else None
            row["pairs"][heading] = {"frs_ns": mine, "pinocchio_ns": peer, "ratio": ratio}
        rows.append(row)
    rows.sort(key=lambda row: (max(row["n"].values()), row["robot"]))
    Path(output).write_text(json.dumps({"built": built, "robots": rows}, ensure_ascii=False, indent=1) + "\n")

    micro = lambda ns: "–" if ns is None else f"{ns / 1000:.3g}" if ns < 1e5 else f"{ns / 1000:.0f}"
    headings = [heading for heading, *_ in PAIRS]
    print("Microseconds a call, frs / Pinocchio = ratio; below one, frs is faster. One core, floating base.")
    print("n counts frs's coordinates; Pinocchio's tree, in brackets where it differs, keeps mimic joints.")
    print(" · ".join(f"{what} {which}" for what, which in built.items()) + "\n")
    print("| robot | n | " + " | ".join(headings + [f"Pinocchio {work}" for work in ALONE]) + " |")
    print("|---|---|" + "---|" * (len(headings) + len(ALONE)))
    for row in rows:
        cells = []
        for heading in headings:
            pair = row["pairs"][heading]
            times = f"{micro(pair['frs_ns'])} / {micro(pair['pinocchio_ns'])}"
            cells.append(times if pair["ratio"] is None else f"{times} = **{pair['ratio']:.2f}**")
        cells += [micro(row["ns"]["pinocchio"].get(work)) for work in ALONE]
        ours, theirs = row["n"].get("frs"), row["n"]["pinocchio"]
        n = theirs if ours in (None, theirs) else f"{ours} ({theirs})"
        print(f"| {row['robot']} | {n} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main(*sys.argv[1:])
