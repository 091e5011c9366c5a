"""Animations: a robot on a turntable, or a joint that moves through its range."""

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
from urdfkit.render.image import render_view
from urdfkit.render.labels import opaque
from urdfkit.render.pixels import STUDIO
from urdfkit.render.scene import Scene
from urdfkit.robot import kinematics
from urdfkit.robot.joint_limits import bounds

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from urdfkit.core.progress import Progress

#: Animation formats by suffix.
FORMATS = {".gif": "GIF", ".webp": "WEBP", ".png": "PNG", ".apng": "PNG"}
#: Images of an animation, and duration of each in ms.
FRAMES, DURATION = 48, 70

Shot = tuple[Scene, Camera]


class AnimationError(UrdfkitError):
    """An animation cannot be rendered; the text states why."""


def swept_circle(points: Floats) -> Floats:
    """Points (n, 3) whose hull contains the points in any rotation about their vertical middle."""
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
    """One revolution of a camera and its lamps around a robot, as on a turntable."""
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
    pose: dict[str, float] | None = None,
    frames: int = FRAMES,
) -> Iterator[tuple[Scene, dict[str, float]]]:
    """A robot while one joint moves from its lower to its upper limit and back.

    A joint without limits makes one revolution.

    Args:
        pose: positions of the other joints, in rad or m.
        frames: number of images.

    Yields:
        The scene and its joint positions.

    Raises:
        AnimationError: the joint does not exist or cannot be moved.
    """
    joints = context.model.joints_by_name
    if joint not in joints:
        raise AnimationError(f"no joint '{joint}'{did_you_mean(joint, list(joints))}")
    swept = joints[joint]
    if not swept.is_single_dof or swept.mimic:
        raise AnimationError(f"joint '{joint}' is {swept.kind or 'of no type'}: it cannot be swept")
    ends = bounds(swept)
    if ends is None and swept.is_prismatic:
        raise AnimationError(f"joint '{joint}' has no limits")
    seen: dict[float, tuple[Scene, dict[str, float]]] = {}
    for number in range(frames):
        if ends is None:
            position = 2 * pi * number / frames
        else:  # the way back has the positions of the way there
            part = min(number, frames - number) / frames
            position = ends[0] + (ends[1] - ends[0]) * (1 - cos(2 * pi * part)) / 2
        if position not in seen:
            positions = {**(pose or {}), joint: position}
            moved = scene._replace(frames=kinematics.frames(context.tree, positions))
            seen[position] = moved, positions
        yield seen[position]


def animated(
    shots: Sequence[Shot], *, progress: Progress | None = None, **drawing: Unpack[DrawingOptions]
) -> list[Image.Image]:
    """The images of an animation, with a common floor.

    Args:
        shots: scenes and cameras.
        progress: called with the number of finished images and of all.
        drawing: as for `draw`.
    """
    level = min(scene.level() for scene, _ in shots)
    has_background = drawing.get("background", STUDIO) is not None
    images = []
    drawn: dict[tuple[int, Camera], Image.Image] = {}  # by the identity of the scene
    for number, (scene, camera) in enumerate(shots):
        key = (id(scene), camera)
        if key not in drawn:
            image = render_view(scene, camera, level, drawing)
            drawn[key] = image.convert("RGB") if has_background else image
        images.append(drawn[key])
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
    """Scenes with a common camera that views all of them; arguments as for `place_camera`."""
    points = np.concatenate([scene.points() for scene, _ in scenes])
    camera = place_camera(points, view, size=size, **camera_options)
    return [(scene, camera) for scene, _ in scenes]


def animation_format(path: str | os.PathLike[str]) -> str:
    """Pillow's name for the format of an animation.

    Raises:
        AnimationError: the suffix is not supported.
    """
    suffix = os.path.splitext(os.fspath(path))[1].lower()
    if suffix not in FORMATS:
        raise AnimationError(
            f"{os.fspath(path)}: unsupported animation format; use {', '.join(FORMATS)}"
        )
    return FORMATS[suffix]


def save_animation(images: Sequence[Image.Image], path: str | os.PathLike[str]) -> None:
    """Write images as a repeating animation: GIF, WebP or APNG, by the suffix.

    Raises:
        AnimationError: the suffix is not supported.
        UnwritableFile: the file cannot be written.
    """
    format = animation_format(path)
    buffer = io.BytesIO()
    first, *rest = _with_one_palette(images) if format == "GIF" else images
    first.save(
        buffer,
        format,
        save_all=True,
        append_images=rest,
        duration=DURATION,
        loop=0,
        **({"quality": 85, "method": 4} if format == "WEBP" else {}),
    )
    atomic.write(path, buffer.getvalue())


def _with_one_palette(images: Sequence[Image.Image]) -> list[Image.Image]:
    """Images with a common palette of 256 colours, so that static parts do not flicker."""
    images = [opaque(image) for image in images]
    few = images[:: max(1, len(images) // 8)]
    width, height = few[0].size
    sheet = Image.new("RGB", (width, height * len(few)))
    for number, image in enumerate(few):
        sheet.paste(image, (0, number * height))
    # The most frequent colours exactly, so that the background is smooth, then means of frequent
    # colours, and colours from the whole range.
    packed = np.asarray(sheet.convert("RGBA")).view(np.uint32).reshape(-1)
    found, counts = np.unique(packed, return_counts=True)
    frequent = found[np.argsort(-counts, kind="stable")[:80]]
    colours = frequent.view(np.uint8).reshape(-1, 4)[:, :3].reshape(-1).tolist()
    for count, method in ((96, Image.Quantize.MEDIANCUT), (80, Image.Quantize.FASTOCTREE)):
        colours += (sheet.quantize(count, method).getpalette() or [])[: count * 3]
    palette = Image.new("P", (1, 1))
    palette.putpalette(colours)
    return [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
