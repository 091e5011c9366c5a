import pytest

from tests.jointed import joint, robot
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.ros.targets import TARGETS
from urdfkit.text.diagnostic import Severity


@pytest.mark.parametrize("kind", ["floating", "planar"])
def test_a_joint_that_few_readers_know(kind: str) -> None:
    text = robot(joint("j", kind))
    assert messages("JNT022", text) == [naming("j", kind, "Gazebo", "fixed")]
    assert places("JNT022", text) == [(4, kind)]


@pytest.mark.parametrize("kind", ["revolute", "continuous", "prismatic", "fixed", "Floating"])
def test_no_finding(kind: str) -> None:
    assert reported("JNT022", robot(joint("j", kind))) == []


@pytest.mark.parametrize("target", TARGETS)
def test_who_suffers(target: str) -> None:
    (found,) = reported("JNT022", robot(joint("j", "planar")), targets=(target,))
    suffers = target == "kdl" or target.startswith(("classic", "gz"))
    assert found.severity is (Severity.WARNING if suffers else Severity.INFO)
    assert found.targets == ((target,) if suffers else ())
