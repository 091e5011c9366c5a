import pytest

from tests.gazebos import BASE, block
from tests.naming import naming
from tests.reported import fixed, messages, reported
from urdfkit.ros.catalog.materials import materials


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        ("Orange", "Gazebo/Orange"),
        ("Gazebo/orange", "Gazebo/Orange"),
        ("gazebo/Orange", "Gazebo/Orange"),
        ("Gazebo/Ornage", "Gazebo/Orange"),
    ],
)
def test_the_nearest_is_written(wrong: str, right: str) -> None:
    text = BASE + block(f"<material> {wrong} </material>")
    assert messages("GAZ007", text) == [naming("unknown", "Gazebo", wrong)]
    assert fixed("GAZ007", text).count(f"<material> {right} </material>") == 1


@pytest.mark.parametrize(
    "name", ["Gazebo/Aluminum", "Gazebo/Chrome", "steel_brushed_with_scratches", ""]
)
def test_nothing_is_near(name: str) -> None:
    (found,) = reported("GAZ007", BASE + block(f"<material>{name}</material>"))
    said = naming("unknown", "Gazebo", name) if name else "<material> is empty"
    assert (found.message, found.fix) == (said, None)
    assert "did you mean" not in found.help


def test_colours_where_a_name_belongs() -> None:
    colours = "<material><ambient>1 0 0 1</ambient></material>"
    (found,) = reported("GAZ007", BASE + block(colours))
    assert found.message == naming("Gazebo", "<ambient>", "<material>")
    assert reported("GAZ007", BASE + block(f"<visual>{colours}</visual>")) == []


def test_materials_of_gazebo_and_of_vendors() -> None:
    known = [*materials(), "PR2/Red"]
    assert (
        reported("GAZ007", BASE + "".join(block(f"<material>{m}</material>") for m in known)) == []
    )
    assert (
        reported("GAZ007", BASE + "".join(block(f'<material value="{m}"/>') for m in known)) == []
    )


ROBOT = BASE + block("<material>Gazebo/Red</material>") + block("<material>Gazebo/Wood</material>")
RED = naming("Gazebo/Red", "Gazebo", "Fortress")
WOOD = naming("Gazebo/Wood", "Gazebo", "Fortress")


def heard(target: str) -> list[str]:
    return [found.message for found in reported("GAZ007", ROBOT, targets=(target,))]


def test_fortress_has_no_materials() -> None:
    assert heard("gz-fortress") == [RED, WOOD]


def test_gz_sim_has_no_textures() -> None:
    assert heard("gz-harmonic") == [naming("draw", "Gazebo/Wood")]


def test_classic_has_both() -> None:
    assert heard("classic-ros1") == []
    assert reported("GAZ007", ROBOT) == [], "nothing tells which Gazebo is meant"


def test_a_value_may_stand_in_an_attribute() -> None:
    text = BASE + block('<material value="Gazebo/Wood"/>')
    (found,) = reported("GAZ007", text, targets=("gz-fortress",))
    assert found.message == WOOD
