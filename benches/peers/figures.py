"""What the samples of a race say: medians, tenths, ratios."""

import json
import statistics
from pathlib import Path

import numpy as np

import plan

# One state at a time, and several side by side.
ONE_STATE = ["hybrid", "generated", "compiled", "core"]
SIDE_BY_SIDE = ["generated_4", "generated_8", "core_4", "core_8"]


class Robot:
    """The samples of one robot."""

    def __init__(self, name, entry):
        self.name, self.n, self.contestants = name, entry["n"], entry["contestants"]
        self.code, self.clock = entry["code"], statistics.median(entry["clock"])
        self.is_chain = name.startswith("chain_")

    def samples(self, contestant, work, kind="ns"):
        """Of a work; where Pinocchio has two conventions, of the faster one."""
        works = self.contestants.get(contestant, {})
        found = [works[name][kind] for name in (work, f"{work}_local", f"{work}_world") if name in works]
        return min(found, key=statistics.median, default=None)

    def time(self, contestant, work, kind="ns"):
        """Nanoseconds a state."""
        samples = self.samples(contestant, work, kind)
        return None if samples is None else statistics.median(samples)

    def tenths(self, contestant, work):
        """Of ten samples, the second and the last but one."""
        return np.percentile(self.samples(contestant, work), [10, 90])

    def peer_work(self, contestant, work):
        """What a contestant calls it."""
        ours = contestant.startswith(("core", "generated", "hybrid", "single", "compiled"))
        return work if ours else plan.WORKS[work][1]

    def times_faster(self, contestant, work, kind="ns"):
        """How many times as fast as Pinocchio compiled by clang; none where one of them does not do it."""
        own = self.time(contestant, self.peer_work(contestant, work), kind)
        peer = self.time("pinocchio", plan.WORKS[work][1], kind)
        return peer / own if own and peer else None

    def best(self, contestants, work):
        """The fastest of them, as above."""
        return max(filter(None, (self.times_faster(one, work) for one in contestants)), default=None)

    def operations(self, form, work):
        """Recorded operations of a work, + − × ÷ √."""
        counts = [self.code.get(form, {}).get(quantity, {}).get("operations") for quantity in plan.WORKS[work][0]]
        return sum(counts) if counts and None not in counts else None

    def from_limit(self, form, work):
        """Time as a multiple of what two operations a cycle would take, or two of all lanes."""
        time, operations = self.time(form, work), self.operations(form, work)
        if not time or not operations:
            return None
        return time * plan.LANES.get(form, 1) * self.clock / (operations / 2)


def read(path):
    """The machine, the robots by size, and the scene if it was raced."""
    race = json.loads(Path(path).read_text())
    robots = [Robot(name, entry) for name, entry in race["robots"].items()]
    robots.sort(key=lambda robot: (robot.is_chain, robot.n, robot.name))
    return race["machine"], robots, race.get("scene")
