"""GAZ067: that nobody's forces are not measured harms nobody."""

import pytest

from tests.sensing import findings

FEEDBACK = "<provideFeedback>true</provideFeedback>"


def severity(inside: str = "", beside: str = "", kind: str = "force_torque") -> str:
    (found,) = findings("GAZ067", kind, inside, reference="wrist", beside=beside)
    return found.severity.value


def test_a_sensor_without_a_reader_is_a_warning() -> None:
    assert severity() == "warning"
    assert severity(kind="imu", beside=FEEDBACK) == "warning"


@pytest.mark.parametrize(
    "inside", ["<topic>force</topic>", '<plugin name="p" filename="libforce.so"/>']
)
def test_a_sensor_that_is_read_is_an_error(inside: str) -> None:
    assert severity(inside) == "error"


def test_a_plugin_that_names_the_joint_reads_it() -> None:
    plugin = '<plugin name="p" filename="libx.so"><jointName>wrist</jointName></plugin>'
    assert severity(kind="imu", beside=FEEDBACK + plugin) == "error"


def test_a_plugin_that_moves_the_joint_does_not_read_it() -> None:
    """TALOS with fixed fingers: their mimic plugins are idle, which GAZ021 says."""
    name = "libroboticsgroup_gazebo_mimic_joint_plugin.so"
    mimic = f'<plugin name="p" filename="{name}"><mimicJoint>wrist</mimicJoint></plugin>'
    assert severity(kind="imu", beside=FEEDBACK + mimic) == "warning"
