"""The paper's scene, by `frs accuracy --peers`: what each error costs us, and MuJoCo and Pinocchio that step to the same."""

import json
import shutil
import subprocess
import sys

import plan

ASKED = [1e-3, 1e-6, 1e-9]


def costs(frs, cpu):
    """What `frs accuracy` tells."""
    pin = ["taskset", "-c", cpu] if shutil.which("taskset") else []
    command = [*pin, frs, "accuracy", plan.ROOT / "scenes/paper.toml", f"--peers={sys.executable}", "--json"]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def rows(costs):
    """Milliseconds a simulated second of the cheapest motion for each error, by program and method."""
    duration, motions = costs["duration"], costs["peers"]["motions"]
    curves = list(dict.fromkeys((motion["program"], motion["method"]) for motion in motions))
    told = lambda seconds: f"{1000 * seconds / duration:.3g}"

    def cheapest(curve, want):
        enough = [motion["seconds"] for motion in motions if (motion["program"], motion["method"]) == curve and motion["error"] <= want]
        return told(min(enough)) if enough else "–"

    found = []
    for want in ASKED:
        own = next((entry["choice"] for entry in costs["recommended"] if entry["want"] == want), None)
        ours = f"{told(own['seconds'])} ({own['settings']})" if own else "–"
        found.append([f"{want:.0e}", ours, *(cheapest(curve, want) for curve in curves)])
    return ["for", "frs", *(" ".join(curve) for curve in curves)], found
