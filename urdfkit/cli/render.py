"""``urdfkit render``: a picture of a robot."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import click

from urdfkit.cli import options
from urdfkit.formats._layout import printable

if TYPE_CHECKING:
    from urdfkit.render import Background, Missing

VIEWS = ("iso", "front", "back", "left", "right", "top", "bottom")


@click.command("render")
@click.argument("words", nargs=-1, required=True, metavar="FILE [NAME:=VALUE]...")
@click.option("-o", "--output", "path", required=True, metavar="FILE", help="robot.png, .webp ...")
@click.option("--view", "views", multiple=True, metavar="NAMES", help="iso, front, ... or all.")
@click.option("--layers", multiple=True, metavar="NAMES", help="visual, collision, frames ...")
@click.option("--findings", is_flag=True, help="Links with errors red, with warnings orange.")
@click.option("--azimuth", type=float, help="Of the camera, in degrees from the front to the left.")
@click.option("--elevation", type=float, help="Of the camera, in degrees above the horizon.")
@click.option("--distance", type=float, help="Of the camera, in m. [default: all in view]")
@click.option("--orthographic", is_flag=True, help="Without perspective.")
@click.option("--size", default="1280x720", metavar="WIDTHxHEIGHT", help="[default: 1280x720]")
@click.option("--background", metavar="COLOUR", help="A name, #rrggbb, or 'transparent'.")
@click.option("--no-ground", is_flag=True, help="No shadow on the ground.")
@click.option("--quality", type=click.Choice(["draft", "default", "high"]), default="default")
@click.option("--joint", "joints", multiple=True, metavar="NAME=VALUE", help="In rad, deg or m.")
@click.option("--pose", metavar="NAME", help="A pose file, or a state of the SRDF.")
@click.option("--package", multiple=True, metavar="NAME=FOLDER", help="Where a ROS package is.")
@click.option("--trust", is_flag=True, help="Let the model run any expression, read any file.")
def command(
    words: tuple[str, ...],
    path: str,
    views: tuple[str, ...],
    layers: tuple[str, ...],
    findings: bool,
    azimuth: float | None,
    elevation: float | None,
    distance: float | None,
    orthographic: bool,
    size: str,
    background: str | None,
    no_ground: bool,
    quality: str,
    joints: tuple[str, ...],
    pose: str | None,
    package: tuple[str, ...],
    trust: bool,
) -> int:
    """Draw a robot.

    Neither a display nor a graphics card is needed. A mesh that is missing or broken is drawn as
    a striped box, and named. The same robot gives the same bytes.

    Exit codes: 0 done, 2 it cannot be done.
    """
    from urdfkit import poses, render
    from urdfkit.engine import check
    from urdfkit.loading import read

    values = {options.FILES: words, "package": package, "view": views, "layers": layers}
    files = options.files(values)
    if len(files) != 1:
        raise options.UsageError("render takes one file; xacro arguments are written name:=value")
    named = options.words(values, "view") or ["iso"]
    arguments, packages = options.arguments(values), options.packages(values)
    robot = read(files[0], arguments=arguments, packages=packages, trust=trust)
    positions = poses.pose(robot, _joints(joints), pose)
    shown = options.words(values, "layers") or ["visual"]
    roles = tuple(layer for layer in shown if layer in ("visual", "collision"))
    scene = render.explained(
        render.build(robot, positions, roles),
        robot,
        [layer for layer in shown if layer not in roles],
        positions,
    )
    if findings:
        report = check(robot.source, arguments=arguments, packages=packages, trust=trust)
        scene = render.marked(scene, robot, report.diagnostics)
    image = render.picture(
        scene,
        VIEWS if named == ["all"] else named,
        azimuth=azimuth,
        elevation=elevation,
        distance=distance,
        orthographic=orthographic,
        size=_size(size),
        quality=quality,
        background=render.STUDIO if background is None else _background(background),
        floor=not no_ground,
    )
    render.save(image, path)
    _tell(scene.missing)
    return 0


def _size(word: str) -> tuple[int, int]:
    width, _, height = word.lower().partition("x")
    if not (width.isdecimal() and height.isdecimal()):
        raise options.UsageError(f"--size {word}: write width and height, such as 1280x720")
    return int(width), int(height)


def _joints(words: tuple[str, ...]) -> dict[str, str]:
    found = {}
    for word in words:
        name, equals, value = word.partition("=")
        if not (name and equals and value):
            raise options.UsageError(f"--joint {word}: write the name, '=' and a position")
        found[name] = value
    return found


def _background(word: str) -> Background | None:
    from urdfkit.render import colour

    if word == "transparent":
        return None
    rgb = colour(word)
    return rgb, rgb


def _tell(missing: tuple[Missing, ...]) -> None:
    """Say on standard error which meshes are boxes in the picture."""
    for mesh in missing:
        text = f"drawn as a striped box: the {mesh.role} mesh of '{mesh.link}', {mesh.filename}"
        print(printable(f"note: {text} ({mesh.reason})"), file=sys.stderr)
