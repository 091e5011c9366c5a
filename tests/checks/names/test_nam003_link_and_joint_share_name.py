import pytest

from tests.gazebos import BASE, child
from tests.reported import reported
from urdfkit import convert, read
from urdfkit.errors import UrdfkitError
from urdfkit.ros.gazebo.rejection import rejections
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

ROBOT = """\
<link name="a"/>
<link name="b"/>
<joint name="{}" type="continuous">
  <parent link="a"/>
  <child link="b"/>
</joint>"""


def test_the_joint_is_the_place_and_the_link_is_shown() -> None:
    (found,) = reported("NAM003", ROBOT.format("b"))
    assert (found.span.line, found.span.text) == (4, "b")
    assert [one.span.text for one in found.related] == ['<link name="b"/>']
    assert found.severity is Severity.INFO
    assert reported("NAM003", ROBOT.format("ab")) == []


def test_gz_sim_refuses_the_model() -> None:
    report = reported("NAM003", ROBOT.format("b"), targets=("gz-harmonic",))
    assert [found.severity for found in report] == [Severity.ERROR]


ANYMAL = BASE + child("arm", "fixed") + child("hand", parent="arm").replace("hand_joint", "arm")


@pytest.mark.parametrize(
    "robot", [ANYMAL, BASE + child("arm", "fixed").replace("arm_joint", "arm")]
)
def test_the_frame_of_a_merged_link_has_a_unique_name_in_gz_sim(robot: str) -> None:
    """o3de/o3de-extras#476 has the error of libsdformat: the link and a joint of ANYmal."""
    (found,) = reported("NAM003", robot, targets=("gz-harmonic",))
    assert found.severity is Severity.ERROR
    context = read(Source("r.urdf", f'<robot name="r">{robot}</robot>'.encode()))
    (rejection,) = rejections([], context.gazebo)
    assert rejection.code == "NAM003"
    with pytest.raises(UrdfkitError, match="see 'urdfkit explain NAM003'"):
        convert(context, "out", to="sdf")


def test_a_merged_link_without_a_namesake() -> None:
    robot = BASE + child("arm", "fixed") + child("hand", parent="arm")
    assert reported("NAM003", robot, targets=("gz-harmonic",)) == []
