import pytest

from tests.reported import messages, reported
from urdfkit.text.diagnostic import Severity

INERTIA = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
BASE = f'<link name="base">\n  <inertial><mass value="{{}}"/>{INERTIA}</inertial>\n</link>\n'
EMPTY = BASE.replace(BASE[BASE.index("\n") : BASE.index("</link>")], "")
JOINT = '<joint name="j" type="fixed"><parent link="{}"/><child link="{}"/></joint>\n'


def test_the_mass_that_kdl_leaves_out() -> None:
    (found,) = reported("TRE007", BASE.format("8.2"))
    assert found.message == "root link 'base' has 8.2 kg, which KDL ignores"
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
