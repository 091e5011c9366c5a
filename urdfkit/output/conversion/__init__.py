"""A robot in another format, with what is lost on the way, and a proof."""

from __future__ import annotations

import os
from importlib import import_module
from typing import TYPE_CHECKING

from urdfkit.core.installation import needing
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.output.conversion.formats import FORMATS
from urdfkit.output.conversion.options import ConversionOptions

if TYPE_CHECKING:
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
    """Write a robot in another format with its meshes, and compare what was written with it.

    Native libraries (USD, MuJoCo, Pinocchio) run in the process of the caller, which a crash of one
    ends; the command line runs them in a process of its own.

    Args:
        robot: a URDF or xacro file, or what `urdfkit.read` gives of one.
        out: a directory; whole or not at all.
        to: a name of `FORMATS`.
        base: ``fixed`` welds the root to the world, ``free`` lets it float; ``auto`` lets a robot
            float that stands on wheels or feet.
        fixed: ``keep`` gives each link a body; ``merge`` makes those of fixed joints sites and
            geoms of their parents.
        collision: what a collision mesh becomes: ``hull``, its convex hull; ``decompose``, convex
            pieces of it; ``primitives``, what ``urdfkit mesh collision`` takes for it.
        exclude: which links do not collide: ``srdf``, those that it disables; ``computed``, also
            those that ``urdfkit collisions`` finds.
        force: replace what is there, if it is a conversion.

    Raises:
        MissingLibrary: a library of the format is not installed.
        UrdfkitError: there is no such format; the robot cannot be converted, or is rejected; a file
            is missing, broken, or cannot be written.
    """
    if to not in FORMATS:
        raise UrdfkitError(f"no format '{to}'{did_you_mean(to, FORMATS)}")
    options = ConversionOptions(base, fixed, collision, exclude)
    if options != ConversionOptions() and not FORMATS[to].has_options:
        raise UrdfkitError(
            f"base, fixed, collision and exclude are not of the format '{to}': leave them out"
        )
    with needing(f"to convert to {to}", FORMATS[to].extra):
        module = import_module(f"{__name__}.{to}")
    context = robot if isinstance(robot, Context) else read(robot)
    found: Conversion = module.write(context, os.path.abspath(out), options, force=force)
    return found
