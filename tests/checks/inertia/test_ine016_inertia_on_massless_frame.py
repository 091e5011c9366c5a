import pytest

from tests.massive import inertial, joint, link
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Severity

BASE = link("base", inertial(3, (0.03, 0.03, 0.05)))


def frame(mass: float, moments: tuple[float, ...], kind: str = "fixed") -> str:
    return BASE + link("sonar", inertial(mass, moments)) + joint("base", "sonar", kind)


def test_gazebo_adds_the_tensor() -> None:
    robot = frame(0, (1, 1, 1))
    assert messages("INE016", robot) == [naming("sonar", "0 kg", "1 kg·m²")]
    assert [line for line, _ in places("INE016", robot)] == [5]


@pytest.mark.parametrize(
    "robot",
    [
        frame(0, (0, 0, 0)),
        frame(0.1, (1, 1, 1)),
        frame(0, (1, 1, 1), "revolute"),  # INE001
        link("base", inertial(0, (1, 1, 1))),  # nothing to add it to
    ],
)
def test_what_is_all_right_or_another_rule_s(robot: str) -> None:
    assert messages("INE016", robot) == []


@pytest.mark.parametrize(
    ("targets", "severity"), [((), Severity.INFO), (("classic-ros2",), Severity.WARNING)]
)
def test_who_suffers(targets: tuple[str, ...], severity: Severity) -> None:
    (found,) = reported("INE016", frame(0, (1, 1, 1)), targets=targets)
    assert found.severity is severity
