import sys

import pytest

from tests.jointed import joint, robot
from tests.naming import naming
from tests.reported import reported
from urdfkit.core.installation import install_command
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.source import Source

pytest.importorskip("pinocchio")
FOR = ("pinocchio",)

LOST = '<link name="a"/><joint name="j" type="fixed"><parent link="x"/><child link="a"/></joint>'
NO_EFFORT = joint("j", "revolute", '<limit lower="0" upper="1" velocity="1"/>')


def test_the_reason_and_its_place() -> None:
    (found,) = reported("DYN001", robot(NO_EFFORT), targets=FOR)
    assert found.message == naming("Pinocchio", "rejects", "effort")
    assert found.span.line == 4


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (
            '<link name="a"/><link name="b"/>',
            ["Two root", "a] and [b"],
        ),
        ('<link name="a"/><link name="a"/>', ["a", "not unique"]),
        (LOST, ["link [x", "joint [j"]),
    ],
)
def test_reasons(text: str, reason: list[str]) -> None:
    (found,) = reported("DYN001", text, targets=FOR)
    assert found.message == naming("Pinocchio", "rejects", *reason)


def test_nobody_asks_unless_the_robot_is_for_pinocchio() -> None:
    assert reported("DYN001", robot(NO_EFFORT)) == []
    assert reported("DYN001", robot(NO_EFFORT), targets=("ros2",)) == []


def test_without_pinocchio_it_is_skipped_and_the_command_to_install_it_reported(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "pinocchio", None)
    monkeypatch.setattr("urdfkit.core.libraries.find", lambda name: None)
    text = whole_robot(robot(NO_EFFORT)).encode()
    report = engine.check(Source("r.urdf", text), select=["DYN001"], targets=FOR)
    assert report.diagnostics == ()
    (skipped,) = report.skipped
    assert skipped.code == "DYN001"
    assert install_command("dynamics") in skipped.reason
