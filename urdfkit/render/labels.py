"""Labels, captions and legends in images."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
from PIL import Image, ImageDraw, ImageStat

from urdfkit.core.words import counted
from urdfkit.render.arrays import Floats, rotated
from urdfkit.render.camera import Camera
from urdfkit.render.fonts import writing
from urdfkit.render.raster import Grid, nearest, projected, rooks, split
from urdfkit.render.scene import Scene, placed
from urdfkit.render.soup import cut, soup
from urdfkit.ros.surface_materials import Colour

INK, PAPER, LEADER = (34, 40, 50, 255), (255, 255, 255, 225), (70, 78, 92, 200)
#: Letters on a background darker than a mean of `_DARK`, from 0 to 255.
LIGHT_INK, _DARK = (235, 238, 242, 255), 100
#: Share of the width of an image that the scale may occupy.
_SCALE_SHARE = 0.25
#: Positions of a label around its point, the nearest first: directions and distances in letters.
_DIRECTIONS = ((1, -1), (-1, -1), (1, 1), (-1, 1), (1, 0), (-1, 0), (0, -1), (0, 1))
_DISTANCES = (1.2, 2.4, 4.0, 6.0, 9.0, 13.0)
#: Number of these distances for an optional label.
_OPTIONAL_DISTANCES = 3
#: Step in pixels of the search for visible links.
_SEARCH_STEP = 4


class LabelBox(NamedTuple):
    """The box of a label, in pixels."""

    left: float
    top: float
    right: float
    bottom: float

    def overlaps(self, other: LabelBox) -> bool:
        return (
            self.left < other.right
            and other.left < self.right
            and self.top < other.bottom
            and other.top < self.bottom
        )


def opaque(image: Image.Image) -> Image.Image:
    """An image on white, for formats without transparency."""
    if image.mode != "RGBA":
        return image.convert("RGB")
    return Image.alpha_composite(Image.new("RGBA", image.size, (255,) * 4), image).convert("RGB")


def caption(image: Image.Image, text: str) -> None:
    """Write a text in the upper left corner of an image."""
    size = max(11, min(22, image.height // 22))
    font, written = writing(text, size)
    draw, start = ImageDraw.Draw(image), (size * 0.7, size * 0.5)
    fill = ink(image, draw.textbbox(start, written, font=font))
    draw.text(start, written, fill=fill, font=font)


def ink(image: Image.Image, box: tuple[float, float, float, float]) -> tuple[int, int, int, int]:
    """The colour of letters that are readable in a part of an image."""
    left, top, right, bottom = (round(edge) for edge in box)
    part = opaque(image.crop((left, top, max(right, left + 1), max(bottom, top + 1))))
    return INK if ImageStat.Stat(part.convert("L")).mean[0] >= _DARK else LIGHT_INK


def write_legend(image: Image.Image, entries: Sequence[tuple[Colour | None, str]]) -> None:
    """Write into the lower right corner of an image what colours mean, and words without one.

    A line that would reach the scale in the lower left corner is continued above.
    """
    size = max(11, min(18, image.height // 30))
    draw = ImageDraw.Draw(image)
    margin, low = image.width - size * 0.7, image.height - size * 0.7
    right = margin
    for colour, text in reversed(entries):
        font, written = writing(text, size)
        square = 1.2 * size if colour else 0.0
        left = right - draw.textlength(written, font=font)
        if left - square < image.width * _SCALE_SHARE and right < margin:
            left, low = left + margin - right, low - 1.4 * size
        fill = ink(image, draw.textbbox((left, low), written, font=font, anchor="ls"))
        draw.text((left, low), written, fill=fill, font=font, anchor="ls")
        if colour:
            box = (left - square, low - 0.75 * size, left - 0.4 * size, low + 0.05 * size)
            draw.rectangle(box, fill=tuple(round(part * 255) for part in colour))
        right = left - square - 0.8 * size


def write(image: Image.Image, scene: Scene, camera: Camera) -> None:
    """Write the labels of a scene next to their points, so that none covers another; its legend.

    A label without a free place, or whose point is outside of the image, is omitted; the legend
    counts them.
    """
    size = max(10.0, min(20.0, image.height / 52))
    anchors = _anchors(scene, camera)
    boxes: list[LabelBox] = []
    layer = Image.new("RGBA", image.size, (0, 0, 0, 0))
    draw = ImageDraw.Draw(layer)
    needs_links = any(label.of_link for label in scene.labels)
    links = _links_of_pixels(scene, camera) if needs_links else {}
    for number in sorted(anchors, key=lambda number: (anchors[number][1], number)):
        x, y = anchors[number]
        label = scene.labels[number]
        name = printable(label.text)
        if label.of_link:
            if label.is_optional and label.link not in links:
                continue
            x, y, name = _where_seen(x, y, name, links.get(label.link))
        font, text = writing(name, size)
        wide, high = draw.textlength(text, font=font) + 0.6 * size, 1.35 * size
        distances = _DISTANCES[:_OPTIONAL_DISTANCES] if label.is_optional else _DISTANCES
        places = _places(x, y, wide, high, [distance * size for distance in distances])
        box = _free(places, image.size, boxes)
        if box is None:
            continue
        boxes.append(box)
        _draw_leader(draw, x, y, box, size)
        start = (box.left + 0.3 * size, (box.top + box.bottom) / 2)
        draw.text(start, text, fill=INK, font=font, anchor="lm")
    image.alpha_composite(layer)
    omitted = len(scene.labels) - len(boxes)
    remark = [(None, f"{counted(omitted, 'label')} not shown")] * bool(omitted)
    write_legend(image, (*scene.legend, *remark))


def _draw_leader(draw: ImageDraw.ImageDraw, x: float, y: float, box: LabelBox, size: float) -> None:
    """Draw the empty box of a label, and a line from its point to the box."""
    end = (min(max(x, box.left), box.right), min(max(y, box.top), box.bottom))
    draw.line([(x, y), end], fill=LEADER, width=max(1, round(size / 12)))
    radius = size / 7
    draw.ellipse((x - radius, y - radius, x + radius, y + radius), fill=LEADER)
    draw.rounded_rectangle(box, radius=size / 4, fill=PAPER)


def _anchors(scene: Scene, camera: Camera) -> dict[int, tuple[float, float]]:
    """Positions of the points of labels in the image, by label number."""
    anchors = {}
    rotation, position = camera.to_view(np.eye(3), np.zeros(3))
    for number, label in enumerate(scene.labels):
        point = np.array([label.point], dtype=np.float32)
        view_point = rotated(placed(point, scene.frames[label.link]), rotation) + position
        if not camera.is_orthographic and view_point[0, 2] > -camera.near:
            continue
        x, y, _ = (float(part[0]) for part in camera.project(view_point))
        if 0 <= x < camera.size[0] and 0 <= y < camera.size[1]:
            anchors[number] = (x, y)
    return anchors


def _links_of_pixels(scene: Scene, camera: Camera) -> dict[str, Floats]:
    """The pixels (n, 2) in which each link is visible; one of four by four is tested."""
    width, height = (max(1, edge // _SEARCH_STEP) for edge in camera.size)
    small = camera._replace(size=(width, height))
    items = tuple(item for item in scene.items if not item.material.overlay)
    triangles = cut(soup(scene._replace(items=items), small), small)
    screen, chosen = projected(*small.project(triangles.points), triangles.faces, width)
    grid = Grid(width, 0, height, rooks(1))
    numbers = split(nearest(screen, np.arange(len(chosen)), grid))[0]
    rows, columns = np.nonzero(numbers >= 0)
    owners = triangles.item[chosen][numbers[rows, columns]]
    pixels = (np.stack((columns, rows), axis=1) + 0.5) * _SEARCH_STEP
    names = np.array([item.link for item in items])[owners] if items else owners
    return {str(name): pixels[names == name] for name in np.unique(names)}


def _where_seen(x: float, y: float, text: str, pixels: Floats | None) -> tuple[float, float, str]:
    """The position and text of a label: in the visible part of its link, or marked as hidden."""
    if pixels is None:
        return x, y, f"{text} (hidden)"
    middle = pixels.mean(axis=0)
    x, y = pixels[np.argmin(((pixels - middle) ** 2).sum(axis=1))].tolist()
    return x, y, text


def _places(
    x: float, y: float, wide: float, high: float, distances: Sequence[float]
) -> Iterator[LabelBox]:
    """Boxes around a point, the nearest first."""
    for distance in distances:
        for across, down in _DIRECTIONS:
            left = x + across * distance + (wide * (across - 1) / 2)
            top = y + down * distance * 0.8 + (high * (down - 1) / 2)
            yield LabelBox(left, top, left + wide, top + high)


def _free(
    places: Iterable[LabelBox], whole: tuple[int, int], taken: Sequence[LabelBox]
) -> LabelBox | None:
    """The first box within the image that overlaps no other box."""
    for box in places:
        inside = box.left >= 0 and box.top >= 0 and box.right <= whole[0] and box.bottom <= whole[1]
        if inside and not any(map(box.overlaps, taken)):
            return box
    return None


def printable(text: str) -> str:
    """A name in one short line without control characters."""
    line = "".join(letter if letter.isprintable() else "?" for letter in text)
    return line if len(line) <= 60 else f"{line[:59]}…"
