"""Conversion of a robot to another format, with a list of losses and a proof."""

import os
from importlib import import_module

from urdfkit.core.installation import needing
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.output.conversion.formats import FORMATS
from urdfkit.output.conversion.options import ConversionOptions
from urdfkit.output.conversion.result import Conversion


def convert(
    robot: Context | str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    to: str = "mjcf",
    base: str = "auto",
    fixed: str = "keep",
    collision: str = "hull",
    exclude: str = "srdf",
    force: bool = False,
) -> Conversion:
    """Write a robot in another format with its meshes, and compare the result with the robot.

    Native libraries (USD, MuJoCo, Pinocchio) run in the process of the caller, which their crash
    would end; the command line runs them in a separate process.

    Args:
        robot: a URDF or xacro file, or the result of `urdfkit.read`.
        out: a directory; after an error, nothing is written.
        to: a name of `FORMATS`.
        base: ``fixed`` welds the root to the world, ``free`` lets it float; ``auto`` lets a robot
            on wheels or feet float.
        fixed: ``keep`` gives each link a body; ``merge`` turns links of fixed joints into sites
            and geoms of their parents.
        collision: replacement of a collision mesh: ``hull``, its convex hull; ``decompose``,
            convex pieces; ``primitives``, the shapes of ``urdfkit mesh collision``.
        exclude: pairs of links that do not collide: ``srdf``, pairs that the SRDF disables;
            ``computed``, also pairs that ``urdfkit collisions`` finds.
        force: replace an existing conversion.

    Raises:
        MissingLibrary: a library of the format is not installed.
        UrdfkitError: the format is unknown; the robot cannot be converted, or is rejected; a file
            is missing, broken, or cannot be written.
    """
    if to not in FORMATS:
        raise UrdfkitError(f"no format '{to}'{did_you_mean(to, FORMATS)}")
    options = ConversionOptions(base, fixed, collision, exclude)
    if options != ConversionOptions() and to != "mjcf":
        raise UrdfkitError(
            f"the format '{to}' does not support base, fixed, collision and exclude; omit them"
        )
    least = {"mujoco": 4} if to == "mjcf" else {}
    with needing(f"conversion to {to}", FORMATS[to], **least):
        module = import_module(f"{__name__}.{to}")
    context = robot if isinstance(robot, Context) else read(robot)
    conversion: Conversion = module.write(context, os.path.abspath(out), options, force=force)
    return conversion
