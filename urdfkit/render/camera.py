"""The camera of an image. World coordinates in m, z upwards; +x is a robot's front."""

from math import cos, isfinite, radians, sin, tan
from typing import NamedTuple, TypedDict

import numpy as np

from urdfkit.core.spatial import vector
from urdfkit.errors import UrdfkitError
from urdfkit.render.arrays import Floats, Integers, bounds, rotated

#: Azimuth (from +x towards +y) and elevation of the named views, in degrees.
VIEWS = {
    "iso": (38.0, 22.0),
    "front": (0.0, 0.0),
    "back": (180.0, 0.0),
    "left": (90.0, 0.0),
    "right": (-90.0, 0.0),
    "top": (0.0, 90.0),
    "bottom": (0.0, -90.0),
}
#: Vertical field of view in degrees: a long lens with little distortion.
FOV = 28.0
#: Empty part of the image on each side.
MARGIN = 0.09
#: Space in m around a point-like robot, whose frames and joints are drawn as for 1 m.
_ROOM = np.eye(3, dtype=np.float32) / 2

#: Least edge of an image in pixels, and most pixels: a sheet of paper at 600 dpi.
MIN_EDGE, MAX_PIXELS = 16, 40_000_000


class NoSuchView(UrdfkitError):
    """An unknown view, or numbers that define none."""


class Camera(NamedTuple):
    """A perspective or orthographic camera."""

    eye: tuple[float, float, float]  # position
    #: Rows are the directions right, up and backwards, in the world.
    axes: tuple[tuple[float, ...], ...]
    size: tuple[int, int]  # width and height of the image in pixels
    field: float = FOV  # vertical field of view in degrees
    extent: float = 0.0  # height in m of an orthographic image; 0 for perspective
    near: float = 0.01  # distance of the near plane in m

    @property
    def is_orthographic(self) -> bool:
        return self.extent > 0

    @property
    def scale(self) -> float:
        """Pixels per m (orthographic), or per m at a depth of 1 m (perspective)."""
        height = self.size[1]
        return height / self.extent if self.extent else height / 2 / tan(radians(self.field) / 2)

    def to_view(self, rotation: Floats, position: Floats) -> tuple[Floats, Floats]:
        """Transform a frame from the world to the camera, as rotation and position.

        In the camera frame, x points right, y up and z towards the viewer.
        """
        axes = np.asarray(self.axes)
        return (
            (axes @ rotation).astype(np.float32),
            (axes @ (position - np.asarray(self.eye))).astype(np.float32),
        )

    def project(self, points: Floats) -> tuple[Floats, Floats, Floats]:
        """Project points (n, 3) from the camera frame to the image.

        Returns:
            x and y in pixels from the upper left corner, and the nearness: positive, larger for
            nearer points, and linear in the image on any plane.
        """
        width, height = self.size
        x, y, z = points.T
        if self.is_orthographic:
            factor = np.float32(self.scale)
            nearness = z + np.float32(_far(self))
        else:
            nearness = 1 / -z
            factor = np.float32(self.scale) * nearness
        return x * factor + np.float32(width / 2), np.float32(height / 2) - y * factor, nearness

    def positions(self, x: Floats, y: Floats, nearness: Floats) -> Floats:
        """Points (n, 3) in the camera frame, from the results of `project`."""
        depth = np.float32(_far(self)) - nearness if self.is_orthographic else 1 / nearness
        half = np.float32(0.5)
        return np.stack(self.places(x - half, y - half, depth), axis=1)

    def places(
        self, column: Integers | Floats, row: Integers | Floats, depth: Floats
    ) -> tuple[Floats, Floats, Floats]:
        """x, y and z in the camera frame of pixel centres at given depths."""
        width, height = self.size
        factor = np.float32(1 / self.scale)
        if not self.is_orthographic:
            factor = depth * factor
        across = column.astype(np.float32)
        across -= np.float32(width / 2 - 0.5)
        down = row.astype(np.float32)
        down -= np.float32(height / 2 - 0.5)
        return across * factor, -down * factor, -depth


class CameraOptions(TypedDict, total=False):
    """Keyword arguments of `place_camera`, except the size."""

    azimuth: float | None
    elevation: float | None
    distance: float | None
    orthographic: bool


def _far(camera: Camera) -> float:
    """The depth of nearness 0 in an orthographic image, behind all points."""
    return camera.near * 800


def place_camera(
    points: Floats,
    view: str = "iso",
    *,
    azimuth: float | None = None,
    elevation: float | None = None,
    distance: float | None = None,
    size: tuple[int, int] = (1280, 720),
    orthographic: bool = False,
) -> Camera:
    """A camera whose image contains all points.

    Args:
        points: (n, 3), in the world.
        view: a name of `VIEWS`.
        azimuth: in degrees from +x towards +y, instead of the view's.
        elevation: in degrees above the horizon, instead of the view's.
        distance: from the middle of the points, in m; None for the nearest that shows all points.
        size: of the image, in pixels.
        orthographic: without perspective.

    Raises:
        NoSuchView: the view is unknown, or a number is out of bounds.
    """
    if distance is not None and not 0 < distance < 1e6:
        raise NoSuchView(f"a distance of {distance:g} m: write one above 0")
    if reason := size_error(size):
        raise NoSuchView(reason)
    axes = _axes(view, azimuth, elevation)
    projected = rotated(points, axes) if len(points) else np.zeros((1, 3), dtype=np.float32)
    if not np.ptp(projected, axis=0).any():  # all points coincide
        projected = projected[:1] + np.concatenate((_ROOM, -_ROOM))
    lowest, highest = (end.astype(np.float64) for end in bounds(projected))
    reach = max(float(np.linalg.norm(highest - lowest)) / 2, 1e-3)
    middle = (lowest + highest) / 2
    aspect = size[0] / size[1]
    if orthographic:
        wide, high, _ = highest - lowest
        extent = max(high, wide / aspect, reach / 50) / (1 - 2 * MARGIN)
        eye = middle + np.array((0, 0, 3 * reach))
        return Camera(vector(axes.T @ eye), _rows(axes), size, FOV, float(extent), reach / 100)
    eye = _eye(projected, tan(radians(FOV) / 2) * (1 - 2 * MARGIN), aspect)
    if distance is not None:
        eye = np.array((middle[0], middle[1], middle[2] + distance))
    near = max(reach / 1000, (eye[2] - highest[2]) / 2)
    return Camera(vector(axes.T @ eye), _rows(axes), size, FOV, 0.0, float(near))


def size_error(size: tuple[int, int]) -> str:
    """The reason why an image size in pixels is invalid; empty if it is valid."""
    width, height = size
    if min(size) >= MIN_EDGE and width * height <= MAX_PIXELS:
        return ""
    most = MAX_PIXELS // 1_000_000
    return f"an image of {width}x{height} pixels: use a size from 16x16 to {most} million pixels"


def _axes(view: str, azimuth: float | None, elevation: float | None) -> Floats:
    """The directions right, up and backwards of a camera at an angle."""
    if view not in VIEWS:
        raise NoSuchView(f"unknown view '{view}'; expected one of {', '.join(VIEWS)}")
    if not all(isfinite(angle or 0.0) for angle in (azimuth, elevation)):
        raise NoSuchView("invalid angle: use degrees")
    default = VIEWS[view]
    a = radians(default[0] if azimuth is None else azimuth)
    e = radians(default[1] if elevation is None else elevation)
    backwards = (cos(e) * cos(a), cos(e) * sin(a), sin(e))
    right = (-sin(a), cos(a), 0.0)
    return np.array((right, np.cross(backwards, right), backwards))


def _eye(seen: Floats, slope: float, aspect: float) -> Floats:
    """The nearest position from which points (n, 3) fit into a frustum.

    Each pair of planes, left and right or upper and lower, defines the least depth and the offset
    at which both touch a point.

    Args:
        aspect: width by height.
    """
    x, y, z = seen.T
    eye, depths = np.zeros(3), []
    for axis, along, tangent in ((0, x, slope * aspect), (1, y, slope)):
        first, second = np.max(z + along / tangent), np.max(z - along / tangent)
        eye[axis] = tangent * (first - second) / 2
        depths.append((first + second) / 2)
    eye[2] = max(*depths, float(np.max(z)) + 1e-3)
    return eye


def _rows(axes: Floats) -> tuple[tuple[float, ...], ...]:
    return tuple(tuple(float(part) for part in row) for row in axes)
