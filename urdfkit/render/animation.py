"""Robots that move: on a turntable, or one joint from end to end."""

from __future__ import annotations

import io
import os
from collections.abc import Iterator, Sequence
from math import cos, pi, sin
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image

from urdfkit.core import atomic
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.render.arrays import Floats
from urdfkit.render.camera import Camera, CameraOptions, place_camera
from urdfkit.render.draw import DrawingOptions
from urdfkit.render.image import drawn
from urdfkit.render.labels import opaque
from urdfkit.render.pixels import STUDIO
from urdfkit.render.scene import Scene
from urdfkit.robot import kinematics
from urdfkit.robot.joints import bounds

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from urdfkit.core.progress import Progress

#: What an animation is saved as, by suffix.
FORMATS = {".gif": "GIF", ".webp": "WEBP", ".png": "PNG", ".apng": "PNG"}
#: Images of an animation, and how long each is shown in ms.
FRAMES, DURATION = 48, 70

Shot = tuple[Scene, Camera]


class AnimationError(UrdfkitError):
    """An animation that cannot be made; the text says why."""


def swept_circle(points: Floats) -> Floats:
    """Points (n, 3) that enclose others however these are turned about their vertical middle."""
    if not len(points):
        return points
    lowest, highest = points.min(axis=0), points.max(axis=0)
    middle = (lowest + highest) / 2
    radius = float(np.sqrt(((points[:, :2] - middle[:2]) ** 2).sum(axis=1).max()))
    angles = np.linspace(0, 2 * pi, 64, endpoint=False)
    x, y = middle[0] + radius * np.cos(angles), middle[1] + radius * np.sin(angles)
    ends = [np.stack((x, y, np.full(64, end[2])), axis=1) for end in (lowest, highest)]
    return np.concatenate(ends).astype(np.float32)


def orbit(scene: Scene, camera: Camera, frames: int = FRAMES) -> list[Shot]:
    """One turn of a camera about a robot; lamps turn with it, as before a turntable."""
    points = scene.points()
    middle = (points.min(axis=0) + points.max(axis=0)) / 2 if len(points) else np.zeros(3)
    shots = []
    for number in range(frames):
        angle = 2 * pi * number / frames
        turn = np.array(((cos(angle), -sin(angle), 0), (sin(angle), cos(angle), 0), (0, 0, 1)))
        x, y, z = (middle + turn @ (np.array(camera.eye) - middle)).tolist()
        axes = tuple(tuple(row) for row in (np.array(camera.axes) @ turn.T).tolist())
        shots.append((scene, camera._replace(eye=(x, y, z), axes=axes)))
    return shots


def sweep(
    scene: Scene,
    context: Context,
    joint: str,
    given: dict[str, float] | None = None,
    frames: int = FRAMES,
) -> Iterator[tuple[Scene, dict[str, float]]]:
    """A robot while one joint goes from its lower limit to the upper one and back.

    A joint without limits makes one turn.

    Args:
        given: positions of the others, in rad or m.
        frames: how many images.

    Yields:
        The scene, and the positions in it.

    Raises:
        AnimationError: there is no such joint, or it does not move by itself.
    """
    known = context.model.joints_by_name
    if joint not in known:
        raise AnimationError(f"no joint '{joint}'{did_you_mean(joint, list(known))}")
    one = known[joint]
    if one.kind not in (*kinematics.TURNING, *kinematics.SLIDING) or one.mimic:
        raise AnimationError(f"joint '{joint}' is {one.kind or 'of no type'}: it does not sweep")
    ends = bounds(one)
    if ends is None and one.kind in kinematics.SLIDING:
        raise AnimationError(f"joint '{joint}' has no limits to go between")
    for number in range(frames):
        part = number / frames
        if ends is None:
            position = 2 * pi * part
        else:
            position = ends[0] + (ends[1] - ends[0]) * (1 - cos(2 * pi * part)) / 2
        positions = {**(given or {}), joint: position}
        yield scene._replace(frames=kinematics.frames(context.tree, positions)), positions


def animated(
    shots: Sequence[Shot], *, progress: Progress | None = None, **drawing: Unpack[DrawingOptions]
) -> list[Image.Image]:
    """The images of an animation, on one floor.

    Args:
        shots: what is to be seen, and by which camera.
        progress: called with the number of images done and of all.
        drawing: as `draw` takes it.
    """
    level = min(scene.level() for scene, _ in shots)
    has_background = drawing.get("background", STUDIO) is not None
    images = []
    for number, (scene, camera) in enumerate(shots):
        image = drawn(scene, camera, level, drawing)
        images.append(image.convert("RGB") if has_background else image)
        if progress is not None:
            progress(number + 1, len(shots))
    return images


def followed(
    scenes: Sequence[tuple[Scene, dict[str, float]]],
    view: str = "iso",
    *,
    size: tuple[int, int],
    **camera_options: Unpack[CameraOptions],
) -> list[Shot]:
    """Scenes with one camera that has all in view; the arguments are those of `place_camera`."""
    points = np.concatenate([scene.points() for scene, _ in scenes])
    camera = place_camera(points, view, size=size, **camera_options)
    return [(scene, camera) for scene, _ in scenes]


def animation_format(path: str | os.PathLike[str]) -> str:
    """Pillow's name for the format of an animation.

    Raises:
        AnimationError: the suffix is of none.
    """
    suffix = os.path.splitext(os.fspath(path))[1].lower()
    if suffix not in FORMATS:
        raise AnimationError(f"{os.fspath(path)}: an animation is called {', '.join(FORMATS)}")
    return FORMATS[suffix]


def save_animation(images: Sequence[Image.Image], path: str | os.PathLike[str]) -> None:
    """Write images as one that moves and repeats: GIF, WebP or APNG, by the suffix.

    Raises:
        AnimationError: the suffix is another one.
        UnwritableFile: the file cannot be written.
    """
    form = animation_format(path)
    buffer = io.BytesIO()
    first, *rest = _with_one_palette(images) if form == "GIF" else images
    first.save(
        buffer,
        form,
        save_all=True,
        append_images=rest,
        duration=DURATION,
        loop=0,
        **({"quality": 85, "method": 4} if form == "WEBP" else {}),
    )
    atomic.write(path, buffer.getvalue())


def _with_one_palette(images: Sequence[Image.Image]) -> list[Image.Image]:
    """Images in 256 colours that all of them share, so that still parts stay still."""
    images = [opaque(image) for image in images]
    few = images[:: max(1, len(images) // 8)]
    width, height = few[0].size
    sheet = Image.new("RGB", (width, height * len(few)))
    for number, image in enumerate(few):
        sheet.paste(image, (0, number * height))
    # The most frequent colours as they are, so that the background is smooth, then the means of
    # what is frequent, and some from everywhere.
    packed = np.asarray(sheet.convert("RGBA")).view(np.uint32).reshape(-1)
    found, counts = np.unique(packed, return_counts=True)
    frequent = found[np.argsort(-counts, kind="stable")[:80]]
    colours = frequent.view(np.uint8).reshape(-1, 4)[:, :3].reshape(-1).tolist()
    for count, method in ((96, Image.Quantize.MEDIANCUT), (80, Image.Quantize.FASTOCTREE)):
        colours += (sheet.quantize(count, method).getpalette() or [])[: count * 3]
    palette = Image.new("P", (1, 1))
    palette.putpalette(colours)
    return [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
