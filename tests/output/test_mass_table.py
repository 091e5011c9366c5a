"""Mass properties beside those of the shapes, by closed forms and on real robots."""

from math import pi

import pytest

from tests.conftest import ARM, CORPUS, MISSION, needs_corpus
from tests.massive import BALL, inertial, joint, link, part, shape
from tests.output.test_overview import of
from urdfkit.lint.loading import read
from urdfkit.output.mass_table import mass_properties


def test_a_box_as_declared_and_as_its_shape() -> None:
    (row,) = mass_properties(
        of(part("box", 6, (0.05, 0.025, 0.065), '<box size="0.2 0.3 0.1"/>'))
    ).rows
    assert row.properties.mass == 6
    assert row.moments == pytest.approx((0.025, 0.05, 0.065))
    assert row.density == pytest.approx(1000)
    assert row.shape_mass is not None
    assert row.shape_mass.source == "the collision"
    assert row.of_shapes is not None
    moments, axes = row.of_shapes
    assert moments == pytest.approx((0.025, 0.05, 0.065), rel=1e-12)
    assert axes == ((0, 1, 0), (1, 0, 0), (0, 0, -1))


def test_a_turned_inertial_has_turned_axes() -> None:
    turned = inertial(1, (1, 2, 2.5), rpy=f"0 0 {pi / 2}")
    (row,) = mass_properties(of(link("a", turned))).rows
    columns = list(zip(*row.axes, strict=True))
    assert [abs(part) for part in columns[0]] == pytest.approx([0, 1, 0], abs=1e-12)
    assert row.density is None
    assert row.reason == "no shape"


def test_links_without_mass_or_shape_are_no_rows() -> None:
    found = mass_properties(of(link("a") + link("b", shape("visual", BALL))))
    assert [row.link for row in found.rows] == ["b"]
    assert found.rows[0].density == 0


def test_the_mission_s_model() -> None:
    found = mass_properties(read(MISSION))
    assert found.whole.mass == pytest.approx(10.2301)
    assert found.whole.root == "dummy"
    rows = {row.link: row for row in found.rows}
    assert len(rows) == 9
    wheel = rows["wheel_1"]
    assert wheel.density == pytest.approx(0.5 / (pi * 0.06**2 * 0.05))
    assert wheel.of_shapes is not None
    assert wheel.of_shapes[0][2] == pytest.approx(0.5 * 0.06**2 / 2)
    assert wheel.moments == (0.1, 0.1, 0.1)


def test_a_pose_moves_the_whole_and_no_link() -> None:
    arm = read(ARM)
    zero, moved = mass_properties(arm), mass_properties(arm, {"shoulder": 1.0})
    assert zero.rows == moved.rows
    assert zero.whole.mass == moved.whole.mass
    assert zero.whole.properties != moved.whole.properties


def test_a_loop_has_a_mass_and_no_centre() -> None:
    ball = inertial(2, (0.1, 0.1, 0.1))
    found = mass_properties(of(link("a", ball) + joint("a", "b") + joint("b", "a") + link("b")))
    assert (found.whole.mass, found.whole.properties, found.axes) == (2, None, None)


@needs_corpus
def test_meshes_of_a_real_arm_have_the_density_of_an_arm() -> None:
    pytest.importorskip("numpy")
    file = CORPUS / "Universal_Robots_ROS2_Description" / "urdf" / "ur.urdf.xacro"
    found = mass_properties(read(file, arguments={"name": "ur", "ur_type": "ur5e"}))
    rows = {row.link: row for row in found.rows}
    forearm = rows["forearm_link"]
    assert forearm.shape_mass is not None
    assert forearm.density is not None
    assert 300 < forearm.density < 3000
