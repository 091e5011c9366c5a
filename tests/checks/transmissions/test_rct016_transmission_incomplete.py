from __future__ import annotations

import pytest

from tests.controls import NEXT, ROBOT, transmission
from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Severity

GOOD = ROBOT + transmission("swing")
TYPE = "<type>transmission_interface/SimpleTransmission</type>"
ACTUATOR = '<actuator name="m"><mechanicalReduction>1</mechanicalReduction></actuator>'


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (TYPE, "", "transmission 't' has no <type>"),
        (TYPE, "<type/>", "transmission 't' has no <type>"),
        (
            f'name="t">{TYPE}',
            'name="t" type="SimpleTransmission">',
            "transmission 't' has no <type> (the attribute does not count)",
        ),
        ('name="t"', "", "a transmission has no name"),
        (ACTUATOR, "", "transmission 't' has no <actuator>"),
        ('<actuator name="m">', "<actuator>", "transmission 't' has no name in its <actuator>"),
        (
            TYPE,
            "</transmission><transmission>",
            "transmission 't' has no <type> and no <joint> and",
        ),
    ],
)
def test_what_is_missing(old: str, new: str, message: str) -> None:
    found = messages("RCT016", GOOD.replace(old, new))
    assert found[0].startswith(message)
    assert places("RCT016", GOOD.replace(old, new))[0][0] == NEXT


def test_what_is_whole_or_not_read() -> None:
    assert reported("RCT016", GOOD) == []
    assert reported("RCT016", GOOD.replace(TYPE, ""), targets=("ros2",)) == []
    pr2 = '<transmission name="t" type="pr2_mechanism_model/SimpleTransmission"/>'
    assert reported("RCT016", ROBOT + pr2) == []


@pytest.mark.parametrize(
    ("targets", "severity"),
    [((), Severity.WARNING), (("ros1",), Severity.ERROR), (("mujoco",), Severity.WARNING)],
)
def test_only_ros_suffers(targets: tuple[str, ...], severity: Severity) -> None:
    (finding, *_) = reported("RCT016", GOOD.replace(TYPE, ""), targets=targets)
    assert finding.severity is severity
