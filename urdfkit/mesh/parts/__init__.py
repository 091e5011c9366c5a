"""Real parts of robots, to stand in for meshes that are missing.

`parts.json` has them, each with the source of its sizes; what lies within the published outlines is
drawn by eye. A part has x forwards, z upwards, and its origin in the middle; a wheel turns about z.
"""

import json
import os
import re
from collections.abc import Iterable
from typing import Any, NamedTuple

from urdfkit.core.spatial import Vector, vector
from urdfkit.mesh.geometry import Mesh

#: The words in the name of a file or link that mean a kind of part, in the order in which they are
#: asked for: a mecanum wheel is a wheel, a depth camera a camera.
_KIND_WORDS = {
    "2D lidar": "laser lidar ladar scan scanner lds ydlidar lms lms1xx tim",
    "3D lidar": "velodyne vlp hdl ouster os0 os1 os2 pandar hesai livox mid360 lidar3d",
    "mecanum wheel": "mecanum omni omniwheel swedish",
    "caster": "caster castor casters",
    "stereo camera": "stereo multisense bumblebee",
    "depth camera": "realsense depth rgbd kinect astra xtion orbbec structure",
    "camera": "camera cam webcam rgb usbcam pointgrey mono",
    "IMU": "imu ahrs gyro mpu mpu6050 mpu9250 bno bno055 bno085",
    "wheel": "wheel tire tyre rim wheels drivewheel rueda roue rad",
}


class RealPart(NamedTuple):
    """A part that can be made."""

    name: str  # as a person calls it
    key: str  # the name for programs, such as ``rplidar_a2``
    words: str  # in the name of a file or link, that mean this very part
    kind: str  # of part; of several of a kind the one nearest in size is taken
    size: Vector  # its true outer edges in m, along x, y, z
    brand: str  # another word that means its kind, and none of the others of it; empty for none
    solids: list[dict[str, Any]]  # that it is made of, as `urdfkit.mesh.parts.building` reads them
    rotate: Vector  # rotations about x, y and z in degrees, from their axes to those of the part

    @property
    def turns(self) -> bool:
        """True for a part whose z axis is to be laid along the axis that it turns about."""
        return self.kind in ("wheel", "mecanum wheel")

    def named_by(self, words: set[str], *, exactly: bool) -> set[str]:
        """Those of some words that mean this very part, or else its kind."""
        own = self.words if exactly else f"{_KIND_WORDS[self.kind]} {self.brand}"
        return words.intersection(own.split())

    def build(self, size: Vector | None = None, names: Iterable[str] = ()) -> Mesh:
        """Its triangles.

        Args:
            size: outer edges in m, along its own axes; those of the real part if not given.
            names: from which the corner of a mecanum wheel is inferred.
        """
        from urdfkit.mesh.parts.building import built

        mesh = built(self, size or self.size)
        if self.kind == "mecanum wheel" and is_left_handed(names):
            from urdfkit.mesh.transforms import scaled

            return scaled(mesh, (1.0, -1.0, 1.0))
        return mesh


def _known() -> tuple[RealPart, ...]:
    with open(os.path.join(os.path.dirname(__file__), "parts.json"), encoding="utf-8") as file:
        content = json.load(file)
    return tuple(
        RealPart(
            one["name"],
            one["key"],
            one["words"],
            one["kind"],
            vector(edge / 1000 for edge in one["size"]),
            one.get("brand", ""),
            one["solids"],
            vector(one.get("rotate", (0.0, 0.0, 0.0))),
        )
        for one in content["parts"]
    )


#: In the order in which they are asked for.
PARTS = _known()


#: What holds or hides a part is another thing.
_HOLDERS = frozenset(
    "adapter beam bracket cable cage cap cover guard holder mast mount mounting plate pole post "
    "rail riser shield stand support tower".split()
)


class Choice(NamedTuple):
    """A part that was chosen, and why."""

    part: RealPart  # that was chosen
    reason: str  # such as ``'hokuyo' in the name of the file means a 2D lidar``


def choose(names: dict[str, str], size: Vector | None) -> Choice | None:
    """The part that some names mean.

    Args:
        names: what each is the name of, such as ``the file``, by importance.
        size: outer edges in m of what it stands for; of several parts of a kind the one whose
            proportions and size are nearest is taken.
    """
    for exactly in (True, False):
        for what, name in names.items():
            words = split_words(name)
            if what == "the file" and words & _HOLDERS:
                return None
            fitting = [part for part in PARTS if part.named_by(words, exactly=exactly)]
            if not fitting:
                continue
            kind = fitting[0].kind
            alike = [part for part in fitting if part.kind == kind]
            part = min(alike, key=lambda one: _misfit(one, size))
            word = min(part.named_by(words, exactly=exactly))
            article = "an" if kind[0] in "aeiouIAEO" else "a"
            return Choice(part, f"'{word}' in the name of {what} means {article} {kind}")
    return None


#: Words for front left and rear right.
_LEFT_HANDED = frozenset("fl lf rr br rb".split())


def is_left_handed(names: Iterable[str]) -> bool:
    """True for a mecanum wheel in front on the left, or behind on the right.

    Seen from above, the upper rollers of the four wheels make an X, so that these two are the
    mirror images of the others.
    """
    words = {word for name in names for word in split_words(name)}
    if words & _LEFT_HANDED:
        return True
    front, left = "front" in words, "left" in words
    known = (front or words & {"rear", "back"}) and (left or "right" in words)
    return bool(known) and front == left


def split_words(name: str) -> set[str]:
    """The words of a name: parted by signs, numbers and capitals, with and without numbers."""
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
    pieces = [piece.lower() for piece in re.split(r"[^A-Za-z0-9]+", spaced) if piece]
    bare = [letters for piece in pieces for letters in re.findall(r"[a-z]{3,}", piece)]
    return {*pieces, *bare}


def _misfit(part: RealPart, size: Vector | None) -> float:
    """How far the edges of a part are from those wanted, as a sum of squared ratios."""
    if size is None:
        return 0.0
    return sum((a / b if a > b else b / a) ** 2 for a, b in zip(part.size, size, strict=True))
