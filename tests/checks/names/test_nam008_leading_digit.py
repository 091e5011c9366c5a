from __future__ import annotations

from tests.reported import messages, reported
from urdfkit.text.diagnostic import Severity

ROBOT = '<link name="2nd"/><link name="arm2"/><joint name="1_2" type="fixed"/><link name="\u0662"/>'


def test_links_and_joints_that_begin_with_a_digit() -> None:
    assert messages("NAM008", ROBOT) == [
        "link '2nd' begins with a digit, which USD does not allow",
        "joint '1_2' begins with a digit, which USD does not allow",
    ]
    assert {found.severity for found in reported("NAM008", ROBOT)} == {Severity.INFO}


def test_every_digit_is_one() -> None:
    links = "".join(f'<link name="{digit}a"/>' for digit in "0123456789")
    assert len(messages("NAM008", links)) == 10


def test_for_isaac_it_is_worth_a_warning() -> None:
    report = reported("NAM008", ROBOT, targets=("isaac",))
    assert {found.severity for found in report} == {Severity.WARNING}
