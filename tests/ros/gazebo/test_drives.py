import pytest

from tests.gazebos import BASE, WHEELS, wheel
from tests.naming import naming
from urdfkit.lint.context import Context
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.ros.gazebo.drives import Wheel, wheel_of, wrong_direction
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver


def wheels_of(robot: str, *names: str) -> list[Wheel]:
    context = Context(Source("r.urdf", whole_robot(robot).encode()), Resolver(environment={}))
    joints = context.model.joints_by_name
    found = [wheel_of(joints[f"{name}_joint"], context.tree) for name in names]
    assert None not in found
    return [one for one in found if one]


def test_position_and_axis_of_a_wheel() -> None:
    (left,) = wheels_of(BASE + wheel("left", 0.15, radius=0.07, at=0.02), "left")
    assert left.joint.name == "left_joint"
    assert left.axis == (0.0, 1.0, 0.0)
    assert left.radius == pytest.approx(0.07)
    assert left.origin == (0.0, 0.15, 0.0)
    assert left.hub == left.center == pytest.approx((0.0, 0.17, 0.0))


def test_a_wheel_without_a_shape_is_at_its_joint() -> None:
    text = '<link name="tyre"/><joint name="bare_joint" type="continuous"><parent link="base"/>'
    text += '<child link="tyre"/><origin xyz="0 0.2 0"/><axis xyz="0 0 3"/></joint>'
    (bare,) = wheels_of(BASE + text, "bare")
    assert (bare.hub, bare.radius, bare.center) == (None, None, (0.0, 0.2, 0.0))
    assert bare.axis == (0.0, 0.0, 1.0)


def test_the_axis_points_to_the_left() -> None:
    left, right = wheels_of(WHEELS, "left", "right")
    assert wrong_direction(left, right) is None
    message, remedy = wrong_direction(right, left) or ("", "")
    assert message == naming("left", "right_joint", "0.3 m", "right", "left_joint", "forwards")
    assert remedy == "swap the joints, or invert both axes"


def test_two_inverted_axes_reverse_the_robot() -> None:
    robot = BASE + wheel("left", 0.15, axis="0 -1 0") + wheel("right", -0.15, axis="0 -1 0")
    left, right = wheels_of(robot, "left", "right")
    assert wrong_direction(left, right) is not None
    assert wrong_direction(right, left) is None


def test_opposite_axes() -> None:
    robot = BASE + wheel("left", 0.15) + wheel("right", -0.15, axis="0 -1 0")
    left, right = wheels_of(robot, "left", "right")
    assert left.is_parallel(right)
    message, remedy = wrong_direction(left, right) or ("", "")
    assert message == naming("left_joint", "right_joint")
    assert remedy == naming("invert", "<axis>")


@pytest.mark.parametrize(("y", "axis"), [(0.149, "0 1 0"), (-0.15, "1 0 0"), (-0.15, "0 1 0.1")])
def test_wheels_without_lateral_distance(y: float, axis: str) -> None:
    robot = BASE + wheel("left", 0.15) + wheel("right", y, axis=axis)
    left, right = wheels_of(robot, "left", "right")
    assert wrong_direction(left, right) is wrong_direction(right, left) is None
