"""Real robot parts as placeholders for missing meshes.

`parts.json` contains the parts and the sources of their dimensions; details within the published
outlines are estimates. A part has x forwards, z upwards, and its origin in the middle; a wheel
rotates about z.
"""

import json
import os
import re
from collections.abc import Iterable
from typing import Any, NamedTuple

from urdfkit.core.spatial import Vector, vector
from urdfkit.mesh.geometry import Mesh

#: Words in the name of a file or link that mean a kind of part, more special kinds first: a mecanum
#: wheel is a wheel, a depth camera a camera.
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
    """A part that can be generated."""

    name: str  # for people
    key: str  # identifier, such as ``rplidar_a2``
    words: str  # words in the name of a file or link that mean this very part
    kind: str  # of part; of several parts of a kind, the one nearest in size is chosen
    size: Vector  # outer dimensions in m, along x, y, z
    brand: str  # another word for the kind that means this part only; may be empty
    solids: list[dict[str, Any]]  # its solids, in the format of `urdfkit.mesh.parts.building`
    rotate: Vector  # rotations about x, y and z in degrees, from the axes of the solids to the part

    @property
    def turns(self) -> bool:
        """True for a part whose z axis is its axis of rotation."""
        return self.kind in ("wheel", "mecanum wheel")

    def matches(self, words: set[str], *, exactly: bool) -> set[str]:
        """The words that mean this very part if ``exactly``, or else its kind."""
        own = self.words if exactly else f"{_KIND_WORDS[self.kind]} {self.brand}"
        return words.intersection(own.split())

    def build(self, size: Vector | None = None, names: Iterable[str] = ()) -> Mesh:
        """The mesh of the part.

        Args:
            size: outer dimensions in m, along its own axes; by default of the real part.
            names: names from which the corner of a mecanum wheel is inferred.
        """
        from urdfkit.mesh.parts.building import built

        mesh = built(self, size or self.size)
        if self.kind == "mecanum wheel" and is_left_handed(names):
            from urdfkit.mesh.transforms import scaled

            return scaled(mesh, (1.0, -1.0, 1.0))
        return mesh


def _load() -> tuple[RealPart, ...]:
    with open(os.path.join(os.path.dirname(__file__), "parts.json"), encoding="utf-8") as file:
        content = json.load(file)
    return tuple(
        RealPart(
            entry["name"],
            entry["key"],
            entry["words"],
            entry["kind"],
            vector(edge / 1000 for edge in entry["size"]),
            entry.get("brand", ""),
            entry["solids"],
            vector(entry.get("rotate", (0.0, 0.0, 0.0))),
        )
        for entry in content["parts"]
    )


#: All parts; in case of ties, earlier parts are chosen.
PARTS = _load()

#: Words for objects that hold or cover a part.
_HOLDERS = frozenset(
    "adapter beam bracket cable cage cap cover guard holder mast mount mounting plate pole post "
    "rail riser shield stand support tower".split()
)


class Choice(NamedTuple):
    """A chosen part and the reason."""

    part: RealPart
    reason: str  # such as ``'hokuyo' in the name of the file means a 2D lidar``


def choose(names: dict[str, str], size: Vector | None) -> Choice | None:
    """The part that names refer to.

    Args:
        names: names by the object that has the name, such as ``the file``, by importance.
        size: outer dimensions in m of the missing mesh; of several parts of a kind, the one nearest
            in proportions and size is chosen.
    """
    for exactly in (True, False):
        for named, name in names.items():
            words = split_words(name)
            if named == "the file" and words & _HOLDERS:
                return None
            matches = [part for part in PARTS if part.matches(words, exactly=exactly)]
            if not matches:
                continue
            kind = matches[0].kind
            same_kind = [part for part in matches if part.kind == kind]
            part = min(same_kind, key=lambda part: _misfit(part, size))
            word = min(part.matches(words, exactly=exactly))
            article = "an" if kind[0] in "aeiouIAEO" else "a"
            return Choice(part, f"'{word}' in the name of {named} means {article} {kind}")
    return None


#: Words for front left and rear right.
_LEFT_HANDED = frozenset("fl lf rr br rb".split())


def is_left_handed(names: Iterable[str]) -> bool:
    """True for a front left or rear right mecanum wheel.

    Seen from above, the upper rollers of the four wheels form an X, so that these two wheels are
    mirror images of the others.
    """
    words = {word for name in names for word in split_words(name)}
    if words & _LEFT_HANDED:
        return True
    front, left = "front" in words, "left" in words
    is_complete = (front or words & {"rear", "back"}) and (left or "right" in words)
    return bool(is_complete) and front == left


def split_words(name: str) -> set[str]:
    """The words of a name, split at punctuation and capitals, with and without digits."""
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
    pieces = [piece.lower() for piece in re.split(r"[^A-Za-z0-9]+", spaced) if piece]
    bare = [letters for piece in pieces for letters in re.findall(r"[a-z]{3,}", piece)]
    return {*pieces, *bare}


def _misfit(part: RealPart, size: Vector | None) -> float:
    """The mismatch of dimensions, as a sum of squared ratios."""
    if size is None:
        return 0.0
    return sum((a / b if a > b else b / a) ** 2 for a, b in zip(part.size, size, strict=True))
