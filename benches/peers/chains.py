"""Serial chains of random links, for timings beyond the largest robots."""

import random

LINK = """  <link name="link_{k}">
    <inertial><origin xyz="{centre}" rpy="{turn}"/><mass value="{mass}"/>
      <inertia ixx="{ixx}" ixy="0" ixz="0" iyy="{iyy}" iyz="0" izz="{izz}"/></inertial>
  </link>
"""
JOINT = """  <joint name="joint_{k}" type="revolute">
    <parent link="link_{parent}"/><child link="link_{k}"/><origin xyz="{origin}" rpy="{turn}"/><axis xyz="{axis}"/>
    <limit lower="-3" upper="3" effort="100" velocity="5"/>
  </joint>
"""


def chain(n):
    """`n` revolute joints about the axes of turned frames; every link is a solid box of water's density."""
    draw = random.Random(n)
    vector = lambda reach: " ".join(f"{draw.uniform(-reach, reach):.4f}" for _ in range(3))

    def link(k):
        x, y, z = (draw.uniform(0.05, 0.2) for _ in range(3))
        mass = 1000 * x * y * z
        square = {"ixx": y * y + z * z, "iyy": x * x + z * z, "izz": x * x + y * y}
        inertia = {axis: f"{mass * side / 12:.6g}" for axis, side in square.items()}
        return LINK.format(k=k, centre=vector(0.1), turn=vector(1.5), mass=f"{mass:.4f}", **inertia)

    def joint(k):
        axis = draw.choice(["1 0 0", "0 1 0", "0 0 1"])
        return JOINT.format(k=k, parent=k - 1, origin=vector(0.2), turn=vector(1.5), axis=axis)

    body = link(0) + "".join(link(k) + joint(k) for k in range(1, n + 1))
    return f'<?xml version="1.0"?>\n<robot name="chain_{n}">\n{body}</robot>\n'


def write(folder, lengths):
    """chain_N.urdf of each length."""
    folder.mkdir(parents=True, exist_ok=True)
    for n in lengths:
        (folder / f"chain_{n}.urdf").write_text(chain(n))
