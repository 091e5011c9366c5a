"""Real parts of robots, to stand in for meshes that are missing.

One module for each, which says where its sizes come from: what its maker publishes, and who else
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


class RealPart(NamedTuple):
    """A part that can be made.

    Attributes:
        name: as a person calls it.
        module: in this package; ``build(size)`` makes it.
        size: its true outer edges in m, along x, y, z.
        words: in the name of a file or link, that mean this very part.
        kind: of part; of several of a kind the one nearest in size is taken.
        kind_words: that mean this kind.
    """

    name: str
    module: str
    size: Vector
    words: tuple[str, ...]
    kind: str
    kind_words: tuple[str, ...]

    @property
    def turns(self) -> bool:
        """True for a part whose z axis is to be laid along the axis that it turns about."""
        return self.kind in ("wheel", "mecanum wheel")

    def suggested_by(self, exactly: bool) -> set[str]:
        """The words that mean this very part, or else its kind."""
        return set(self.words if exactly else self.kind_words)

    def build(self, size: Vector | None = None, names: Iterable[str] = ()) -> Mesh:
        """Its triangles.

        Args:
            size: outer edges in m, along its own axes; those of the real part if not given.
            names: that tell on which corner of a robot a mecanum wheel is.
        """
        mesh: Mesh = import_module(f"urdfkit.mesh.parts.{self.module}").build(size or self.size)
        if self.kind == "mecanum wheel" and is_left_handed(names):
            from urdfkit.mesh.transforms import scaled

            return scaled(mesh, (1.0, -1.0, 1.0))
        return mesh


_LIDAR_2D = ("laser", "lidar", "ladar", "scan", "scanner", "lds", "ydlidar", "lms", "lms1xx", "tim")
_LIDAR_3D = (
    "velodyne",
    "vlp",
    "hdl",
    "ouster",
    "os0",
    "os1",
    "os2",
    "pandar",
    "hesai",
    "livox",
    "mid360",
    "lidar3d",
)
_CAMERA = ("camera", "cam", "webcam", "rgb", "usbcam", "pointgrey", "mono")
_DEPTH = ("realsense", "depth", "rgbd", "kinect", "astra", "xtion", "orbbec", "structure")
_STEREO = ("stereo", "multisense", "bumblebee")
_IMU = ("imu", "ahrs", "gyro", "mpu", "mpu6050", "mpu9250", "bno", "bno055", "bno085")
_WHEEL = ("wheel", "tire", "tyre", "rim", "wheels", "drivewheel", "rueda", "roue", "rad")
_CASTER = ("caster", "castor", "casters")

#: In the order in which they are asked; a mecanum wheel is a wheel, a depth camera a camera.
PARTS = (
    RealPart(
        "Hokuyo UTM-30LX",
        "hokuyo_utm30lx",
        (0.060, 0.060, 0.087),
        ("utm", "utm30", "utm30lx", "ust", "ust10", "ust10lx", "ust20lx"),
        "2D lidar",
        ("hokuyo", *_LIDAR_2D),
    ),
    RealPart(
        "Hokuyo URG-04LX",
        "hokuyo_urg04lx",
        (0.050, 0.050, 0.070),
        ("urg", "urg04", "urg04lx"),
        "2D lidar",
        ("hokuyo", *_LIDAR_2D),
    ),
    RealPart(
        "Slamtec RPLIDAR A2",
        "rplidar_a2",
        (0.076, 0.076, 0.041),
        ("rplidar", "rpl", "slamtec"),
        "2D lidar",
        _LIDAR_2D,
    ),
    RealPart(
        "Velodyne VLP-16",
        "velodyne_vlp16",
        (0.1033, 0.1033, 0.0717),
        ("velodyne", "vlp", "vlp16"),
        "3D lidar",
        _LIDAR_3D,
    ),
    RealPart(
        "mecanum wheel",
        "mecanum_wheel",
        (0.100, 0.100, 0.050),
        ("mecanum", "mecanumwheel"),
        "mecanum wheel",
        ("mecanum", "omni", "omniwheel", "swedish"),
    ),
    RealPart(
        "swivel caster",
        "caster",
        (0.068, 0.036, 0.070),
        _CASTER,
        "caster",
        _CASTER,
    ),
    RealPart(
        "Stereolabs ZED",
        "stereo_camera",
        (0.033, 0.175, 0.030),
        ("zed", "zed2"),
        "stereo camera",
        _STEREO,
    ),
    RealPart(
        "Stereolabs ZED Mini",
        "zed_mini",
        (0.0305, 0.1245, 0.0265),
        ("zedm", "zedmini"),
        "stereo camera",
        _STEREO,
    ),
    RealPart(
        "Intel RealSense D435",
        "realsense_d435",
        (0.025, 0.090, 0.025),
        ("d435", "d435i", "r200"),
        "depth camera",
        _DEPTH,
    ),
    RealPart(
        "Intel RealSense D415",
        "realsense_d415",
        (0.020, 0.099, 0.023),
        ("d415",),
        "depth camera",
        _DEPTH,
    ),
    RealPart(
        "Intel RealSense D455",
        "realsense_d455",
        (0.026, 0.124, 0.029),
        ("d455", "d456"),
        "depth camera",
        _DEPTH,
    ),
    RealPart(
        "industrial camera",
        "camera",
        (0.055, 0.029, 0.029),
        ("blackfly", "flea", "basler"),
        "camera",
        _CAMERA,
    ),
    RealPart(
        "Xsens MTi",
        "xsens_mti",
        (0.057, 0.042, 0.0235),
        ("xsens", "mti"),
        "IMU",
        _IMU,
    ),
    RealPart(
        "wheel with a tyre",
        "wheel",
        (0.130, 0.130, 0.060),
        _WHEEL,
        "wheel",
        _WHEEL,
    ),
)


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
            fitting = [part for part in PARTS if words & part.suggested_by(exactly)]
            if not fitting:
                continue
            kind = fitting[0].kind
            alike = [part for part in fitting if part.kind == kind]
            part = min(alike, key=lambda one: _misfit(one, size))
            word = min(words & part.suggested_by(exactly))
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
