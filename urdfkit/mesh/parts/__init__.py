"""Real parts of robots, to stand in for meshes that are missing.

A function for each, which says where its sizes come from: what its maker publishes, and who else
has the same. A part has x forwards, z upwards, and its origin in the middle; a wheel turns about z.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from importlib import import_module
from typing import TYPE_CHECKING, NamedTuple

from urdfkit.core.spatial import Vector

if TYPE_CHECKING:
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
    """A part that can be made.

    Attributes:
        name: as a person calls it.
        maker: the module of this package and the function that makes it.
        size: its true outer edges in m, along x, y, z.
        words: in the name of a file or link, that mean this very part.
        kind: of part; of several of a kind the one nearest in size is taken.
        brand: another word that means its kind, and none of the others of it; empty for none.
    """

    name: str
    maker: str
    size: Vector
    words: str
    kind: str
    brand: str = ""

    @property
    def key(self) -> str:
        """The name for programs, such as ``rplidar_a2``."""
        return self.maker.partition(".")[2]

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
        module = import_module(f"urdfkit.mesh.parts.{self.maker.partition('.')[0]}")
        mesh: Mesh = getattr(module, self.key)(size or self.size)
        if self.kind == "mecanum wheel" and is_left_handed(names):
            from urdfkit.mesh.transforms import scaled

            return scaled(mesh, (1.0, -1.0, 1.0))
        return mesh


#: In the order in which they are asked for.
PARTS = (
    RealPart("Hokuyo UTM-30LX", "lidars.hokuyo_utm30lx", (0.060, 0.060, 0.087),
             "utm utm30 utm30lx ust ust10 ust10lx ust20lx", "2D lidar", "hokuyo"),
    RealPart("Hokuyo URG-04LX", "lidars.hokuyo_urg04lx", (0.050, 0.050, 0.070),
             "urg urg04 urg04lx", "2D lidar", "hokuyo"),
    RealPart("Slamtec RPLIDAR A2", "lidars.rplidar_a2", (0.076, 0.076, 0.041),
             "rplidar rpl slamtec", "2D lidar"),
    RealPart("Velodyne VLP-16", "lidars.velodyne_vlp16", (0.1033, 0.1033, 0.0717),
             "velodyne vlp vlp16", "3D lidar"),
    RealPart("mecanum wheel", "wheels.mecanum_wheel", (0.100, 0.100, 0.050),
             "mecanum mecanumwheel", "mecanum wheel"),
    RealPart("swivel caster", "wheels.caster", (0.068, 0.036, 0.070),
             "caster castor casters", "caster"),
    RealPart("Stereolabs ZED", "cameras.stereo_camera", (0.033, 0.175, 0.030),
             "zed zed2", "stereo camera"),
    RealPart("Stereolabs ZED Mini", "cameras.zed_mini", (0.0305, 0.1245, 0.0265),
             "zedm zedmini", "stereo camera"),
    RealPart("Intel RealSense D435", "cameras.realsense_d435", (0.025, 0.090, 0.025),
             "d435 d435i r200", "depth camera"),
    RealPart("Intel RealSense D415", "cameras.realsense_d415", (0.020, 0.099, 0.023),
             "d415", "depth camera"),
    RealPart("Intel RealSense D455", "cameras.realsense_d455", (0.026, 0.124, 0.029),
             "d455 d456", "depth camera"),
    RealPart("industrial camera", "cameras.camera", (0.055, 0.029, 0.029),
             "blackfly flea basler", "camera"),
    RealPart("Xsens MTi", "imus.xsens_mti", (0.057, 0.042, 0.0235),
             "xsens mti", "IMU"),
    RealPart("wheel with a tyre", "wheels.wheel", (0.130, 0.130, 0.060),
             "wheel tire tyre rim wheels drivewheel rueda roue rad", "wheel"),
)  # fmt: skip


#: What holds or hides a part is another thing.
_HOLDERS = frozenset(
    "adapter beam bracket cable cage cap cover guard holder mast mount mounting plate pole post "
    "rail riser shield stand support tower".split()
)


class Choice(NamedTuple):
    """A part that was chosen, and why.

    Attributes:
        part: that was chosen.
        reason: such as ``'hokuyo' in the name of the file means a 2D lidar``.
    """

    part: RealPart
    reason: str


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
