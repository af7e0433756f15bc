"""What is raced: robots, works, our forms, and who is beside us."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "peers"))

OWN = ["lwr_satellite", "quadruped", "humanoid"]
PUBLIC = {
    "ur5_robot": "ur_description/urdf", "xarm7": "xarm_description/urdf", "panda": "panda_description/urdf",
    "solo12": "solo_description/robots", "talos_reduced": "talos_data/robots", "g1_29dof_rev_1_0": "g1_description/urdf",
}
CHAINS = [10, 20, 50, 100, 200]
QUICK = ["ur5_robot", "quadruped", "chain_20"]

# Our works, the quantities of a generated robot that they are made of, and the peers' work of the same result.
WORKS = {
    "position_sweep": ([], "mass"),
    "inertia": (["inertia"], "inertia"),
    "matrices": (["matrices"], "matrices"),
    "all_d": (["matrices", "d_qdot"], "matrices"),
    "forward": (["forward_dynamics"], "forward"),
    "forward_factored": ([], "forward"),
    "curvature": (["curvature"], "curvature"),
}

# Forms of generated code: how `frs generate` is asked for them, and the works that they are generated for.
FORMS = {
    "generated": ([], ["inertia", "matrices", "all_d", "forward", "curvature"]),
    "hybrid": (["--form", "hybrid"], ["inertia", "matrices", "forward", "curvature"]),
    "generated_4": (["--lanes", "4"], ["inertia", "matrices", "forward"]),
    "generated_8": (["--lanes", "8"], ["inertia", "matrices", "forward"]),
    "single_8": (["--lanes", "8", "--f32"], ["inertia", "matrices", "forward"]),
    "single_16": (["--lanes", "16", "--f32"], ["inertia", "matrices", "forward"]),
}
LANES = {"core_4": 4, "core_8": 8, "generated_4": 4, "generated_8": 8, "single_8": 8, "single_16": 16}

# Joints beyond which straight-line code of a work is not made: matrices grow with their square, a sweep does not.
LONGEST = {"inertia": 50, "matrices": 50, "all_d": 35, "forward": 100, "curvature": 35}
LONGEST_IN_LANES = {"inertia": 50, "matrices": 35, "forward": 50}
# The same for CasADi, whose C takes minutes to compile beyond.
LONGEST_SYMBOLIC = {"inertia": 35, "matrices": 12, "forward": 35, "curvature": 12}


def robots(prefix, chains):
    """Name and URDF of each robot."""
    found = {name: ROOT / "robots" / f"{name}.urdf" for name in OWN}
    data = prefix / "share/example-robot-data/robots"
    found |= {name: data / folder / f"{name}.urdf" for name, folder in PUBLIC.items()}
    found |= {f"chain_{n}": chains / f"chain_{n}.urdf" for n in CHAINS}
    return found


def generated_works(form, n):
    """The works for which a robot of n coordinates has this form."""
    longest = LONGEST_IN_LANES if form in LANES else LONGEST
    return [work for work in FORMS[form][1] if n <= longest[work]]


def quantities(works):
    """What makes up these works, each once."""
    return sorted({quantity for work in works for quantity in WORKS[work][0]})
