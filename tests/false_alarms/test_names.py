"""Names that look wrong and do no harm."""

from __future__ import annotations

import pytest

from tests.gazebos import BASE, block, child
from tests.reported import reported
from urdfkit.text.diagnostic import Severity

KEPT = block("<preserveFixedJoint>true</preserveFixedJoint>", "hand")


def shared(kind: str, name: str = "hand") -> str:
    """A robot whose joint has the name of a link."""
    return BASE + child("hand", kind).replace("hand_joint", name)


@pytest.mark.parametrize(
    ("robot", "severity"),
    [  # libsdformat 12.3 calls the first two valid and refuses the others
        (shared("fixed"), Severity.INFO),
        (shared("fixed", "arm") + child("arm"), Severity.INFO),
        (shared("fixed") + KEPT, Severity.ERROR),
        (shared("continuous"), Severity.ERROR),
        (shared("fixed").replace('"base"', '"world"'), Severity.ERROR),
    ],
)
def test_a_fixed_joint_that_gazebo_merges_may_have_the_name_of_a_link(
    robot: str, severity: Severity
) -> None:
    (found,) = reported("NAM003", robot, targets=("gz-harmonic",))
    assert found.severity is severity
