"""A robot for the 3D engine in a page: surfaces, and how joints move links."""

from __future__ import annotations

import gzip
from typing import TYPE_CHECKING, Any

from urdfkit.core.installation import install_command
from urdfkit.core.record import Record
from urdfkit.errors import MissingLibrary, Unavailable
from urdfkit.robot.viewer_model import viewer_model

if TYPE_CHECKING:
    from urdfkit.lint.context import Context
    from urdfkit.render import Scene

#: Limits of a page: more links are too slow to open, more triangles too large to send.
MAX_LINKS, MAX_TRIANGLES = 5000, 1_500_000


def without_report() -> str:
    """Message if the libraries for images and the 3D view are not installed."""
    return f"images and the 3D view need: {install_command('report')}"


class PageScene(Record):
    """A robot in the format of the 3D engine."""

    model: bytes  # binary glTF, compressed with gzip; each surface in the frame of its link
    robot: dict[str, Any]  # links, and joints with parents before children, as plain values


def surfaces(context: Context) -> Scene:
    """The triangles of a robot, for images and for the engine.

    Raises:
        Unavailable: a library is not installed, or the robot has too many links for a page.
    """
    if len(context.model.links) > MAX_LINKS:
        raise Unavailable(f"{len(context.model.links)} links are more than a page can show")
    try:
        from urdfkit.render import build as build_surfaces
    except (ImportError, MissingLibrary) as error:
        raise Unavailable(without_report()) from error
    return build_surfaces(context, roles=("visual", "collision"))


def build(context: Context, built: Scene) -> PageScene:
    """The scene of a robot; simplified if the robot has very many triangles."""
    from urdfkit.output.report.gltf import write
    from urdfkit.render.coarse import coarsened

    model, triangles = write(coarsened(built.items, MAX_TRIANGLES))
    robot = {
        **viewer_model(context.model, context.tree),
        "triangles": triangles,
        "missing": [list(map(str, missing)) for missing in built.missing],
    }
    return PageScene(packed(model), robot)


def nothing() -> PageScene:
    """The scene of a robot that cannot be read.

    Raises:
        Unavailable: numpy is not installed.
    """
    try:
        from urdfkit.output.report.gltf import write
    except (ImportError, MissingLibrary) as error:
        raise Unavailable(without_report()) from error
    model, triangles = write(())
    return PageScene(
        packed(model), {"links": [], "joints": [], "triangles": triangles, "missing": []}
    )


def packed(model: bytes) -> bytes:
    """A compressed model."""
    return gzip.compress(model, 6, mtime=0)  # 9 takes twice as long for 0.1 % less
