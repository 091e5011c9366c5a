"""Spheres in the file formats of motion planners, with the pairs of links to ignore."""

from collections.abc import Sequence
from typing import Any

import yaml

from urdfkit.core.spatial import IDENTITY, Transform, vector
from urdfkit.lint.context import Context
from urdfkit.output.covers import LinkCover, RobotCover
from urdfkit.output.covers.urdf import DECIMALS, collision, replaced
from urdfkit.physics.collision.matrix import Matrix, PairVerdict

#: Number of configurations in which links are compared.
_SAMPLES = 10_000
#: Limits that Isaac Sim's editor writes into an XRDF, as a URDF has none: in rad/s^2 and
#: rad/s^3, or m/s^2 and m/s^3.
_ACCELERATION, _JERK = 10.0, 10_000.0


def curobo(robot: Context, found: RobotCover) -> str:
    """The collision part of cuRobo's robot configuration.

    Source: https://curobo.org/tutorials/1_robot_configuration.html

    Raises:
        Unavailable: coal is not installed, which compares links.
    """
    names = [cover.link for cover in found.links]
    kinematics = {
        "base_link": robot.tree.roots[0].name,
        "collision_link_names": names,
        "collision_spheres": _spheres(found),
        "collision_sphere_buffer": 0.0,
        "self_collision_ignore": _ignored(robot, names),
        "self_collision_buffer": dict.fromkeys(names, 0.0),
    }
    return _yaml({"robot_cfg": {"kinematics": kinematics}})


def xrdf(robot: Context, found: RobotCover) -> str:
    """An XRDF 1.0 file, for Isaac Sim and cuMotion.

    Source: https://nvidia-isaac-ros.github.io/concepts/manipulation/xrdf.html

    Raises:
        Unavailable: coal is not installed, which compares links.
    """
    names = [cover.link for cover in found.links]
    joints = [joint.name for joint in robot.model.joints if joint.degrees_of_freedom == 1]
    parents = {joint.parent_name for joint in robot.model.joints}
    buffers = dict.fromkeys(names, 0.0)
    document = {
        "format": "xrdf",
        "format_version": 1.0,
        "default_joint_positions": dict.fromkeys(joints, 0.0),
        "cspace": {
            "joint_names": joints,
            "acceleration_limits": [_ACCELERATION] * len(joints),
            "jerk_limits": [_JERK] * len(joints),
        },
        "tool_frames": [link.name for link in robot.model.links if link.name not in parents],
        "collision": {"geometry": "spheres", "buffer_distance": buffers},
        "self_collision": {
            "geometry": "spheres",
            "buffer_distance": dict(buffers),
            "ignore": _ignored(robot, names),
        },
        "geometry": {"spheres": {"spheres": _spheres(found)}},
    }
    return _yaml(document)


def urdf(robot: Context, found: RobotCover) -> str:
    """The robot without xacro, with spheres as collisions, as for VAMP and foam."""
    shapes = {
        cover.link: [
            collision("sphere", Transform(IDENTITY, vector(at["center"])), radius=at["radius"])
            for at in _plain(cover)
        ]
        for cover in found.links
    }
    return replaced(robot, shapes)


#: The function of each format, by its name.
FORMATS = {"curobo": curobo, "xrdf": xrdf, "urdf": urdf}


def _spheres(found: RobotCover) -> dict[str, list[dict[str, Any]]]:
    return {cover.link: _plain(cover) for cover in found.links}


def _plain(cover: LinkCover) -> list[dict[str, Any]]:
    shapes = cover.shapes._asdict()
    centers, radii = shapes["centers"].tolist(), shapes["radii"].tolist()
    return [
        {"center": [round(x, DECIMALS) + 0.0 for x in center], "radius": round(r, DECIMALS)}
        for center, r in zip(centers, radii, strict=True)
    ]


def _ignored(robot: Context, links: Sequence[str]) -> dict[str, list[str]]:
    """Pairs of links to ignore, each once, by the name of the first link.

    These pairs are connected by a joint, or collide in nearly all samples, or in none; pairs that
    collide in the initial configuration must also collide in most samples.
    """
    matrix: Matrix = robot.collisions.matrix(samples=_SAMPLES, seed=0, begin={})
    checked = (PairVerdict.SOMETIMES, PairVerdict.UNKNOWN)
    pairs = {
        frozenset((pair.first, pair.second))
        for pair in matrix.pairs
        if pair.verdict not in checked and not pair.is_seldom
    }
    joints = robot.model.joints
    pairs |= {frozenset((j.parent_name, j.child_name)) for j in joints if j.parent and j.child}
    return {
        first: others
        for number, first in enumerate(links, 1)
        if (others := [second for second in links[number:] if {first, second} in pairs])
    }


def _yaml(document: dict[str, Any]) -> str:
    text: str = yaml.safe_dump(document, sort_keys=False, default_flow_style=None, width=100)
    return text
