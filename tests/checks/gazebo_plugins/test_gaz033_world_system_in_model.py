from __future__ import annotations

import pytest

from tests.gazebos import BASE, plugin
from tests.reported import messages, reported


@pytest.mark.parametrize("file", ["gz-sim-sensors-system", "libgz-sim8-physics-system.so"])
def test_a_system_of_the_world(file: str) -> None:
    assert messages("GAZ033", BASE + plugin(file)) == [
        f"plugin 'p' ({file}) is a system of the world, which has it once for all robots"
    ]


@pytest.mark.parametrize(
    "file",
    [
        "gz-sim-diff-drive-system",
        "gz-sim-triggered-publisher-system",  # of either
        "libgazebo_ros_state.so",  # Classic refuses it, which another rule tells
        "libvendor.so",
    ],
)
def test_no_finding(file: str) -> None:
    assert reported("GAZ033", BASE + plugin(file)) == []
