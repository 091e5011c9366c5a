import pytest

from tests.conftest import MISSION
from tests.jointed import joint, limit, robot
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit.lint import engine
from urdfkit.lint.grouping import grouped

JOINT = (
    '<link name="a"/><link name="b"/>\n<joint name="j" type="{}">\n'
    '  <parent link="a"/><child link="b"/>{}</joint>'
)
AXIS = '<axis xyz="0 1 0"/>'


def test_the_axis_is_the_place() -> None:
    text = JOINT.format("fixed", f"\n  {AXIS}\n")
    assert messages("JNT020", text) == [naming("j", "fixed", "<axis>")]
    assert places("JNT020", text) == [(5, AXIS)]


@pytest.mark.parametrize("kind", ["revolute", "continuous", "prismatic", "planar", "screw"])
def test_joints_that_move_need_it(kind: str) -> None:
    assert reported("JNT020", JOINT.format(kind, AXIS)) == []


@pytest.mark.parametrize(
    ("written", "left"),
    [
        (f"\n  {AXIS}\n", "\n"),
        (f"\r\n\t{AXIS} \r\n", "\r\n"),
        (f"{AXIS}", ""),
        (f"\n  {AXIS}<!-- y -->\n", "\n  <!-- y -->\n"),
        (f"\n  <!-- y -->{AXIS}\n", "\n  <!-- y -->\n"),
        ("\n  <axis\n    xyz='0 1 0'>\n  </axis>\n", "\n"),
    ],
)
def test_it_goes_with_its_line_and_takes_nothing_else(written: str, left: str) -> None:
    assert fixed("JNT020", JOINT.format("fixed", written)) == (
        f'<robot name="example">\n{JOINT.format("fixed", left)}\n</robot>\n'
    )


@pytest.mark.parametrize(("limits", "is_fixable"), [("", True), (limit("-1", "1"), False)])
def test_a_safe_fix_unless_the_joint_may_be_meant_to_move(limits: str, is_fixable: bool) -> None:
    axis = reported("JNT020", JOINT.format("fixed", AXIS + limits))[0]
    assert (axis.fix is not None and axis.fix.safe) is is_fixable
    assert ('write type="revolute"' in axis.help) is not is_fixable


def test_a_macro_whose_other_calls_may_need_it_is_not_edited() -> None:
    text = f"""\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="j" params="type n">
    <link name="l${{n}}"/>
    <joint name="j${{n}}" type="${{type}}"><parent link="a"/><child link="l${{n}}"/>{AXIS}</joint>
  </xacro:macro>
  <link name="a"/>
  <xacro:j type="fixed" n="1"/>
  <xacro:j type="continuous" n="2"/>
</robot>
"""
    (found,) = reported("JNT020", text, "robot.xacro")
    assert (found.span.line, found.span.text) == (4, AXIS)
    assert found.fix is None


def test_the_three_of_the_mission_s_model() -> None:
    report = engine.check(MISSION, select=["JNT020"])
    assert [found.message.split("'")[1] for found in report.diagnostics] == [
        "imu_joint",
        "camera_joint",
        "hokuyo_joint",
    ]
    assert {found.span.text for found in report.diagnostics} == {AXIS}


def test_position_limits_without_effect() -> None:
    text = robot(joint("j", "fixed", limit("-1", "1", "1", "1")))
    (found,) = reported("JNT020", text)
    assert "[-1, 1]" in found.message
    assert found.span.text == limit("-1", "1", "1", "1")
    assert found.fix is None


@pytest.mark.parametrize(
    ("kind", "content"),
    [
        ("fixed", limit("0", "0", "0", "0")),  # zeros of an exporter
        ("fixed", ""),
        ("revolute", limit("-1", "1", "1", "1")),
    ],
)
def test_no_limits_or_a_joint_that_moves(kind: str, content: str) -> None:
    assert reported("JNT020", robot(joint("j", kind, content))) == []


def test_limits_of_many_fixed_joints_are_one_group() -> None:
    """A humanoid whose arms are fixed for training keeps their limits."""
    arms = [joint(f"arm_{n}", "fixed", limit("-1", "1")) for n in range(3)]
    (found,) = grouped(reported("JNT020", robot(*arms)))
    assert len(found.related) == 2
