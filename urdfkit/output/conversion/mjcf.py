"""MJCF on disk, with its proof: whole or not at all."""

import ctypes
import glob
import os
import re
import warnings
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

import mujoco

from urdfkit.core import atomic
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.bundle import Bundle
from urdfkit.output.bundle.consumers import CONSUMERS
from urdfkit.output.bundle.meshes import BundledFile
from urdfkit.output.bundle.robot import references
from urdfkit.output.bundle.writing import staged
from urdfkit.output.conversion.mjcf_devices import add_actuators, add_frictions
from urdfkit.output.conversion.mjcf_robot import MjcfRobot
from urdfkit.output.conversion.mjcf_sensors import add_sensors
from urdfkit.output.conversion.mjcf_srdf import (
    add_keyframes,
    exclude_computed,
    exclude_disabled,
    exclude_neighbours,
)
from urdfkit.output.conversion.options import ConversionOptions
from urdfkit.output.conversion.proof import prove
from urdfkit.output.conversion.result import REPORT, Conversion
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.stability import lowest_links

_LOST = "MJCF has nothing like it"
_REASONS = {
    "plugin": "a plugin is a program of Gazebo",
    "material": "no geom has it",
    "update_rate": "MuJoCo measures in every step",
    "always_on": "MuJoCo measures in every step",
}
#: What an error of MuJoCo's compiler is about.
_ELEMENT = re.compile(r"Element name '([^']+)'.*")


def write(robot: Context, out: str, options: ConversionOptions, *, force: bool) -> Conversion:
    """Write a robot; the arguments and errors are those of `urdfkit.output.conversion.convert`."""
    is_free = floats(robot, options.base)
    bundle = Bundle(robot, CONSUMERS["mujoco"])
    with staged(_assets(bundle), out, force=force, mark=REPORT) as directory:
        made = assembled(robot, _files(robot, bundle), directory, options, is_free=is_free)
        exclude_neighbours(made, robot)
        if options.exclude == "computed":
            exclude_computed(made, robot)
        with _rejections(robot):
            add_keyframes(made, robot)
        _remove_unused(made, directory)
        model = _written(made, os.path.join(directory, f"{bundle.name}.xml"), robot)
        proof = prove(model, robot)
        if not proof.holds:
            raise UrdfkitError(
                f"MuJoCo and {proof.engine} do not agree on the robot: {proof.differences}"
            )
        entries = tuple(made.losses.entries(robot.document.root, _LOST, _REASONS))
        root = "free" if is_free else "fixed"
        found = Conversion("mjcf", f"{bundle.name}.xml", root, _counts(model), entries, proof)
        found.write_report(directory)
    return found


def floats(robot: Context, base: str) -> bool:
    """True if the root of a robot is not welded to the world.

    ``auto`` lets a robot float that stands on feet or wheels: on parts that different joints of
    its base move. An arm may hang below its base, too, but by one joint.

    Raises:
        UrdfkitError: links and joints do not form one tree, or the world is to float.
    """
    if not robot.tree.is_sound:
        raise UrdfkitError(robot.tree.unsound)
    if base == "free" and robot.tree.roots[0].name == "world":
        raise UrdfkitError(f"{robot.source.path}: a root link called 'world' cannot float")
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


def _assets(bundle: Bundle) -> Iterator[BundledFile]:
    """The meshes of a bundle, without its URDF and its manifest."""
    for file in bundle.files():
        if "/" in file.path:
            yield file


def _files(robot: Context, bundle: Bundle) -> dict[int, str]:
    """Where the files of a bundle lie, by the ``id`` of the references to them."""
    return {
        id(reference): one.new
        for reference, one in zip(references(robot.model), bundle.renamed, strict=True)
    }


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
    with _rejections(robot):
        made = MjcfRobot(robot, files, directory, options, is_free=is_free)
        add_frictions(made, robot)
        add_actuators(made, robot)
        add_sensors(made, robot)
        exclude_disabled(made, robot)
    return made


def _remove_unused(made: MjcfRobot, directory: str) -> None:
    """Files of the bundle that no mesh or texture is read from, such as materials of OBJ."""
    used = {one.file for one in (*made.spec.meshes, *made.spec.textures)}
    for at, _, names in list(os.walk(directory, topdown=False)):
        for name in names:
            path = os.path.join(at, name)
            if os.path.relpath(path, directory).replace(os.sep, "/") not in used:
                os.unlink(path)
        if at != directory and not os.listdir(at):
            os.rmdir(at)


def compiled(made: MjcfRobot, robot: Context) -> Any:
    """MuJoCo's model.

    Raises:
        UrdfkitError: MuJoCo rejects it.
    """
    with _rejections(robot):
        return made.spec.compile()


def _written(made: MjcfRobot, path: str, robot: Context) -> Any:
    """The file, as MuJoCo loads it."""
    compiled(made, robot)
    _write_all_digits()
    atomic.make_directory(os.path.dirname(path))  # of a robot without files
    with _rejections(robot):
        atomic.write(path, made.spec.to_xml().encode(), durable=False)
        return mujoco.MjModel.from_xml_path(path)


@contextmanager
def _rejections(robot: Context) -> Iterator[None]:
    """Errors of MuJoCo as ours; what it warns of, as in meshes, is found by a check."""
    mujoco.set_mju_user_warning(_ignore)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    except (ValueError, mujoco.FatalError) as error:
        raise _explained(str(error), robot) from error


def _ignore(warning: str) -> None:
    """MuJoCo writes what it warns of to a file in the current directory otherwise."""


def _write_all_digits() -> None:
    """Let MuJoCo write numbers as they are: it writes six digits, and has no public switch."""
    library = glob.glob(os.path.join(os.path.dirname(mujoco.__file__), "*mujoco.*"))[0]
    ctypes.CDLL(library)._mjPRIVATE__set_xml_precision(15)


def _explained(text: str, robot: Context) -> UrdfkitError:
    """An error of MuJoCo's compiler, at the link or joint that it names."""
    what = " ".join(text.split()).removeprefix("Error: ")
    what = what.replace("; use 'balanceinertia' to fix", "")  # which invents an inertia
    named = _ELEMENT.search(what)
    name = named.group(1) if named else ""
    what = f"{what[: named.start()].strip()} ('{name}')" if named else what
    part = robot.model.links_by_name.get(name) or robot.model.joints_by_name.get(name)
    where = f"{part.at.span}: " if part else ""
    see = f"see 'urdfkit check {robot.source.path} --target mujoco'"
    return UrdfkitError(f"{where}MuJoCo rejects the robot: {what}; {see}")


def _counts(model: Any) -> dict[str, int]:
    return {
        "link": int(model.nbody) - 1,
        "joint": int(model.njnt),
        "geom": int(model.ngeom),
        "actuator": int(model.nu),
        "sensor": int(model.nsensor),
        "camera": int(model.ncam),
        "keyframe": int(model.nkey),
    }
