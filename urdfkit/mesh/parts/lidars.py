"""2D and 3D lidars, their middle at the origin, by their outer edges in m along x, y, z.

What lies within the published outlines is drawn by eye, without connectors.
"""

from __future__ import annotations

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.palette import ALUMINIUM, BLACK, DARK, GLASS, GREEN, GREY, WINDOW
from urdfkit.mesh.solids import assembled, box, cylinder, revolved, rounded_box


def hokuyo_utm30lx(size: Vector) -> Mesh:
    """A 2D lidar in the outline of the Hokuyo UTM-30LX.

    60 x 60 x 87 mm, black housing, the scan plane in a dark window below the cap. The specification
    by Hokuyo (C-42-3615) was not at hand; the size is the one commonly quoted from it. Clearpath's
    mesh (clearpath_sensors_description, meshes/hokuyo_utm30.stl) takes up the same, and 20 mm more
    behind for the cable outlet, which is left out here.
    """
    x, y, z = size
    side, low = min(x, y), -z / 2
    # Between the base and the cap the laser looks out through a window of a slightly conical shape.
    waist, neck = low + 0.52 * z, low + 0.56 * z
    top = low + 0.86 * z
    window = revolved([(0, neck), (0.375 * side, neck), (0.345 * side, top), (0, top)])
    cap = revolved(
        [
            (0, top),
            (0.40 * side, top),
            (0.42 * side, top + 0.02 * z),
            (0.42 * side, low + 0.94 * z),
            (0.36 * side, low + z),
            (0, low + z),
        ]
    )
    collar = cylinder(0.44 * side, waist, neck)
    foot = rounded_box((x, y, 0.06 * z), (0, 0, low + 0.03 * z), 0.06 * side)
    body = rounded_box(
        (0.96 * x, 0.96 * y, waist - low - 0.06 * z),
        (0, 0, (low + 0.06 * z + waist) / 2),
        0.10 * side,
    )
    # Behind, the housing goes up to the cap: the blind sector of 90 degrees.
    spine = box((0.16 * x, 0.34 * y, top - neck), (-0.32 * x, 0, (top + neck) / 2))
    lamp = box((0.02 * x, 0.10 * y, 0.025 * z), (0.475 * x, 0.12 * y, low + 0.44 * z))
    black = body + collar + spine
    return assembled([(GREEN, lamp), (DARK, foot + cap), (BLACK, black), (WINDOW, window)])


def hokuyo_urg04lx(size: Vector) -> Mesh:
    """A 2D lidar in the outline of the Hokuyo URG-04LX.

    50 x 50 x 70 mm: a cube with a drum on it, in which the window runs around. Source: Hokuyo,
    https://www.hokuyo-aut.jp/dl/Specifications_URG-04LX_1513063395.pdf, as models quote it that
    were made from it; the sheet itself was not at hand. The UST-10LX, its successor, is as large:
    Clearpath's mesh of that (hokuyo_ust10.stl) takes up 50 x 70 mm, and 14 mm more behind for the
    cables.
    """
    x, y, z = size
    side, low = min(x, y), -z / 2
    base, sill, lintel = low + 0.57 * z, low + 0.62 * z, low + 0.84 * z
    plate = rounded_box((x, y, 0.05 * z), (0, 0, low + 0.025 * z), 0.05 * side)
    housing = rounded_box(
        (0.97 * x, 0.97 * y, base - low - 0.05 * z),
        (0, 0, (low + 0.05 * z + base) / 2),
        0.08 * side,
    )
    cap = revolved(
        [
            (0, lintel),
            (0.43 * side, lintel),
            (0.43 * side, low + 0.95 * z),
            (0.38 * side, low + z),
            (0, low + z),
        ]
    )
    label = box((0.02 * x, 0.5 * y, 0.16 * z), (0.48 * x, 0, low + 0.30 * z))
    back = box((0.14 * x, 0.40 * y, lintel - sill), (-0.34 * x, 0, (lintel + sill) / 2))
    window = cylinder(0.40 * side, sill, lintel)
    black = housing + cylinder(0.45 * side, base, sill)
    return assembled(
        [(GREY, plate + label), (BLACK, black), (BLACK, back), (DARK, cap), (WINDOW, window)]
    )


def rplidar_a2(size: Vector) -> Mesh:
    """A 2D lidar in the outline of the Slamtec RPLIDAR A2.

    76 mm wide and 41 mm high: a flat base and a head that turns on it, with two windows in front.
    Slamtec's "RPLIDAR A2 Introduction and Datasheet" (A2M8, rev. 2.5) has a drawing of it, and was
    not at hand; the size is the one commonly quoted. Ekumen's mesh of it (andino_description,
    meshes/sensors/rplidar-a2.stl) takes up 75 x 40.8 mm, and 4 mm more for its socket.
    """
    x, y, z = size
    radius, low = min(x, y) / 2, -z / 2
    seam = low + 0.45 * z
    base = revolved(
        [
            (0, low),
            (0.93 * radius, low),
            (radius, low + 0.08 * z),
            (radius, seam - 0.02 * z),
            (0, seam - 0.02 * z),
        ]
    )
    gap = revolved(
        [(0, seam - 0.02 * z), (0.90 * radius, seam - 0.02 * z), (0.90 * radius, seam), (0, seam)]
    )
    head = revolved(
        [
            (0, seam),
            (radius, seam),
            (radius, low + 0.90 * z),
            (0.92 * radius, low + z),
            (0, low + z),
        ]
    )
    middle = low + 0.72 * z
    window = box((0.5 * radius, 0.42 * radius, 0.30 * z), (0.85 * radius, 0, middle))
    windows = [window.translate((0, side * radius, 0)) ^ head for side in (0.38, -0.30)]
    glass = [(GLASS, window) for window in windows]
    return assembled([*glass, (BLACK, head), (GREY, gap), (DARK, base)])


def velodyne_vlp16(size: Vector) -> Mesh:
    """A spinning 3D lidar in the outline of the Velodyne VLP-16.

    103.3 mm wide and 71.7 mm high: an aluminium base, a dark window all around, an aluminium cap.
    Velodyne's "VLP-16 User Manual" (63-9243 Rev. D) has the drawings, and was not at hand. The
    numbers are those of velodyne_description (VLP-16.urdf.xacro) and of Clearpath's description of
    it (clearpath_sensors_description, urdf/velodyne_lidar.urdf.xacro): a radius of 51.6 mm, 71.7 mm
    high, the optical centre 37.7 mm above the base.
    """
    x, y, z = size
    radius, low = min(x, y) / 2, -z / 2
    sill, lintel = low + 0.31 * z, low + 0.79 * z
    base = revolved(
        [
            (0, low),
            (0.95 * radius, low),
            (radius, low + 0.03 * z),
            (radius, low + 0.10 * z),
            (0.97 * radius, low + 0.10 * z),
            (0.97 * radius, low + 0.12 * z),
            (radius, low + 0.12 * z),
            (radius, sill - 0.03 * z),
            (0.97 * radius, sill),
            (0, sill),
        ]
    )
    cap = revolved(
        [
            (0, lintel),
            (0.97 * radius, lintel),
            (0.97 * radius, low + 0.95 * z),
            (0.90 * radius, low + z),
            (0, low + z),
        ]
    )
    window = cylinder(0.945 * radius, sill, lintel)
    return assembled([(ALUMINIUM, base), (GREY, cap), (WINDOW, window)])
