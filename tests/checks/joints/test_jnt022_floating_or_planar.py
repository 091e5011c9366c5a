import pytest

from tests.jointed import joint, robot
from tests.reported import messages, places, reported
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.ros.targets import TARGETS
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source


@pytest.mark.parametrize("kind", ["floating", "planar"])
def test_a_joint_that_few_readers_know(kind: str) -> None:
    text = robot(joint("j", kind))
    assert messages("JNT022", text) == [
        f"joint 'j' is {kind}: Gazebo drops the joint, and KDL reads it as fixed"
    ]
    assert places("JNT022", text) == [(4, kind)]


@pytest.mark.parametrize("kind", ["revolute", "continuous", "prismatic", "fixed", "Floating"])
def test_no_finding(kind: str) -> None:
    assert reported("JNT022", robot(joint("j", kind))) == []


@pytest.mark.parametrize("target", TARGETS)
def test_who_suffers(target: str) -> None:
    source = Source("robot.urdf", whole_robot(robot(joint("j", "planar"))).encode())
    (found,) = engine.check(source, select=["JNT022"], targets=[target]).diagnostics
    suffers = target == "kdl" or target.startswith(("classic", "gz"))
    assert found.severity is (Severity.WARNING if suffers else Severity.INFO)
    assert found.targets == ((target,) if suffers else ())
