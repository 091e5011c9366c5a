"""The specification of a robot for MuJoCo, and what MuJoCo says of it."""

import re
import warnings
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

import mujoco

from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.conversion.mjcf_devices import add_actuators, add_frictions
from urdfkit.output.conversion.mjcf_robot import MjcfRobot
from urdfkit.output.conversion.mjcf_sensors import add_sensors
from urdfkit.output.conversion.mjcf_srdf import exclude_disabled
from urdfkit.output.conversion.options import ConversionOptions
from urdfkit.output.conversion.requirements import require_meaning
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.stability import lowest_links
from urdfkit.text.source import Span, shown

#: What an error of MuJoCo's compiler is about.
_ELEMENT = re.compile(r"Element name '([^']+)'.*")
_REPEATED = re.compile(r"repeated name '([^']+)'")
#: What to do about errors of MuJoCo's compiler, by a part of their text.
_REMEDIES = {
    "mass and inertia of moving bodies": "give it an <inertial> with a mass and moments over 0",
    "inertia must satisfy": "see 'urdfkit explain INE003'",
    "repeated name": "rename one of them",
    "is too small": "correct its scale, or remove it",
}


def floats(robot: Context, base: str) -> bool:
    """True if the root of a robot is not welded to the world.

    ``auto`` lets a robot float that stands on feet or wheels: on parts that different joints of
    its base move. An arm may hang below its base, too, but by one joint.

    Raises:
        UrdfkitError: a part of the robot has no meaning, or the world is to float.
    """
    require_meaning(robot)
    if base == "free" and robot.tree.roots[0].name == "world":
        raise UrdfkitError(
            f"{robot.model.place('world')}: a root link called 'world' cannot float; rename it, "
            "or take another --base"
        )
    if base != "auto":
        return base == "free"
    root = rigid_bodies(robot.tree)[0]
    if root.is_ground or not root.mass:  # what has no mass is no base that moves
        return False
    moving = (
        [joint for joint in robot.tree.path(link) if joint.kind != "fixed"]
        for link in lowest_links(robot)
    )
    return len({joints[0].name for joints in moving if joints}) > 1


def assembled(
    robot: Context,
    files: Mapping[int, str],
    directory: str,
    options: ConversionOptions,
    *,
    is_free: bool,
) -> MjcfRobot:
    """The specification of a robot; the arguments are those of `MjcfRobot`.

    Raises:
        UrdfkitError: MuJoCo rejects it, or a joint or a shape has no meaning.
    """
    with rejections(robot):
        made = MjcfRobot(robot, files, directory, options, is_free=is_free)
        add_frictions(made, robot)
        add_actuators(made, robot)
        add_sensors(made, robot)
        exclude_disabled(made, robot)
    return made


def compiled(made: MjcfRobot, robot: Context) -> Any:
    """Compile the MuJoCo model.

    Raises:
        UrdfkitError: MuJoCo rejects it.
    """
    with rejections(robot, made.mesh_places):
        return made.spec.compile()


@contextmanager
def rejections(robot: Context, meshes: Mapping[str, Span] | None = None) -> Iterator[None]:
    """Errors of MuJoCo as ours; what it warns of, as in meshes, is found by a check.

    Args:
        meshes: where they are written, by name.
    """
    mujoco.set_mju_user_warning(_ignore)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    except (ValueError, mujoco.FatalError) as error:
        raise _explained(str(error), robot, meshes or {}) from error


def _ignore(warning: str) -> None:
    """MuJoCo writes what it warns of to a file in the current directory otherwise."""


def _explained(text: str, robot: Context, meshes: Mapping[str, Span]) -> UrdfkitError:
    """An error of MuJoCo's compiler, at the link, joint or mesh that it names."""
    what = " ".join(text.split()).removeprefix("Error: ")
    what = what.replace("; use 'balanceinertia' to fix", "")  # which invents an inertia
    named = _ELEMENT.search(what)
    name = named.group(1) if named else ""
    what = f"{what[: named.start()].strip()} ('{name}')" if named else what
    if repeated := _REPEATED.search(what):
        name = repeated.group(1)
    place = meshes.get(name) if "mesh" in text or "vertices" in text else None
    place = place or robot.model.place(name)
    remedy = next((remedy for part, remedy in _REMEDIES.items() if part in what), "")
    remedy = remedy or f"see 'urdfkit check {shown(robot.source.path)} --target mujoco'"
    return UrdfkitError(f"{place}: MuJoCo rejects the robot: {what}; {remedy}")
