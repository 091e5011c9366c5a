"""Conversion to MJCF, with its proof."""

import ctypes
import glob
import os
from typing import Any

import mujoco

from urdfkit.core import atomic
from urdfkit.lint.context import Context
from urdfkit.output.bundle import Bundle
from urdfkit.output.bundle.consumers import CONSUMERS
from urdfkit.output.bundle.writing import staged
from urdfkit.output.conversion.hull_deviation import record_hulls
from urdfkit.output.conversion.mjcf_assembly import assembled, compiled, floats, rejections
from urdfkit.output.conversion.mjcf_inputs import add_options
from urdfkit.output.conversion.mjcf_proof import prove
from urdfkit.output.conversion.mjcf_robot import MjcfRobot
from urdfkit.output.conversion.mjcf_srdf import add_keyframes, exclude_computed, exclude_neighbours
from urdfkit.output.conversion.options import ConversionOptions
from urdfkit.output.conversion.result import REPORT, Conversion, proven

_LOST = "urdfkit does not convert it"
_REASONS = {
    "plugin": "plugins run only in Gazebo",
    "material": "no geom uses it",
    "update_rate": "MuJoCo measures in every step",
    "always_on": "MuJoCo measures in every step",
    "@acceleration": "MuJoCo does not limit accelerations",
    "@jerk": "MuJoCo does not limit jerk",
}


def write(robot: Context, out: str, options: ConversionOptions, *, force: bool) -> Conversion:
    """Write a robot; the arguments and errors are those of `urdfkit.output.conversion.convert`."""
    is_free = floats(robot, options.base)
    bundle = Bundle(robot, CONSUMERS["mujoco"])
    # Without the URDF and the manifest.
    assets = (file for file in bundle.files() if "/" in file.path)
    with staged(assets, out, force=force, mark=REPORT) as directory:
        mjcf = assembled(robot, bundle.new_references, directory, options, is_free=is_free)
        add_options(mjcf, robot)
        exclude_neighbours(mjcf, robot)
        if options.exclude == "computed":
            exclude_computed(mjcf, robot)
        with rejections(robot, mjcf.mesh_places):
            add_keyframes(mjcf, robot)
        _remove_unused(mjcf, directory)
        model = _written(mjcf, os.path.join(directory, f"{bundle.name}.xml"), robot)
        proof = proven(prove(model, robot, mjcf.shapes), robot)
        record_hulls(mjcf.losses, robot, mjcf.hulls)
        entries = tuple(mjcf.losses.entries(robot.document.root, _LOST, _REASONS))
        root = "free" if is_free else "fixed"
        conversion = Conversion("mjcf", f"{bundle.name}.xml", root, _counts(model), entries, proof)
        conversion.write_report(directory)
    return conversion


def _remove_unused(mjcf: MjcfRobot, directory: str) -> None:
    """Remove files of the bundle that the MJCF does not use, such as materials of OBJ."""
    used = {asset.file for asset in (*mjcf.spec.meshes, *mjcf.spec.textures)}
    for at, _, names in list(os.walk(directory, topdown=False)):
        for name in names:
            path = os.path.join(at, name)
            if os.path.relpath(path, directory).replace(os.sep, "/") not in used:
                os.unlink(path)
        if at != directory and not os.listdir(at):
            os.rmdir(at)


def _written(mjcf: MjcfRobot, path: str, robot: Context) -> Any:
    """Write the file, and load it with MuJoCo."""
    compiled(mjcf, robot)
    _write_all_digits()
    atomic.make_directory(os.path.dirname(path))  # missing if the robot has no files
    with rejections(robot, mjcf.mesh_places):
        atomic.write(path, mjcf.spec.to_xml().encode(), durable=False)
        return mujoco.MjModel.from_xml_path(path)


def _write_all_digits() -> None:
    """Make MuJoCo write all digits: it writes six, and has no public option for it."""
    library = glob.glob(os.path.join(os.path.dirname(mujoco.__file__), "*mujoco.*"))[0]
    ctypes.CDLL(library)._mjPRIVATE__set_xml_precision(15)


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
