"""Depth, stereo and industrial cameras, which look along x, by their outer edges in m.

What lies within the published outlines is drawn by eye.
"""

from __future__ import annotations

from typing import NamedTuple

from manifold3d import Manifold

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh, MeshMaterial
from urdfkit.mesh.parts.palette import ALUMINIUM, BLACK, DARK, GLASS, GREY
from urdfkit.mesh.solids import assembled, box, cylinder, disjoint, revolved, rounded_box


class _Lens(NamedTuple):
    """A lens in the face of a bar.

    Attributes: left: from the middle, as a part of the width of the bar. radius: as a part of its
    height.
    """

    left: float
    radius: float


def realsense_d415(size: Vector) -> Mesh:
    """A depth camera in the outline of the Intel RealSense D415.

    99 x 20 x 23 mm, two imagers 55 mm apart and the colour camera next to the left one. Source:
    Intel's realsense2_description (urdf/_d415.urdf.xacro), which has the size and the places of the
    lenses, 20 mm, -35 mm and 35 mm left of the middle. Data sheet 337029 was not at hand; the place
    of the projector is estimated.
    """
    lenses = (_Lens(20 / 99, 0.15), _Lens(-35 / 99, 0.15), _Lens(-0.08, 0.12), _Lens(35 / 99, 0.15))
    return _bar(size, lenses, ALUMINIUM)


def realsense_d435(size: Vector) -> Mesh:
    """A depth camera in the outline of the Intel RealSense D435.

    90 x 25 x 25 mm, two imagers 50 mm apart with the projector between them and the colour camera
    at the side. Source: Intel's realsense2_description (urdf/_d435.urdf.xacro), which has the size
    and the places of the lenses, 17.5 mm, -32.5 mm and 32.5 mm left of the middle. Data sheet
    337029 was not at hand; the place of the projector is estimated.
    """
    lenses = (_Lens(0.194, 0.17), _Lens(-0.361, 0.17), _Lens(-0.05, 0.12), _Lens(0.361, 0.17))
    return _bar(size, lenses, ALUMINIUM)


def realsense_d455(size: Vector) -> Mesh:
    """A depth camera in the outline of the Intel RealSense D455.

    124 x 26 x 29 mm, two imagers 95 mm apart, the colour camera and the projector between them.
    Source: Intel's realsense2_description (urdf/_d455.urdf.xacro), which has the size and the
    places of the lenses, 47.5 mm, -47.5 mm and -11.5 mm left of the middle. Data sheet 337029 was
    not at hand; the place of the projector is estimated.
    """
    places = (47.5 / 124, -47.5 / 124, -11.5 / 124)
    return _bar(size, (*(_Lens(left, 0.15) for left in places), _Lens(0.1, 0.11)), ALUMINIUM)


def stereo_camera(size: Vector) -> Mesh:
    """A stereo camera in the outline of the Stereolabs ZED.

    175 x 30 x 33 mm with two lenses 120 mm apart. Sources: the baseline from Stereolabs,
    https://support.stereolabs.com/hc/en-us/articles/360007395634, and with the height from their
    zed_wrapper (urdf/zed_macro.urdf.xacro); their mesh of it (zed_ros2_description, meshes/zed.stl)
    takes up 174.8 x 29.9 x 31.8 mm. The size is the one commonly quoted from the data sheet, which
    was not at hand.
    """
    return _bar(size, (_Lens(60 / 175, 0.27), _Lens(-60 / 175, 0.27)), DARK)


def zed_mini(size: Vector) -> Mesh:
    """A stereo camera in the outline of the Stereolabs ZED Mini.

    124.5 x 30.5 x 26.5 mm with two lenses 63 mm apart. Sources as for the ZED; their mesh of it
    (meshes/zedm.stl) takes up 125.2 x 29.5 x 26.6 mm.
    """
    return _bar(size, (_Lens(31.5 / 124.5, 0.27), _Lens(-31.5 / 124.5, 0.27)), DARK)


def camera(size: Vector) -> Mesh:
    """An industrial camera with a C-mount lens.

    A cube of 29 mm with a lens of 26 mm before it. Sources: the 29 x 29 mm housing is the common
    size of small machine vision cameras (FLIR Blackfly S, Basler ace), and that of Clearpath's mesh
    of the former (clearpath_sensors_description, meshes/flir_blackfly.stl); the C-mount's thread is
    1 inch wide and its flange 17.526 mm before the image.
    """
    x, y, z = size
    side = min(y, z)
    # Built upright, with the lens along z, and laid down in the end.
    front, seat = x / 2, -x / 2 + 0.53 * x
    radius = 0.43 * side
    barrel = revolved(
        [
            (0, seat),
            (0.40 * side, seat),
            (0.40 * side, seat + 0.06 * x),
            (radius, seat + 0.07 * x),
            (radius, seat + 0.17 * x),
            (0.39 * side, seat + 0.18 * x),
            (0.39 * side, seat + 0.26 * x),
            (radius, seat + 0.27 * x),
            (radius, front),
            (0.33 * side, front),
            (0.24 * side, front - 0.07 * x),
            (0, front - 0.07 * x),
        ]
    )
    glass = revolved(
        [
            (0, front - 0.07 * x),
            (0.24 * side, front - 0.07 * x),
            (0.16 * side, front - 0.045 * x),
            (0, front - 0.035 * x),
        ],
    )
    length = seat + x / 2
    housing = rounded_box((z, y, 0.94 * length), (0, 0, seat - 0.47 * length), 0.05 * side)
    back = rounded_box(
        (0.9 * z, 0.9 * y, 0.06 * length), (0, 0, -x / 2 + 0.03 * length), 0.05 * side
    )
    plug = box((0.22 * z, 0.5 * y, 0.04 * length), (0, 0, -x / 2 + 0.02 * length))
    return _laid([(DARK, plug), (GREY, housing), (DARK, back), (GLASS, glass), (BLACK, barrel)])


def _bar(size: Vector, lenses: tuple[_Lens, ...], body: MeshMaterial) -> Mesh:
    """A bar along y with round ends and lenses in its black face."""
    x, y, z = size
    # Built with the face upwards: x of the bar becomes z here.
    end = 0.49 * min(y, z)
    shell = rounded_box((z, y, 0.92 * x), (0, 0, -0.04 * x), end, 0.06 * x)
    front = rounded_box((0.86 * z, y - 0.14 * z, 0.10 * x), (0, 0, 0.43 * x), 0.86 * end, 0.01 * x)
    upright: list[tuple[MeshMaterial, Manifold]] = []
    for lens in lenses:
        place = (0.0, lens.left * y)
        glass = cylinder(lens.radius * z, 0.38 * x, 0.47 * x, place, 32)
        rim = cylinder(1.25 * lens.radius * z, 0.38 * x, 0.50 * x, place, 32)
        hole = cylinder(lens.radius * z, 0.30 * x, 0.60 * x, place, 32)
        upright += [(GLASS, glass), (body, rim - hole)]
    return _laid([*upright, (BLACK, front), (body, shell)])


def _laid(solids: list[tuple[MeshMaterial, Manifold]]) -> Mesh:
    """Solids that look along z, laid down so that they look along x."""
    return assembled([(material, solid.rotate((0, 90, 0))) for material, solid in disjoint(solids)])
