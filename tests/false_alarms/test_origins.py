"""Collisions that are not where the visual is."""

import pytest

from tests.massive import link, shape
from tests.reported import fixed, reported

BASE = '<box size="0.4 0.3 {}"/>'


@pytest.mark.parametrize(
    ("height", "half"), [("0.1", "0.05"), ("0.1", "0.0500"), ("0.0865", "0.043"), ("0.31", "0.155")]
)
def test_the_origin_of_half_the_height_in_the_visual_alone(height: str, half: str) -> None:
    box = BASE.format(height)
    robot = link(
        "base",
        shape("visual", box, f"0 0 {half}"),
        "<collision>\n<geometry>\n" + box + "\n</geometry>\n</collision>",
    )
    (found,) = reported("GEO004", robot)
    assert "33%" in found.message or "34%" in found.message
    assert f'xyz="0 0 {half}"' in fixed("GEO004", robot).split("<collision>")[1]


def test_a_shift_that_may_be_meant() -> None:
    box = BASE.format("0.1")
    assert (
        reported("GEO004", link("base", shape("visual", box, "0 0 0.04"), shape("collision", box)))
        == []
    )


@pytest.mark.parametrize(("z", "count"), [(0.001, 0), (0.01, 1)])
def test_sheets_on_one_another(z: float, count: int) -> None:
    """A tray whose visual lies on its collision, of 1 mm."""
    sheet = '<box size="0.2 0.2 0.001"/>'
    robot = link("a", shape("visual", sheet, f"0 0 {z}"), shape("collision", sheet))
    assert len(reported("GEO004", robot)) == count


@pytest.mark.parametrize(
    ("collision", "z", "count"),
    [("0.05", "0", 0), ("0.05", "0.02", 1), ("0.5", "0.4", 1)],
)
def test_a_collision_around_one_of_several_visuals(collision: str, z: str, count: int) -> None:
    """articubot_one: the antenna of a GPS receiver, and the mast below it without a collision."""
    cylinder = '<cylinder radius="{}" length="{}"/>'
    robot = link(
        "gps",
        shape("visual", cylinder.format("0.05", "0.02")),
        shape("visual", cylinder.format("0.01", "0.2"), "0 0 -0.1"),
        shape("collision", cylinder.format(collision, "0.04"), f"0 0 {z}"),
    )
    assert len(reported("GEO004", robot)) == count


@pytest.mark.parametrize(("name", "count"), [("gyro", 0), ("accel", 0), ("fisheye1", 1)])
def test_a_sensor_without_an_image_has_an_optical_frame(name: str, count: int) -> None:
    """mobile_manip_ws's T265: the frames of its gyroscope, whose axes are those of the chip."""
    text = (
        f'<link name="t265_{name}_frame"/><link name="t265_{name}_optical_frame"/>'
        f'<joint name="j" type="fixed"><parent link="t265_{name}_frame"/>'
        f'<child link="t265_{name}_optical_frame"/><origin rpy="1.5708 0 -1.5708"/></joint>'
    )
    assert len(reported("JNT030", text)) == count
