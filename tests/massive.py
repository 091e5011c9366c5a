"""Pieces of robots with masses, for the tests of what is made of them."""

from urdfkit.lint.context import Context
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.masses import Masses
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

BOX = '<box size="0.2 0.3 0.1"/>'
BALL = '<sphere radius="0.1"/>'
WHEEL = '<cylinder radius="0.06" length="0.05"/>'
MESH = '<mesh filename="package://robot/meshes/part.stl"/>'

Moments = tuple[float, ...]


def inertial(mass: float, moments: Moments, xyz: str = "0 0 0", rpy: str = "0 0 0") -> str:
    """``<inertial>``; three moments, or six entries in the order of URDF."""
    if len(moments) == 3:
        moments = (moments[0], 0, 0, moments[1], 0, moments[2])
    keys = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
    tensor = " ".join(f'{key}="{value!r}"' for key, value in zip(keys, moments, strict=True))
    origin = f'<origin xyz="{xyz}" rpy="{rpy}"/>' if (xyz, rpy) != ("0 0 0", "0 0 0") else ""
    return f'<inertial>{origin}<mass value="{mass!r}"/>\n<inertia {tensor}/></inertial>'


def shape(tag: str, geometry: str, xyz: str = "0 0 0", rpy: str = "0 0 0") -> str:
    """``<visual>`` or ``<collision>``."""
    origin = f'<origin xyz="{xyz}" rpy="{rpy}"/>' if (xyz, rpy) != ("0 0 0", "0 0 0") else ""
    return f"<{tag}>{origin}<geometry>{geometry}</geometry></{tag}>"


def link(name: str, *parts: str) -> str:
    """``<link>`` on a line of its own."""
    return f'<link name="{name}">{"".join(parts)}</link>\n'


def part(name: str, mass: float, moments: Moments, geometry: str, xyz: str = "0 0 0") -> str:
    """A link with a collision and an inertia."""
    return link(name, shape("collision", geometry), inertial(mass, moments, xyz))


def joint(parent: str, child: str, kind: str = "fixed", xyz: str = "0 0 0") -> str:
    """``<joint>``, called after its child."""
    limit = '<limit effort="1" velocity="1" lower="-1" upper="1"/>' if kind != "fixed" else ""
    return (
        f'<joint name="{child}_joint" type="{kind}"><origin xyz="{xyz}"/><parent link="{parent}"/>'
        f'<child link="{child}"/>{limit}</joint>\n'
    )


def context(text: str) -> Context:
    """A robot from the pieces inside it."""
    return Context(Source("robot.urdf", whole_robot(text).encode()), Resolver(environment={}))


def masses(text: str) -> Masses:
    """What the pieces of a robot say about masses."""
    return context(text).masses


def link_inertia(text: str) -> LinkInertia:
    """The only link with a mass in the pieces of a robot."""
    (found,) = masses(text).inertias
    return found


def defects(text: str) -> dict[str, list[str]]:
    """The links with each defect."""
    return {
        defect.value: [one.link.name for one in found]
        for defect, found in masses(text).defects.items()
    }
