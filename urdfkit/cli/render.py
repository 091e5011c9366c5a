"""``urdfkit render``: an image of a robot."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from urdfkit.cli import options, output
from urdfkit.cli.decorators import described, limited, option
from urdfkit.cli.posing import posed, positions
from urdfkit.cli.progress import progress_bar, working
from urdfkit.cli.robot import last_file, one_robot
from urdfkit.cli.robot import robot as read_robot
from urdfkit.core.temporary import scratch
from urdfkit.core.words import counted
from urdfkit.errors import UrdfkitError
from urdfkit.text.source import shown

if TYPE_CHECKING:
    from urdfkit.lint.context import Context
    from urdfkit.render import Background, CameraOptions, DrawingOptions, Scene

VIEWS = ("iso", "front", "back", "left", "right", "top", "bottom")
#: Sizes in pixels of an image, an animation, two states side by side, and a thumbnail.
SIZE, MOVING, DIFFERENCE, THUMBNAIL = "1280x720", "640x400", "1920x480", "256x256"

#: Most meshes drawn as boxes that are listed by name.
_NAMED = 5


@described("render")
@one_robot
@option("-o, --output FILE", "Image to write: .png, .webp, .jpg ...", required=True)
@option("--view NAMES", f"{', '.join(VIEWS)}, or all.", to="views", multiple=True)
@option(
    "--layers NAMES",
    "visual, collision, frames, joints, mass, inertia, contacts, names.",
    multiple=True,
)
@option("--findings", "Colour links with errors red, with warnings orange.")
@posed
@option("--turntable", "Turntable animation as .gif, .webp or .apng.")
@option("--sweep JOINT", "Animation of a joint over its range, as .gif, .webp or .apng.")
@option("--diff", "Draw two files, or REVISION:FILE, and their difference.")
@option("--thumbnail", f"Image of {THUMBNAIL} pixels with a transparent background.")
@click.option(
    "--azimuth", type=float, help="Camera azimuth in degrees, from the front to the left."
)
@click.option("--elevation", type=float, help="Camera elevation in degrees above the horizon.")
@click.option("--distance", type=float, help="Camera distance in m. [default: fit the robot]")
@option("--orthographic", "Orthographic projection.")
@option(
    "--size WIDTHxHEIGHT",
    f"Size in pixels. [default: {SIZE}; {MOVING} for animations, {DIFFERENCE} with --diff]",
)
@option("--background COLOUR", "A name, #rrggbb, or 'transparent'.")
@option("--no-ground", "Do not draw the ground.")
@click.option(
    "--quality",
    type=click.Choice(["draft", "default", "high"]),
    default="default",
    help="Antialiasing quality.",
)
@limited
def command(inputs: dict[str, Any], **values: Any) -> int:
    """Render images and animations of a robot.

    Needs neither a display nor a graphics card. A missing or broken mesh is drawn as a striped box
    and reported. The same robot gives the same bytes.

    Exit codes: 0 done, 2 usage or input error.

    Examples:
        urdfkit render robot.urdf.xacro -o robot.png --view iso,front,top
        urdfkit render robot.urdf.xacro -o bent.png --joint elbow=90deg
        urdfkit render robot.urdf.xacro -o elbow.gif --sweep elbow
    """
    files, count = options.files(inputs), 2 if values["diff"] else 1
    if len(files) != count:
        number = "two files" if count == 2 else "one file"
        raise options.UsageError(f"render takes {number}; xacro arguments are written name:=value")
    kinds = [name for name in ("diff", "sweep", "turntable", "thumbnail") if values[name]]
    if len(kinds) > 1:
        raise options.UsageError(f"--{kinds[0]} and --{kinds[1]} cannot be combined")
    if values["diff"]:
        scene = _difference(files, inputs, values)
    else:
        robot = read_robot(inputs)
        pose = positions(robot, inputs)
        scene = _scene(robot, pose, values)
        if not scene.items:
            raise UrdfkitError(
                f"{files[0]}: nothing to draw: no geometry in these layers; "
                "try --layers frames,names"
            )
        if values["turntable"] or values["sweep"]:
            _animation(robot, pose, scene, values)
        else:
            _picture(scene, values)
    _print_notes(scene)
    return 0


def _scene(robot: Context, pose: dict[str, float], values: dict[str, Any]) -> Scene:
    """The image of the robot in its pose, with the requested overlays."""
    from urdfkit import render
    from urdfkit.lint.engine import check_with
    from urdfkit.lint.options import Options

    layers = options.words(values, "layers") or _default_layers(robot)
    roles = tuple(layer for layer in layers if layer in ("visual", "collision"))
    scene = render.build(robot, pose, roles)
    scene = render.with_layers(scene, robot, [name for name in layers if name not in roles], pose)
    if not values["findings"]:
        return scene
    as_read = Options(arguments=robot.arguments, trust=robot.trust)
    with working():
        report = check_with(as_read, [robot.source], robot.resolver)
    return render.marked(scene, robot, report.diagnostics)


def _default_layers(robot: Context) -> list[str]:
    """The visuals, or the collisions of a robot without visuals."""
    seen = sum(bool(link.visuals) for link in robot.model.links)
    hidden = sum(bool(link.collisions and not link.visuals) for link in robot.model.links)
    if hidden and not seen:
        output.note("no link has a <visual>: collision shapes are drawn")
        return ["collision"]
    if hidden > seen:
        links = counted(hidden, "link")
        output.note(f"not drawn: {links} with <collision> only; try --layers visual,collision")
    return ["visual"]


def _picture(scene: Scene, values: dict[str, Any]) -> None:
    from urdfkit import render

    named = _views(values)
    if values["thumbnail"]:
        values["size"] = values["size"] or THUMBNAIL
        values["background"] = values["background"] or "transparent"
    with progress_bar() as bar:
        image = render.render_image(
            scene,
            named,
            size=_size(values["size"] or SIZE),
            camera_options=_camera(values),
            progress=bar,
            **_drawing(values),
        )
    render.save(image, values["output"])
    output.page([f"wrote {shown(values['output'])}"])


def _animation(
    robot: Context, pose: dict[str, float], scene: Scene, values: dict[str, Any]
) -> None:
    """An animation: a turn of the robot, or a sweep of one of its joints."""
    from urdfkit import render

    path = values["output"]
    render.animation_format(path)
    size, view = _size(values["size"] or MOVING), _one_view(values)
    if values["turntable"]:
        points = render.swept_circle(scene.points())
        shots = render.orbit(scene, render.place_camera(points, view, size=size, **_camera(values)))
    else:
        scenes = render.sweep(scene, robot, values["sweep"], pose)
        shots = render.followed(list(scenes), view, size=size, **_camera(values))
    with progress_bar() as bar:
        images = render.animated(shots, progress=bar, **_drawing(values))
    with working():
        render.save_animation(images, path)
    output.page([f"wrote {shown(path)}"])


def _difference(files: Sequence[str], inputs: dict[str, Any], values: dict[str, Any]) -> Scene:
    """The image of both states side by side, and the second state."""
    from urdfkit import render
    from urdfkit.output.comparison.states import RobotState

    with working(), scratch() as directory:
        scenes = []
        read_settings = options.check_options(inputs, last_file(files))
        for file, name in zip(files, ("before", "after"), strict=True):
            path = os.path.join(os.path.realpath(directory), name)
            robot = RobotState(file, path, read_settings).context
            scenes.append(_scene(robot, positions(robot, inputs), values))
        before, after = scenes
        image = render.difference(
            before,
            after,
            _one_view(values),
            size=_size(values["size"] or DIFFERENCE),
            camera_options=_camera(values),
            **_drawing(values),
        )
    render.save(image, values["output"])
    output.page([f"wrote {shown(values['output'])}"])
    return after


def _camera(values: dict[str, Any]) -> CameraOptions:
    return {
        "azimuth": values["azimuth"],
        "elevation": values["elevation"],
        "distance": values["distance"],
        "orthographic": values["orthographic"],
    }


def _drawing(values: dict[str, Any]) -> DrawingOptions:
    return {
        "quality": values["quality"],
        "background": _background(values["background"]),
        "floor": not values["no_ground"],
    }


def _views(values: dict[str, Any]) -> Sequence[str]:
    named = options.words(values, "views") or ["iso"]
    for view in named:
        if view not in (*VIEWS, "all"):
            raise options.UsageError(
                f"--view {view}: unknown view; expected {', '.join(VIEWS)} or all"
            )
    return VIEWS if "all" in named else named


def _one_view(values: dict[str, Any]) -> str:
    named = _views(values)
    if len(named) != 1:
        raise options.UsageError("--view: only one view is possible here")
    return named[0]


def _size(word: str) -> tuple[int, int]:
    width, _, height = word.lower().partition("x")
    if not (width.isdecimal() and height.isdecimal()):
        raise options.UsageError(f"--size {word}: expected WIDTHxHEIGHT, such as 1280x720")
    return int(width), int(height)


def _background(word: str | None) -> Background | None:
    from urdfkit import render

    if word is None:
        return render.STUDIO
    if word == "transparent":
        return None
    rgb = render.colour(word)
    return rgb, rgb


def _print_notes(scene: Scene) -> None:
    """Print notes on meshes that are drawn as boxes, and on letters without a font."""
    from urdfkit import render

    for mesh in scene.missing[:_NAMED]:
        description = f"the {mesh.role} mesh of '{mesh.link}', {mesh.filename}"
        output.note(f"drawn as a striped box: {description} ({mesh.reason})")
    if more := scene.missing[_NAMED:]:
        output.note(f"drawn as striped boxes: {len(more)} more meshes")
    for note in scene.notes:
        output.note(note)
    if letters := render.unwritable(label.text for label in scene.labels):
        output.note(f"no font here has {letters}; install one, such as fonts-noto-cjk")
