"""The machine of a race and what was compiled with what."""

import os
import platform
import subprocess
from importlib.metadata import version
from pathlib import Path


def last_core():
    """The core that a system uses least, by habit."""
    return str((os.cpu_count() or 1) - 1)


def first_line(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True).stdout.partition("\n")[0]
    except FileNotFoundError:
        return "none"


def processor():
    cpuinfo = Path("/proc/cpuinfo")
    lines = cpuinfo.read_text().splitlines() if cpuinfo.exists() else []
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    wide = "avx512f" in next((line for line in lines if line.startswith("flags")), "").split()
    return (names[0] if names else platform.processor()) + (", AVX-512" if wide else "")


def described(cpu, clang):
    packages = {"Pinocchio": "pin", "Eigen": "cmeel-eigen", "MuJoCo": "mujoco", "CasADi": "casadi"}
    return {"processor": processor(), "core": cpu} | {name: version(package) for name, package in packages.items()} | {
        "dynibo": "0.5.3", "clang": first_line(clang, "--version"), "gcc": first_line("g++", "--version"),
        "rustc": first_line("rustc", "--version"), "load": [round(load, 1) for load in os.getloadavg()],
    }
