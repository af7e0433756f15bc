"""The URDFs to compare, each with a short label."""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).parent
PROJECT = HERE.parents[1]


def example_robots():
    """The robots of the example-robot-data package of this virtual environment."""
    found = list(Path(sys.prefix).glob("lib/python*/site-packages/cmeel.prefix/share/example-robot-data/robots"))
    if not found:
        raise FileNotFoundError(f"no example-robot-data under {sys.prefix}; start this through tests/peers/run")
    return found[0]


def label(path):
    """Folder and file: `talos/talos_reduced`, `robots/chaser`."""
    for top in (example_robots(), PROJECT):
        if path.is_relative_to(top):
            folder = path.relative_to(top).parts[0]
            return f"{folder.removesuffix('_description').removesuffix('_data')}/{path.stem}"
    return path.stem


def urdfs():
    """Every URDF of the package, then the project's own, then those beside this file that have every joint kind."""
    return [*sorted(example_robots().rglob("*.urdf")), *sorted((PROJECT / "robots").glob("*.urdf")), *sorted(HERE.glob("*.urdf"))]


def copy_without_products(path, links, folder):
    """A copy in `folder`, under the same name, in which the inertias of `links` are diagonal."""
    tree = ElementTree.parse(path)
    for link in tree.getroot().findall("link"):
        if link.get("name") in links:
            for product in ("ixy", "ixz", "iyz"):
                link.find("inertial/inertia").set(product, "0")
    copy = Path(folder) / path.name
    tree.write(copy)
    return copy
