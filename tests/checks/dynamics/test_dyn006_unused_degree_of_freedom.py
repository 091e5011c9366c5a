import pytest

from tests.gazebos import BASE
from tests.jointed import mimic
from tests.massive import inertial, link, shape
from tests.naming import naming
from tests.reported import messages

BALL = shape("visual", '<sphere radius="0.1"/>')


def turning(inside: str = "", kind: str = "continuous", more: str = "") -> str:
    joint = f'<joint name="j" type="{kind}"><parent link="base"/><child link="a"/>{more}</joint>'
    return BASE + link("a", inside) + joint


def test_a_joint_that_moves_nothing() -> None:
    assert messages("DYN006", turning()) == [naming("j", "continuous", "a", "below", "neither")]


@pytest.mark.parametrize(
    "robot",
    [
        turning(BALL),
        turning(inertial(1e-6, (1e-9, 1e-9, 1e-9))),
        turning(kind="fixed"),
        turning(more=mimic("k")),
        turning() + link("b", BALL) + '<joint name="k" type="fixed"><parent link="a"/>'
        '<child link="b"/></joint>',
        turning() + '<gazebo reference="a"><sensor name="s" type="imu"/></gazebo>',
        turning() + '<ros2_control name="c" type="system"><joint name="j">'
        '<command_interface name="position"/></joint></ros2_control>',
        turning().replace(BASE, '<link name="base"/>'),
    ],
    ids=["seen", "weighs", "fixed", "follows", "below", "sensor", "driven", "massless"],
)
def test_what_is_of_use(robot: str) -> None:
    assert messages("DYN006", robot) == []
