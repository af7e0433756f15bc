"""Programs that take part in the race of a robot, each on a pipe (serve.hpp says what they are asked)."""

import contextlib
import json
import shutil
import subprocess
from pathlib import Path

import numpy as np

import build

# Where Pinocchio has our velocities.
LINEAR_FIRST = lambda nv: np.r_[3:6, 0:3, 6:nv]


class Program:
    """A program with one contestant or several; `order` is where it has our velocities, `truth` what it must say.

    A choosy one may refuse a robot.
    """

    def __init__(self, command, truth, order, choosy=False):
        self.command, self.truth, self.order, self.choosy = [str(word) for word in command], truth, order, choosy
        self.process, self.works = None, {}

    def start(self, cpu):
        pin = ["taskset", "-c", cpu] if shutil.which("taskset") else []
        self.process = subprocess.Popen([*pin, *self.command], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.works = self.ask("list")

    def ask(self, *words):
        try:
            self.process.stdin.write(" ".join(map(str, words)) + "\n")
            self.process.stdin.flush()
            line = self.process.stdout.readline()
        except BrokenPipeError:
            line = ""
        if not line and self.choosy and words == ("list",):
            build.say(f"{Path(self.command[0]).name} refuses {Path(self.command[1]).stem}, see above")
            return {}
        if not line:
            build.stop(f"{self.command[0]} ended with code {self.process.wait()} when asked {' '.join(map(str, words))}")
        return json.loads(line)

    def end(self):
        with contextlib.suppress(BrokenPipeError):
            self.process.stdin.close()
        self.process.wait()


def of(robot, folder, programs, compiled):
    """The programs of one robot; `compiled` are the quantities that we compile at run time."""
    name, nv = robot.path.stem, robot.model.nv
    file = lambda ending: folder / f"{name}.{ending}"
    straight = np.arange(nv)
    own = Program([programs["frs"] / f"race_{name}", robot.path, file("own"), ",".join(compiled) or "-"], "reduced",
                  np.arange(6 + robot.n))
    found = [own]
    for peer in ("pinocchio", "pinocchio_gcc", "pinocchio_wheel"):
        if peer in programs:
            found.append(Program([programs[peer], peer, file("txt")], "tree", LINEAR_FIRST(nv)))
    if name in programs["casadi"]:
        found.append(Program([programs["casadi"][name], "casadi", file("tree")], "tree", straight))
    if name in programs["mujoco_orders"]:
        order = programs["mujoco_orders"][name]
        found.append(Program([programs["mujoco"], "mujoco", file("mjb"), file("mujoco")], "tree", order))
    names = ",".join(joint for joint, _ in robot.joints)
    found.append(Program([programs["dynibo"], robot.path, file("tree"), names], "tree", straight, choosy=True))
    return found
