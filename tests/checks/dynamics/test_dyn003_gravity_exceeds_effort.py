import sys
from typing import Any

import pytest

from tests.conftest import ARM
from tests.massive import inertial, link
from tests.reported import messages, places, reported
from tests.robot.test_joint_loads import pendulum, swinging
from urdfkit import Severity
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.physics import gravity, overloads
from urdfkit.text.source import Source


def test_the_torque_and_the_pose() -> None:
    """2 kg at 0.7 m, level at a right angle."""
    (message,) = messages("DYN003", pendulum("13.7"))
    assert message in {
        (
            f"joint 'bob_joint' needs 13.73 N·m to hold against gravity at bob_joint {sign}1.57; "
            "its effort limit is 13.7 N·m"
        )
        for sign in ("", "-")
    }
    assert places("DYN003", pendulum("13.7"))[0][1] == "13.7"


@pytest.mark.parametrize(
    ("effort", "severity"), [("13.7", Severity.INFO), ("13", Severity.WARNING)]
)
def test_masses_are_known_to_a_few_percent(effort: str, severity: Severity) -> None:
    """Sciurus17: 4.04 N·m in the worst pose, of 4 N·m."""
    assert [one.severity for one in reported("DYN003", pendulum(effort))] == [severity]


@pytest.mark.parametrize("effort", ["13.8", "0"])
def test_enough_effort_and_none_at_all(effort: str) -> None:
    assert messages("DYN003", pendulum(effort)) == []


def test_limits_keep_it_from_the_worst_pose() -> None:
    short = pendulum("8").replace('lower="-3" upper="3"', 'lower="-0.5" upper="0.5"')
    assert messages("DYN003", short) == []


@pytest.mark.parametrize(
    ("name", "kind", "severity"),
    [
        ("left_bogie_joint", "continuous", Severity.INFO),
        ("left_bogie_joint", "fixed", Severity.WARNING),
        ("bob_joint", "continuous", Severity.WARNING),
    ],
)
def test_a_suspension_stands_on_its_wheels(name: str, kind: str, severity: Severity) -> None:
    """The rover of Robocol, whose rockers have transmissions."""
    wheel = link("wheel") + f'<joint name="w" type="{kind}">'
    wheel += '<parent link="bob"/><child link="wheel"/></joint>'
    robot = pendulum("13").replace("bob_joint", name) + wheel
    assert [one.severity for one in reported("DYN003", robot)] == [severity]


def test_a_joint_that_cannot_move_is_held_by_its_stops() -> None:
    fixed = pendulum("1").replace('lower="-3" upper="3"', 'lower="1" upper="1"')
    assert messages("DYN003", fixed) == []


def test_a_vertical_axis_holds_nothing() -> None:
    assert messages("DYN003", pendulum("1").replace("0 1 0", "0 0 1")) == []


def test_robots_without_a_tree_or_a_mass() -> None:
    assert messages("DYN003", pendulum("1") + link("island")) == []
    assert messages("DYN003", link("a") + link("b") + swinging("b", "a", "1")) == []


def test_numbers_that_overflow_are_no_load() -> None:
    text = link("base") + link("bob", inertial(1e200, (1, 1, 1), xyz="0 0 1e200"))
    assert messages("DYN003", text + swinging("bob", "base", "1")) == []


def test_neither_pinocchio_nor_numpy_is_needed(monkeypatch: pytest.MonkeyPatch) -> None:
    for library in ("pinocchio", "numpy"):
        monkeypatch.setitem(sys.modules, library, None)
    for effort, count in (("30", 0), ("3", 1)):
        report = engine.check(
            Source("r.urdf", whole_robot(pendulum(effort)).encode()), select=["DYN003"]
        )
        assert len(report.diagnostics) == count
        assert report.skipped == ()


def test_masses_that_did_not_change_are_not_computed_again(monkeypatch: pytest.MonkeyPatch) -> None:
    searched = []

    def noted(*values: Any, **named: Any) -> list[gravity.Load]:
        searched.append(values)
        return loads(*values, **named)

    loads = gravity.gravity_loads
    monkeypatch.setattr(overloads, "gravity_loads", noted)
    texts = [pendulum("4.25"), pendulum("4.25") + "<gazebo/>", pendulum("4.5")]
    assert len({messages("DYN003", text)[0] for text in texts}) == 2
    assert len(searched) == 2


def test_the_arm_of_our_own_holds_itself() -> None:
    assert engine.check(ARM, select=["DYN"]).diagnostics == ()


@pytest.mark.parametrize(("names", "severity"), [(["bob_joint", "w"], "warning"), (["w"], "info")])
def test_a_joint_that_nothing_drives(names: list[str], severity: str) -> None:
    """A rover's rocker swings freely; the exporter wrote an effort all the same."""
    joints = "".join(
        f'<joint name="{n}"><command_interface name="position"/></joint>' for n in names
    )
    control = f'<ros2_control name="c" type="system">{joints}</ros2_control>'
    (found,) = reported("DYN003", pendulum("1") + control)
    assert found.severity.value == severity
