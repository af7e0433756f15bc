"""The whole race: race.py [--quick] [--rounds N] [--cpu K] [--robots A,B] [--no-scene] OUT  writes OUT/race.json."""

import argparse
import json
import subprocess
import sys
from pathlib import Path

import build
import chains
import code_size
import contestants
import crate
import describe
import machine
import measure
import mujoco_model
import plan
import scene
import symbolic
import symbolic_works
from question import Question
from reference import angular_first
from robot import Robot


def prepared(folder, robots):
    """States and descriptions of every robot, and its questions."""
    questions, orders = {}, {}
    for name, robot in robots.items():
        questions[name] = [Question(robot, state) for state in robot.states(describe.STATES)]
        describe.write(folder, robot, angular_first(robot.model.nv), questions[name])
        orders[name] = mujoco_order(folder, robot, questions[name])
    return questions, {name: order for name, order in orders.items() if order is not None}


def order_as_ours(robot, frs):
    """Puts a robot's coordinates in the order of `frs`, which goes down each branch in the order of the file."""
    command = [frs, "eval", robot.path, "--lenient", "--json", "--only", "locked_inertia"]
    names = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)["joints"]
    robot.G = robot.G[:, [robot.names.index(name) for name in names]]
    robot.names = names


def mujoco_order(folder, robot, questions):
    try:
        return mujoco_model.write(folder, robot, questions)
    except ValueError as error:
        build.say(f"MuJoCo does not take {robot.path.stem}: {str(error).strip().splitlines()[0]}")
        return None


def casadi(out, robots):
    """CasADi's programs; C is written again when a robot or an algorithm changes."""
    programs = {}
    texts = [Path(module.__file__).read_text() for module in (symbolic, symbolic_works)]
    for name, robot in robots.items():
        works = [work for work, longest in plan.LONGEST_SYMBOLIC.items() if robot.model.nv - 6 <= longest]
        if not works:
            continue
        folder = out / "casadi" / name
        stamp = folder / "stamp"
        wanted = "\n".join([robot.path.read_text(), *texts, *works])
        if not stamp.exists() or stamp.read_text() != wanted:
            symbolic_works.write(folder, robot.model, works)
            stamp.write_text(wanted)
        programs[name] = build.casadi(folder, name)
    return programs


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--quick", action="store_true", help="three robots, few rounds")
    parser.add_argument("--rounds", type=int)
    parser.add_argument("--cpu", default=machine.last_core())
    parser.add_argument("--robots", help="names, with commas between")
    parser.add_argument("--no-scene", action="store_true", help="leave the paper's scene out")
    parser.add_argument("out", type=Path)
    options = parser.parse_args()
    out, target = options.out, options.out.parent / "native"
    rounds = options.rounds or (5 if options.quick else 15)

    prefix = next(Path(sys.prefix).glob("lib/python*/site-packages/cmeel.prefix"))
    chains.write(out / "chains", plan.CHAINS)
    paths = plan.robots(prefix, out / "chains")
    asked = options.robots.split(",") if options.robots else plan.QUICK if options.quick else paths
    unknown = set(asked) - set(paths)
    if unknown:
        build.stop(f"unknown robot {', '.join(unknown)}; expected {', '.join(paths)}")
    paths = {name: paths[name] for name in asked}
    robots = {name: Robot(path) for name, path in paths.items()}
    programs = build.pinocchio(out, prefix) | {"mujoco": build.mujoco(out)}
    frs = build.cargo(plan.ROOT, target, "--bin", "frs", "--features", "jit", "--locked") / "frs"
    for robot in robots.values():
        order_as_ours(robot, frs)
    texts = crate.write(out / "crate", frs, {name: (robot.path, robot.n) for name, robot in robots.items()})
    packages = [word for name in robots for word in ("-p", f"race_{name}")]
    programs["frs"] = build.cargo(out / "crate", target, *packages)
    programs["dynibo"] = build.cargo(plan.ROOT / "benches/peers/dynibo", target) / "beside-dynibo"
    programs["casadi"] = casadi(out, robots)
    questions, programs["mujoco_orders"] = prepared(out / "states", robots)

    found = {"machine": machine.described(options.cpu, build.clang()), "robots": {}}
    for name, robot in robots.items():
        build.say(f"timing {name}")
        compiled = plan.quantities(plan.generated_works("generated", robot.n))
        runners = contestants.of(robot, out / "states", programs, compiled)
        entry = measure.measured(runners, questions[name], robot.n, options.cpu, rounds)
        entry["code"] = code_size.of(programs["frs"] / f"race_{name}", name, texts[name])
        found["robots"][name] = entry
    if not options.no_scene:
        build.say("the paper's scene")
        found["scene"] = scene.costs(frs, options.cpu)
    (out / "race.json").write_text(json.dumps(found, ensure_ascii=False, indent=1) + "\n")


if __name__ == "__main__":
    main()
