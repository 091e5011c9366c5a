"""The parts: closed solids of the size asked for, and the words that choose them."""

from functools import cache

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np
import trimesh

from tests.mesh.shapes_made import as_trimesh
from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts import PARTS, RealPart, choose, split_words
from urdfkit.mesh.parts.building import block

MOST_TRIANGLES = 8000
BY_KEY = {part.key: part for part in PARTS}


@cache
def built(key: str) -> Mesh:
    """A part of its true size; several tests look at it."""
    return BY_KEY[key].build()


def assert_clean(mesh: Mesh, size: Vector) -> None:
    volumes = []
    for part in mesh.parts:
        assert part.material is not None
        assert part.normals is not None
        assert np.linalg.norm(part.normals, axis=1) == pytest.approx(1.0)
        solid = as_trimesh(Mesh((part,)))
        assert solid.is_volume, part.material.name
        volumes.append(solid.volume)
    assert len(mesh.faces) < MOST_TRIANGLES
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    assert high - low == pytest.approx(size, rel=2e-3), "fills its room"
    assert (high + low) / 2 == pytest.approx((0, 0, 0), abs=2e-3 * max(size)), "in the middle"
    assert 0.15 * np.prod(size) < sum(volumes) < np.prod(size)


@pytest.mark.parametrize("key", BY_KEY)
def test_every_part_is_made_of_closed_solids(key: str) -> None:
    assert_clean(built(key), BY_KEY[key].size)


@pytest.mark.parametrize("part", PARTS, ids=lambda part: part.key)
def test_every_part_can_be_stretched(part: RealPart) -> None:
    x, y, z = part.size
    for size in ((2 * x, 2 * y, 1.4 * z), (0.7 * x, 0.7 * y, z)):
        assert_clean(part.build(size), size)


@pytest.mark.parametrize("key", BY_KEY)
def test_materials_of_a_part_do_not_overlap(key: str) -> None:
    solids = [as_trimesh(Mesh((one,))) for one in built(key).parts]
    together = trimesh.boolean.union(solids, engine="manifold")
    assert together.volume == pytest.approx(sum(one.volume for one in solids), rel=1e-4)


def test_a_block() -> None:
    assert_clean(block((0.1, 0.2, 0.05)), (0.1, 0.2, 0.05))


@pytest.mark.parametrize("key", [part.key for part in PARTS if part.turns])
def test_a_wheel_is_round_and_seen_along_z(key: str) -> None:
    vertices = built(key).vertices
    reach = np.hypot(vertices[:, 0], vertices[:, 1]).max()
    assert reach == pytest.approx(BY_KEY[key].size[0] / 2, rel=2e-3)


@pytest.mark.parametrize(
    ("file", "link", "size", "module"),
    [
        ("hokuyo", "laser_frame", (0.05, 0.05, 0.05), "hokuyo_urg04lx"),
        ("hokuyo", "laser_frame", (0.06, 0.06, 0.087), "hokuyo_utm30lx"),
        ("hokuyo_utm30", "laser", (0.05, 0.05, 0.07), "hokuyo_utm30lx"),
        ("lds", "base_scan", (0.07, 0.07, 0.04), "rplidar_a2"),
        ("VLP16_base_1", "velodyne", None, "velodyne_vlp16"),
        ("part_7", "front_left_wheel_link", None, "wheel"),
        ("mecanum_wheel_left", "wheel_1", None, "mecanum_wheel"),
        ("caster_wheel", "rear", None, "caster"),
        ("d435", "camera_link", None, "realsense_d435"),
        ("realsense_d455", "camera_link", None, "realsense_d455"),
        ("d415", "camera_link", None, "realsense_d415"),
        ("realsense", "camera_link", None, "realsense_d435"),
        ("realsense", "camera_link", (0.026, 0.124, 0.029), "realsense_d455"),
        ("zedm", "camera", None, "zed_mini"),
        ("zed2", "camera", None, "stereo_camera"),
        ("depthCamera", "camera_link", None, "realsense_d435"),
        ("stereo_camera", "camera", None, "stereo_camera"),
        ("cam", "x", None, "camera"),
        ("imu", "imu_link", None, "xsens_mti"),
        ("upper_arm", "shoulder_link", None, None),
        ("scammer", "primulate", None, None),
        ("lidar_cage", "lidar", None, None),
        ("mid360", "livox_frame", None, "velodyne_vlp16"),
    ],
)
def test_names_choose_the_part(
    file: str, link: str, size: Vector | None, module: str | None
) -> None:
    choice = choose({"the file": file, "the link": link}, size)
    assert (choice.part.key if choice else None) == module


def test_the_reason_names_the_word() -> None:
    choice = choose({"the file": "hokuyo", "the link": "laser"}, None)
    assert choice is not None
    assert choice.reason == "'hokuyo' in the name of the file means a 2D lidar"
    choice = choose({"the file": "x", "the link": "imu_link"}, None)
    assert choice is not None
    assert choice.reason == "'imu' in the name of the link means an IMU"


def test_words_of_a_name() -> None:
    assert split_words("frontLeftWheel_2.dae") == {"front", "left", "wheel", "2", "dae"}
    assert {"vlp16", "vlp"} <= split_words("VLP16")


@pytest.mark.parametrize(
    ("name", "along"),
    [
        ("front_left_wheel", 1),
        ("wheel_rr", 1),
        ("back_right_wheel", 1),
        ("front_right_wheel", -1),
        ("rear_left", -1),
        ("wheel_fr", -1),
        ("wheel", -1),
    ],
)
def test_upper_rollers_of_mecanum_wheels_make_an_x(name: str, along: int) -> None:
    mesh = BY_KEY["mecanum_wheel"].build(names=[name])
    rubber = next(one for one in mesh.parts if one.material and one.material.name == "rubber")
    # The axle of a wheel is the y axis of the robot, its x axis that of the robot.
    x, z, y = rubber.vertices.T * [[1], [-1], [1]]
    top = np.column_stack([x, y])[z > 0.92 * z.max()]
    x, y = top[np.abs(top[:, 0]) < 0.02].T
    assert np.sign(np.corrcoef(x, y)[0, 1]) == along
    assert as_trimesh(mesh._replace(parts=(rubber,))).volume > 0
