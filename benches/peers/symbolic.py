"""M, C and their reduced forms over CasADi's symbols.

CasADi has no robots, and Pinocchio's wheel comes without its CasADi part, so the algorithms are written here over its
symbols, as lean as they are known: everything in the base's axes about its origin, composite inertias as ten numbers, the
Coriolis matrix of Echeandia and Wensing with its body terms in closed form, articulated bodies. Zeros, ones and equal
subexpressions are folded by CasADi. Twists are [ω; v], the base's first.
"""

import casadi as ca
import numpy as np

SMALLEST = 1e-14  # of a rotation's entries; below, a URDF meant zero


class Body:
    """A body with the joint that moves it: screw; mass, first and second moment about the base's origin."""


def cross(a, b):
    return ca.cross(a, b)


def skew(a):
    return ca.skew(a)


def constant(matrix):
    clean = np.where(np.abs(matrix) < SMALLEST, 0.0, matrix)
    return ca.SX(np.where(np.abs(np.abs(clean) - 1.0) < SMALLEST, np.sign(clean), clean))


def about_axis(axis, s, c):
    """The rotation by an angle of this sine and cosine."""
    axis = constant(axis)
    turned = ca.mtimes(axis, axis.T)
    return turned + c * (ca.SX.eye(3) - turned) + s * skew(axis)


def inertia(rotation, position, body):
    """Mass, first moment and inertia about the base's origin, of a body of Pinocchio's."""
    centre = position + ca.mtimes(rotation, constant(body.lever))
    about = ca.mtimes(ca.mtimes(rotation, constant(body.inertia)), rotation.T)
    moment = body.mass * centre
    steiner = ca.dot(centre, moment) * ca.SX.eye(3) - ca.mtimes(moment, centre.T)
    return body.mass, moment, about + steiner


def bodies(model, q):
    """The base, then a body a joint, in the order of the joints."""
    found = []
    for j in range(1, model.njoints):
        body, joint, place = Body(), model.joints[j], model.jointPlacements[j]
        body.parent = model.parents[j] - 1
        if j == 1:
            body.rotation, body.position = ca.SX.eye(3), ca.SX.zeros(3, 1)
        else:
            above, angle = found[body.parent], q[joint.idx_v - 6]
            kind = joint.shortname().removeprefix("JointModel")
            axis = np.array(joint.extract().axis) if "Unaligned" in kind else np.eye(3)["XYZ".index(kind[-1])]
            rotation = ca.mtimes(above.rotation, constant(place.rotation))
            body.position = above.position + ca.mtimes(above.rotation, constant(place.translation))
            along = ca.mtimes(rotation, constant(axis))
            if kind.startswith("P"):
                body.rotation = rotation
                body.position = body.position + angle * along
                body.screw = ca.vertcat(ca.SX.zeros(3, 1), along)
            else:
                body.rotation = ca.mtimes(rotation, about_axis(axis, ca.sin(angle), ca.cos(angle)))
                body.screw = ca.vertcat(along, cross(body.position, along))
            body.column = joint.idx_v - 6
        body.mass, body.moment, body.second = inertia(body.rotation, body.position, model.inertias[j])
        found.append(body)
    return found


def momentum(body, twist):
    """Of the composite body."""
    w, v = twist[:3], twist[3:]
    return ca.vertcat(ca.mtimes(body.all_second, w) + cross(body.all_moment, v), body.all_mass * v + cross(w, body.all_moment))


def gather(tree, *names):
    """all_NAME: the sum over what a body carries."""
    for body in tree:
        for name in names:
            setattr(body, f"all_{name}", getattr(body, name))
    for body in reversed(tree[1:]):
        for name in names:
            above = tree[body.parent]
            setattr(above, f"all_{name}", getattr(above, f"all_{name}") + getattr(body, f"all_{name}"))


def above(tree, body):
    """The joints between a body and the base, the nearest first."""
    while body.parent > 0:
        body = tree[body.parent]
        yield body


def mass_matrix(tree):
    """Λ_b as mass, centre of mass and inertia about it; M's upper right block; its joints' block."""
    gather(tree, "mass", "moment", "second")
    n = len(tree) - 1
    base_joint, joints = ca.SX(6, n), ca.SX(n, n)
    for body in tree[1:]:
        force = body.force = momentum(body, body.screw)
        base_joint[:, body.column] = force
        joints[body.column, body.column] = ca.dot(force, body.screw)
        for other in above(tree, body):
            joints[body.column, other.column] = joints[other.column, body.column] = ca.dot(force, other.screw)
    return base_joint, joints


class Base:
    """Λ_b, and solves with it by its mass, centre of mass and the inverse of its inertia about that."""

    def __init__(self, base):
        self.mass, moment = base.all_mass, base.all_moment
        self.centre = moment / self.mass
        corner = skew(moment)
        self.locked = ca.vertcat(ca.horzcat(base.all_second, corner), ca.horzcat(corner.T, self.mass * ca.SX.eye(3)))
        central = base.all_second + ca.mtimes(skew(self.centre), corner)
        columns = [central[:, k] for k in range(3)]
        adjugate = ca.horzcat(cross(columns[1], columns[2]), cross(columns[2], columns[0]), cross(columns[0], columns[1])).T
        self.inverse = adjugate / ca.dot(columns[0], adjugate[0, :].T)

    def solve(self, momenta):
        linear = momenta[3:, :] / self.mass
        angular = ca.mtimes(self.inverse, momenta[:3, :] - ca.mtimes(skew(self.centre), momenta[3:, :]))
        return ca.vertcat(angular, linear + ca.mtimes(skew(self.centre), angular))


def split(tree):
    base_joint, joints = mass_matrix(tree)
    base = Base(tree[0])
    connection = base.solve(base_joint)
    return base, base_joint, connection, joints - ca.mtimes(base_joint.T, connection)


def move(tree, twist, qd):
    """Twists in the base's axes, and how they turn the screws."""
    tree[0].twist = twist
    for body in tree[1:]:
        body.twist = tree[body.parent].twist + body.screw * qd[body.column]
        body.turned = motion_cross(body.twist, body.screw)


def motion_cross(a, b):
    return ca.vertcat(cross(a[:3], b[:3]), cross(a[:3], b[3:]) + cross(a[3:], b[:3]))


def force_cross(twist, force):
    return ca.vertcat(cross(twist[:3], force[:3]) + cross(twist[3:], force[3:]), cross(twist[:3], force[3:]))


def coriolis(tree, twist, qd):
    """C(q, V): a body's term is [Y, 0; −l×, 0] with its linear momentum l."""
    move(tree, twist, qd)
    for body in tree:
        w, v, h = body.twist[:3], body.twist[3:], body.moment
        body.linear = body.mass * v + cross(w, h)
        angular = ca.mtimes(body.second, w) + cross(h, v)
        turning = ca.mtimes(skew(w), body.second)
        lever = ca.mtimes(h, v.T) + ca.mtimes(v, h.T) - 2 * ca.dot(h, v) * ca.SX.eye(3)
        body.term = 0.5 * (turning + turning.T - lever - skew(angular))
    gather(tree, "term", "linear")
    n = len(tree) - 1
    matrix = ca.SX(6 + n, 6 + n)
    base = tree[0]
    cross_twist = ca.horzcat(*(motion_cross(twist, ca.SX.eye(6)[:, k]) for k in range(6)))
    own = ca.vertcat(ca.horzcat(base.all_term, ca.SX(3, 3)), ca.horzcat(-skew(base.all_linear), ca.SX(3, 3)))
    matrix[:6, :6] = own + ca.horzcat(*(momentum(base, cross_twist[:, k]) for k in range(6)))
    for body in tree[1:]:
        screw, column = body.screw, 6 + body.column
        ahead = momentum(body, body.turned) + ca.vertcat(ca.mtimes(body.all_term, screw[:3]), cross(screw[:3], body.all_linear))
        behind = ca.mtimes(body.all_term.T, screw[:3]) + cross(body.all_linear, screw[3:])
        matrix[column, column] = ca.dot(screw, ahead)
        for other in above(tree, body):
            matrix[6 + other.column, column] = ca.dot(other.screw, ahead)
            matrix[column, 6 + other.column] = ca.dot(other.turned, body.force) + ca.dot(other.screw[:3], behind)
        matrix[:6, column] = ahead
        matrix[column, :6] = ca.mtimes(cross_twist.T, body.force).T + ca.horzcat(behind.T, ca.SX(1, 3))
    return matrix


def split_coriolis(C, base_joint, base, connection):
    """C in (μ, q̇), as in pinocchio.cpp."""
    rate = C[:6, :6] + C[:6, :6].T
    gathered = C[:6, 6:] + C[6:, :6].T - ca.mtimes(rate, connection)
    right = C[:, 6:] - ca.mtimes(C[:, :6], connection)
    right = ca.vertcat(right[:6, :] - gathered, right[6:, :] - ca.mtimes(base_joint.T, base.solve(gathered)))
    whole = ca.horzcat(C[:, :6], right)
    return ca.vertcat(whole[:6, :], whole[6:, :] - ca.mtimes(connection.T, whole[:6, :]))
