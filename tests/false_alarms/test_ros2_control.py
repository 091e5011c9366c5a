"""What the hardware has and the simulator has not, in a description for both."""

from __future__ import annotations

import pytest

from tests.controls import GZ, ROBOT, control, driven
from tests.reported import reported
from urdfkit.text.diagnostic import Severity

SENSOR = '<sensor name="finger"><state_interface name="Present Pressure 1"/></sensor>'


@pytest.mark.parametrize(
    ("part", "severity"),
    [
        (driven("swing", state="torque_enable"), Severity.INFO),
        (SENSOR, Severity.INFO),
        (driven("swing", state="positon"), Severity.WARNING),
        (driven("swing", command="torque_enable"), Severity.WARNING),
    ],
)
def test_state_interfaces_of_the_hardware_alone(part: str, severity: Severity) -> None:
    """ROBOTIS's hand and arms."""
    (found,) = reported("RCT017", ROBOT + control(part, plugin=GZ))
    assert found.severity is severity


@pytest.mark.parametrize(("tag", "count"), [("ec_module", 0), ("ecmodules", 1)])
def test_modules_of_the_ethercat_driver(tag: str, count: int) -> None:
    """SIMCO's base: every joint has the module of its drive."""
    module = f'<{tag} name="drive"><plugin>ethercat_generic_plugins/EcCiA402Drive</plugin></{tag}>'
    robot = ROBOT + control(driven("swing", more=module))
    assert len(reported("RCT017", robot)) == count
