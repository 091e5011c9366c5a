import pytest

from tests.naming import naming
from tests.reported import fixed, messages, reported
from urdfkit.text.diagnostic import Severity

INERTIA = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
BASE = f'<link name="base">\n  <inertial><mass value="{{}}"/>{INERTIA}</inertial>\n</link>\n'
EMPTY = BASE.replace(BASE[BASE.index("\n") : BASE.index("</link>")], "")
JOINT = '<joint name="j" type="fixed"><parent link="{}"/><child link="{}"/></joint>\n'


def test_the_mass_that_kdl_leaves_out() -> None:
    (found,) = reported("TRE007", BASE.format("8.2"))
    assert found.message == naming("base", "8.2 kg")
    assert (found.span.line, found.span.text) == (3, "<inertial>")
    assert found.severity is Severity.INFO


def test_for_kdl_it_is_worth_a_warning() -> None:
    report = reported("TRE007", BASE.format("1"), targets=("kdl",))
    assert [found.severity for found in report] == [Severity.WARNING]


@pytest.mark.parametrize(
    "robot",
    [
        EMPTY,
        BASE.format("0"),
        EMPTY.replace("base", "root") + BASE.format("1") + JOINT.format("root", "base"),
        BASE.format("1") + EMPTY.replace("base", "other"),  # TRE002
    ],
)
def test_a_root_without_mass_is_right(robot: str) -> None:
    assert messages("TRE007", robot) == []


def test_the_new_root_has_the_indentation_of_the_old() -> None:
    robot = f'<robot name="r">\r\n    <link name="base"><inertial><mass value="1"/>{INERTIA}'
    robot += "</inertial></link>\r\n</robot>\r\n"
    new = (
        '    <link name="base_root"/>\r\n'
        '    <joint name="base_root_joint" type="fixed">\r\n'
        '      <parent link="base_root"/>\r\n'
        '      <child link="base"/>\r\n'
        "    </joint>\r\n"
    )
    assert fixed("TRE007", robot, targets=("kdl",)) == robot.replace("    <link", new + "    <link")


def test_a_name_that_is_taken_and_a_link_of_a_macro_are_left_to_a_person() -> None:
    taken = (
        EMPTY.replace("base", "base_root") + BASE.format("1") + JOINT.format("base", "base_root")
    )
    assert [found.fix for found in reported("TRE007", taken, targets=("kdl",))] == [None]
    robot = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        f'<xacro:macro name="m" params="">{BASE.format("1")}</xacro:macro><xacro:m/></robot>'
    )
    assert [found.fix for found in reported("TRE007", robot, "robot.xacro", ("kdl",))] == [None]


def test_another_root_is_proposed_for_kdl_only() -> None:
    assert [found.fix for found in reported("TRE007", BASE.format("1"))] == [None]
