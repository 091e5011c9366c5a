"""Robots for images, and what can be measured in one."""

import numpy as np

from urdfkit.lint.context import Context
from urdfkit.render import Camera, Scene, build, draw
from urdfkit.render.arrays import Bytes
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml
from urdfkit.workspace.resolve import Resolver

__all__ = ["alone", "colour_at", "corners", "link", "robot", "scene"]


def robot(*links: str, joints: str = "") -> Context:
    """A robot of links, each of which hangs on the first one if no joints are given."""
    names = [text.split('"')[1] for text in links]
    joints = joints or "".join(
        f'<joint name="{name}_joint" type="fixed"><parent link="{names[0]}"/>'
        f'<child link="{name}"/></joint>'
        for name in names[1:]
    )
    text = f'<robot name="r">{"".join(links)}{joints}</robot>'
    context = Context(Source("r.urdf", text.encode()), Resolver())
    assert read_xml(context.source)[0] is not None
    return context


def link(
    name: str, shape: str, xyz: str = "0 0 0", rgba: str = "1 0 0 1", rpy: str = "0 0 0"
) -> str:
    """A link with one visual."""
    return (
        f'<link name="{name}"><visual><origin xyz="{xyz}" rpy="{rpy}"/>'
        f"<geometry>{shape}</geometry>"
        f'<material name="{name}"><color rgba="{rgba}"/></material></visual></link>'
    )


def scene(*links: str) -> Scene:
    return build(robot(*links))


def alone(of: Scene, camera: Camera, quality: str = "draft") -> Bytes:
    """An image of nothing but the robot: alpha is what it covers."""
    return draw(of, camera, quality=quality, background=None, floor=False, threads=1)


def colour_at(pixels: Bytes, x: float, y: float) -> str:
    """The strongest of red, green and blue at a place; ``none`` where nothing is."""
    r, g, b, a = (int(part) for part in pixels[int(y), int(x)])
    return "none" if a < 128 else max(zip((r, g, b), ("red", "green", "blue"), strict=True))[1]


def corners(camera: Camera, points: list[tuple[float, float, float]]) -> np.ndarray:
    """Where points of the world are in an image, (n, 2): written out, as an oracle."""
    found = []
    axes = np.array(camera.axes)
    for point in points:
        right, up, back = axes @ (np.array(point) - np.array(camera.eye))
        scale = camera.scale if camera.is_orthographic else camera.scale / -back
        found.append((camera.size[0] / 2 + right * scale, camera.size[1] / 2 - up * scale))
    return np.array(found)
