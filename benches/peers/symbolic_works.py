"""What CasADi generates C of: write(FOLDER, ROBOT, WORKS) leaves works.c and, for casadi.cpp, works.h."""

import casadi as ca

from symbolic import bodies, coriolis, force_cross, momentum, move, split, split_coriolis


def factored(matrix):
    """L and 1/D of a symmetric positive matrix."""
    n = matrix.shape[0]
    lower, inverse = ca.SX.eye(n), []
    diagonal = []
    for j in range(n):
        pivot = matrix[j, j] - sum(lower[j, k] ** 2 * diagonal[k] for k in range(j))
        diagonal.append(pivot)
        inverse.append(1 / pivot)
        for i in range(j + 1, n):
            rest = matrix[i, j] - sum(lower[i, k] * lower[j, k] * diagonal[k] for k in range(j))
            lower[i, j] = rest * inverse[j]
    return lower, inverse


def solved(matrix, right):
    lower, inverse = factored(matrix)
    n = matrix.shape[0]
    x = [right[i] for i in range(n)]
    for i in range(n):
        x[i] -= sum(lower[i, k] * x[k] for k in range(i))
    x = [value * scale for value, scale in zip(x, inverse)]
    for i in reversed(range(n)):
        x[i] -= sum(lower[k, i] * x[k] for k in range(i + 1, n))
    return ca.vertcat(*x)


def acceleration(tree, twist, qd, force):
    """V̇ = [V̇₁; q̈] by articulated bodies, all in the base's axes."""
    move(tree, twist, qd)
    for body in tree:
        corner = ca.skew(body.moment)
        body.articulated = ca.vertcat(ca.horzcat(body.second, corner), ca.horzcat(corner.T, body.mass * ca.SX.eye(3)))
        body.all_mass, body.all_moment, body.all_second = body.mass, body.moment, body.second
        body.bias = force_cross(body.twist, momentum(body, body.twist))
    for body in reversed(tree[1:]):
        body.reach = ca.mtimes(body.articulated, body.screw)
        body.size = 1 / ca.dot(body.screw, body.reach)
        body.turn = body.turned * qd[body.column]
        body.rest = force[6 + body.column] - ca.dot(body.screw, body.bias)
        scaled = body.reach * body.size
        # Symmetric: each entry once.
        beyond = ca.triu2symm(ca.triu(body.articulated - ca.mtimes(scaled, body.reach.T)))
        above = tree[body.parent]
        above.articulated = above.articulated + beyond
        above.bias = above.bias + body.bias + ca.mtimes(beyond, body.turn) + scaled * body.rest
    tree[0].acceleration = solved(tree[0].articulated, force[:6] - tree[0].bias)
    joints = [None] * (len(tree) - 1)
    for body in tree[1:]:
        carried = tree[body.parent].acceleration + body.turn
        joints[body.column] = (body.rest - ca.dot(body.reach, carried)) * body.size
        body.acceleration = carried + body.screw * joints[body.column]
    return ca.vertcat(tree[0].acceleration, *joints)


def curvature(q, connection):
    """𝓑_ω = ∂_i A_j − ∂_j A_i − A_i × A_j, the derivatives by CasADi."""
    n, angular = q.shape[0], connection[:3, :]
    rates = ca.jacobian(ca.vec(angular), q)  # of A_j, three rows, along every coordinate
    layers = [ca.SX(n, n) for _ in range(3)]
    for i in range(n):
        for j in range(i):
            value = rates[3 * j : 3 * j + 3, i] - rates[3 * i : 3 * i + 3, j] - ca.cross(angular[:, i], angular[:, j])
            for axis in range(3):
                layers[axis][i, j], layers[axis][j, i] = value[axis], -value[axis]
    return ca.horzcat(*layers)


def functions(model, works):
    """Function after function, each from q, V and F to its outputs."""
    n = model.nv - 6
    q, twist, qd, force = ca.SX.sym("q", n), ca.SX.sym("v", 6), ca.SX.sym("qd", n), ca.SX.sym("f", 6 + n)
    tree = bodies(model, q)
    for work in works:
        outputs = {}
        if work == "forward":
            outputs["acceleration"] = acceleration(tree, twist, qd, force)
        else:
            base, base_joint, connection, shape = split(tree)
            if work == "curvature":
                outputs["curvature"] = curvature(q, connection)
            else:
                outputs |= {"locked_inertia": base.locked, "connection": connection, "shape_inertia": shape}
            if work == "matrices":
                C = coriolis(tree, twist, qd)
                outputs["coriolis"] = split_coriolis(C, base_joint, base, connection)
        results = ca.cse([ca.densify(value) for value in outputs.values()])
        yield ca.Function(work, [q, ca.vertcat(twist, qd), force], results, ["q", "velocity", "force"], list(outputs))


def write(folder, model, works):
    """works.c and works.h, and list.h with what is in them."""
    folder.mkdir(parents=True, exist_ok=True)
    made = list(functions(model, works))
    generator = ca.CodeGenerator("works.c", {"with_header": True})
    for function in made:
        generator.add(function)
    generator.generate(f"{folder}/")
    listed = " ".join(f"W({function.name()})" for function in made)
    (folder / "list.h").write_text(f"#define WORKS {listed}\n#define JOINTS {model.nv - 6}\n")
