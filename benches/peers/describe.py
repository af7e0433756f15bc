"""Writes a robot and its states as plain numbers for the programs that are timed.

Pinocchio's own URDF reader is compiled code of the wheel, built for another processor; without it the timing program
needs headers alone, and every algorithm in it is compiled for this machine. Each line is a list of words:

    robot NAME NQ NV JOINTS
    KIND PARENT AXIS(3) ROTATION(9, by rows) TRANSLATION(3) MASS CENTRE(3) INERTIA(9, by rows)     a line a joint
    states COUNT
    Q(nq) V(nv) TAU(nv)                                                                            a line a state

Our own programs read the URDF and, a line a state, Q(n) QD(n) MU(6) WRENCH(6) TAU(n); those that know no follower
joints read the same of the tree, with V₁ for MU.
"""

import numpy as np

STATES = 128


def words(*parts):
    return " ".join(repr(float(x)) for part in parts for x in np.ravel(part))


def tree(robot):
    model = robot.model
    yield f"robot {robot.path.stem} {model.nq} {model.nv} {model.njoints - 1}"
    for j in range(1, model.njoints):
        joint, placement, body = model.joints[j], model.jointPlacements[j], model.inertias[j]
        axis = getattr(joint.extract(), "axis", np.zeros(3))
        numbers = words(axis, placement.rotation, placement.translation, body.mass, body.lever, body.inertia)
        yield f"{joint.shortname()} {model.parents[j]} {numbers}"


def states(robot, order, questions):
    yield f"states {len(questions)}"
    for question in questions:
        yield words(question.configuration, question.velocity[order], question.force[order])


def own_states(questions):
    return (words(o.q, o.qd, o.mu, o.wrench, o.tau) for o in (question.own for question in questions))


def tree_states(questions):
    for question in questions:
        yield words(question.angles, question.velocity[6:], question.velocity[:6], question.force)


def write(folder, robot, order, questions):
    """The files of one robot: NAME.txt, NAME.own, NAME.tree."""
    folder.mkdir(parents=True, exist_ok=True)
    texts = {
        "txt": [*tree(robot), *states(robot, order, questions)],
        "own": own_states(questions),
        "tree": tree_states(questions),
    }
    for ending, lines in texts.items():
        (folder / f"{robot.path.stem}.{ending}").write_text("\n".join(lines) + "\n")
