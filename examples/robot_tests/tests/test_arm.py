"""What the arm must be, on both sides."""

import pytest

from urdfkit.testing import assert_dof, assert_limits_within, assert_mass, assert_no_findings

ARM = pytest.mark.urdf("../urdf/arm.urdf.xacro", args={"side": ["left", "right"]})


@ARM
def test_it_has_no_findings(urdf_report):
    assert_no_findings(urdf_report)


@ARM
def test_it_is_the_arm_that_was_ordered(robot_model):
    assert_dof(robot_model, 2)
    assert_mass(robot_model, 2.0)
    assert_limits_within(robot_model, {"*_elbow": (0, 2.6)})
    assert_limits_within(robot_model, {"*": (0, 50)}, of="effort")


def test_the_sides_mirror_each_other(urdf):
    left = urdf("../urdf/arm.urdf.xacro", side="left").model
    right = urdf("../urdf/arm.urdf.xacro", side="right").model
    at_left = left.joints_by_name["left_shoulder"].origin.position
    at_right = right.joints_by_name["right_shoulder"].origin.position
    assert at_left == (at_right[0], -at_right[1], at_right[2])


def test_a_forgotten_property_is_reported_at_its_line(urdf, tmp_path):
    broken = tmp_path / "broken.urdf.xacro"
    broken.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
        '  <link name="${name}"/>\n'
        "</robot>\n"
    )
    (finding,) = urdf(str(broken)).report.diagnostics
    assert (finding.code, finding.span.line, finding.span.column) == ("XAC001", 2, 15)
