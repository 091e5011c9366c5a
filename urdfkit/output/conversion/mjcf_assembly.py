"""The MuJoCo specification of a robot, and errors of MuJoCo's compiler."""

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

#: Names in errors of MuJoCo's compiler.
_ELEMENT = re.compile(r"Element name '([^']+)'.*")
_REPEATED = re.compile(r"repeated name '([^']+)'")
#: Help for errors of MuJoCo's compiler, by a part of their text.
_HELP = {
    "mass and inertia of moving bodies": "give it an <inertial> with a mass and moments above 0",
    "inertia must satisfy": "see 'urdfkit explain INE003'",
    "repeated name": "rename one of them",
    "is too small": "correct its scale, or remove it",
}


def floats(robot: Context, base: str) -> bool:
    """True if the root of a robot is not welded to the world.

    With ``auto``, a robot on feet or wheels floats: several joints of its base move the parts
    that it stands on. An arm may also be below its base, but has only one joint there.

    Raises:
        UrdfkitError: a part of the robot is invalid, or the link ``world`` is to float.
    """
    require_meaning(robot)
    if base == "free" and robot.tree.roots[0].name == "world":
        raise UrdfkitError(
            f"{robot.model.place('world')}: a root link named 'world' cannot float; rename it, "
            "or use another --base"
        )
    if base != "auto":
        return base == "free"
    root = rigid_bodies(robot.tree)[0]
    if root.is_ground or not root.mass:  # a base without mass does not move
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
    """The MuJoCo specification of a robot; the arguments are those of `MjcfRobot`.

    Raises:
        UrdfkitError: MuJoCo rejects it, or a joint or a shape is invalid.
    """
    with rejections(robot):
        mjcf = MjcfRobot(robot, files, directory, options, is_free=is_free)
        add_frictions(mjcf, robot)
        add_actuators(mjcf, robot)
        add_sensors(mjcf, robot)
        exclude_disabled(mjcf, options.srdf or robot.srdf)
    return mjcf


def compiled(mjcf: MjcfRobot, robot: Context) -> Any:
    """Compile the MuJoCo model.

    Raises:
        UrdfkitError: MuJoCo rejects it.
    """
    with rejections(robot, mjcf.mesh_places):
        return mjcf.spec.compile()


@contextmanager
def rejections(robot: Context, meshes: Mapping[str, Span] | None = None) -> Iterator[None]:
    """Raise errors of MuJoCo as `UrdfkitError`; its warnings are ignored, as rules report them.

    Args:
        meshes: source locations of meshes, by name.
    """
    mujoco.set_mju_user_warning(ignore_warning)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    except (ValueError, mujoco.FatalError) as error:
        raise _explained(str(error), robot, meshes or {}) from error


def ignore_warning(warning: str) -> None:
    """Discard a warning, which MuJoCo otherwise writes to a file in the current directory."""


def _explained(text: str, robot: Context, meshes: Mapping[str, Span]) -> UrdfkitError:
    """An error of MuJoCo's compiler, at the link, joint or mesh in its text."""
    message = " ".join(text.split()).removeprefix("Error: ")
    message = message.replace("; use 'balanceinertia' to fix", "")  # it changes the inertia
    match = _ELEMENT.search(message)
    name = match.group(1) if match else ""
    message = f"{message[: match.start()].strip()} ('{name}')" if match else message
    if repeated := _REPEATED.search(message):
        name = repeated.group(1)
    place = meshes.get(name) if "mesh" in text or "vertices" in text else None
    place = place or robot.model.place(name)
    help = next((help for part, help in _HELP.items() if part in message), "")
    help = help or f"see 'urdfkit check {shown(robot.source.path)} --target mujoco'"
    return UrdfkitError(f"{place}: MuJoCo rejects the robot: {message}; {help}")
