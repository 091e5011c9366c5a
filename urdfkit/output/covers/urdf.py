"""A robot in URDF whose collisions are replaced by simple shapes."""

from collections.abc import Mapping
from xml.etree import ElementTree

from urdfkit.core.spatial import Transform, to_rpy
from urdfkit.lint.context import Context
from urdfkit.output.exchange import element_tree
from urdfkit.text import schema
from urdfkit.text.grammar import version_of

#: Decimals of lengths in m, and of angles in rad.
DECIMALS = 6


def replaced(robot: Context, shapes: Mapping[str, list[ElementTree.Element]]) -> str:
    """The robot without xacro, with new collisions.

    Args:
        shapes: the ``<collision>`` elements of each link; a link that is not listed has none.
    """
    root = element_tree(robot.document.root)
    for link in root.iter("link"):
        for collision in link.findall("collision"):
            link.remove(collision)
        link.extend(shapes.get(link.get("name", ""), ()))
    has_capsules = next(root.iter("capsule"), None) is not None
    if has_capsules and version_of(robot.document.root) == schema.VERSIONS[0]:
        root.set("version", schema.VERSIONS[1])  # where urdfdom reads them
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode", xml_declaration=True) + "\n"


def collision(tag: str, origin: Transform, **sizes: float) -> ElementTree.Element:
    """A ``<collision>`` with a primitive.

    Args:
        sizes: its radius and length, in m.
    """
    element = ElementTree.Element("collision")
    xyz, rpy = map(_numbers, (origin.position, to_rpy(origin.rotation)))
    ElementTree.SubElement(element, "origin", {"xyz": xyz, "rpy": rpy})
    geometry = ElementTree.SubElement(element, "geometry")
    attributes = {name: _number(size) for name, size in sizes.items()}
    ElementTree.SubElement(geometry, tag, attributes)
    return element


def _numbers(values: tuple[float, ...]) -> str:
    return " ".join(map(_number, values))


def _number(value: float) -> str:
    return str(round(value, DECIMALS) + 0.0)
