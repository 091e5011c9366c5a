from __future__ import annotations

from tests.gazebos import BASE, block
from tests.reported import reported

ROBOT = BASE + block("<material>Gazebo/Red</material>") + block("<material>Gazebo/Wood</material>")
RED = "Gazebo Fortress has no material scripts: 'Gazebo/Red' does nothing"
WOOD = "Gazebo Fortress has no material scripts: 'Gazebo/Wood' does nothing"


def heard(target: str) -> list[str]:
    return [found.message for found in reported("GAZ008", ROBOT, targets=(target,))]


def test_fortress_has_no_materials() -> None:
    assert heard("gz-fortress") == [RED, WOOD]


def test_gz_sim_has_no_textures() -> None:
    assert heard("gz-harmonic") == ["gz-sim does not draw the texture of 'Gazebo/Wood'"]


def test_classic_has_both() -> None:
    assert heard("classic-ros1") == []
    assert reported("GAZ008", ROBOT) == [], "nothing tells which Gazebo is meant"


def test_a_value_may_stand_in_an_attribute() -> None:
    text = BASE + block('<material value="Gazebo/Wood"/>')
    (found,) = reported("GAZ008", text, targets=("gz-fortress",))
    assert found.message == WOOD
