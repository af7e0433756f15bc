"""Asks `frs eval` and reads its answer back into the shape of a `Reference`."""

import json
import os
import subprocess

import numpy as np

from reference import Reference

KEYS = ["hamel_m", "hamel_c", "hamel_bias", "locked_inertia", "connection", "shape_inertia", "p", "momentum", "energy",
        "d_mu", "d_qdot", "xi_dot"]


class Refused(Exception):
    """frs rejected the robot (exit code 2); the message is its own."""

    @property
    def first(self):
        """Its first line, if it said anything."""
        return next(iter(str(self).splitlines()), "no message")


class Broken(Exception):
    """frs answered outside its contract."""


def evaluate(robot_path, lines, lenient=False, keys=KEYS):
    """One dictionary per line of states, with `keys`."""
    command = [os.environ["FRS_BIN"], "eval", str(robot_path), "--states", "-", "--only", ",".join(keys)]
    done = subprocess.run(command + ["--lenient"] * lenient, input="\n".join(lines) + "\n", capture_output=True, text=True)
    if done.returncode == 2:
        raise Refused(done.stderr.strip())
    answers = [json.loads(line) for line in done.stdout.splitlines()]
    failed = sum("error" in answer for answer in answers)
    if done.returncode != (1 if failed else 0) or len(answers) != len(lines):
        said = done.stderr.strip() or "nothing on stderr"
        raise Broken(f"exit code {done.returncode}, {len(answers)} answers to {len(lines)} states, {failed} errors: {said}")
    return answers


def reading(answer, names, xi):
    """The answer as a `Reference`, its joints in the order of `names`; `drift` is (D_q̇ − D_μ) ξ."""
    if sorted(answer["joints"]) != sorted(names):
        raise Broken(f"coordinates {sorted(answer['joints'])}; expected {sorted(names)}")
    n = len(names)
    joints = np.array([answer["joints"].index(name) for name in names], dtype=int)
    every = np.concatenate([np.arange(6), 6 + joints])

    def take(key, *orders):
        counts = [len(order) if order is joints else 6 + n if order is every else 6 for order in orders]
        return np.array(answer[key], dtype=float).reshape(counts)[np.ix_(*orders)]

    base = np.arange(6)
    return Reference(
        M=take("hamel_m", every, every), terms=None, C=take("hamel_c", every, every), bias=take("hamel_bias", every),
        locked=take("locked_inertia", base, base), connection=take("connection", base, joints),
        shape=take("shape_inertia", joints, joints), p=take("p", base, base), momentum=take("momentum", base),
        energy=float(answer["energy"]), xi=xi,
        drift=(take("d_qdot", every, every) - take("d_mu", every, every)) @ xi,
        xi_dot=take("xi_dot", every),
    )
