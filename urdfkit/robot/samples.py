"""XML of small robots for the examples of rules."""

from collections.abc import Iterable


def robot_xml(*parts: str) -> str:
    return "\n".join(parts)


def xacro_xml(*parts: str) -> str:
    """A xacro file: a ``<robot>`` that declares the prefix, and its elements."""
    return element_xml('robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"', *parts) + "\n"


def element_xml(tag: str, *inside: str) -> str:
    """An element from its tag with attributes, and its child elements."""
    if not inside:
        return f"<{tag}/>"
    indented = "\n".join(inside).replace("\n", "\n  ")
    return f"<{tag}>\n  {indented}\n</{tag.partition(' ')[0]}>"


def link_xml(name: str, *inside: str) -> str:
    """A ``<link>`` and its elements."""
    return element_xml(f'link name="{name}"', *inside)


def joint_xml(
    kind: str, *inside: str, name: str = "shoulder", parent: str = "base", child: str = "arm"
) -> str:
    """A ``<joint>``, with other elements after its parent and child."""
    ends = f'<parent link="{parent}"/>', f'<child link="{child}"/>'
    return element_xml(f'joint name="{name}" type="{kind}"', *ends, *inside)


def arm_xml(kind: str, *inside: str) -> str:
    """Two links without shape or mass, connected by a joint."""
    return robot_xml(link_xml("base"), link_xml("arm"), joint_xml(kind, *inside))


def hand_xml(kind: str, left: Iterable[str], right: Iterable[str], *finger: str) -> str:
    """A hand with two fingers.

    Args:
        kind: the type of ``left_joint`` and ``right_joint``.
    """
    return robot_xml(
        *(link_xml(name, *finger) for name in ("hand", "left_finger", "right_finger")),
        joint_xml(kind, *left, name="left_joint", parent="hand", child="left_finger"),
        joint_xml(kind, *right, name="right_joint", parent="hand", child="right_finger"),
    )


def visual_xml(shape: str, *others: str) -> str:
    """A ``<visual>`` with a shape, such as ``<sphere radius="0.1"/>``, and other elements."""
    return element_xml("visual", f"<geometry>{shape}</geometry>", *others)


def collision_xml(shape: str, *others: str) -> str:
    """A ``<collision>`` with a shape, such as ``<sphere radius="0.1"/>``, and other elements."""
    return element_xml("collision", f"<geometry>{shape}</geometry>", *others)


def inertial_xml(mass: str, moments: str, *others: str) -> str:
    """An ``<inertial>``.

    Args:
        mass: in kg.
        moments: about x, y and z, in kg·m², such as ``0.1 0.1 0.2``.
        others: elements before the mass, such as ``<origin xyz="0 0 1"/>``.
    """
    x, y, z = moments.split()
    tensor = f'<inertia ixx="{x}" ixy="0" ixz="0" iyy="{y}" iyz="0" izz="{z}"/>'
    return element_xml("inertial", *others, f'<mass value="{mass}"/>', tensor)


def mesh_xml(role: str, filename: str) -> str:
    """A link with a mesh as its visual or collision."""
    shape = f'<mesh filename="{filename}"/>'
    return link_xml("arm", visual_xml(shape) if role == "visual" else collision_xml(shape))
