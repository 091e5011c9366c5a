"""GAZ065: see the rule."""

import pytest

from tests.gazebos import BASE, plugin
from tests.told import fixed, messages

FILE = "gz-sim-diff-drive-system"


def test_a_slip_is_told_and_mended() -> None:
    text = BASE + plugin(FILE, name="gz::sim::systems::DifDrive")
    assert messages("GAZ065", text) == [f"library {FILE} has no class 'gz::sim::systems::DifDrive'"]
    assert 'name="gz::sim::systems::DiffDrive"' in fixed("GAZ065", text)


@pytest.mark.parametrize(
    "name",
    ["gz::sim::systems::DiffDrive", "ignition::gazebo::systems::DiffDrive", "our_drive"],
)
def test_its_class_and_names_of_ours_are_calm(name: str) -> None:
    assert messages("GAZ065", BASE + plugin(FILE, name=name)) == []


def test_classic_takes_any_name() -> None:
    text = BASE + plugin("libgazebo_ros_diff_drive.so", name="gz::sim::systems::DifDrive")
    assert messages("GAZ065", text) == []
