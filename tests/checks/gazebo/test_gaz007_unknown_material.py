from __future__ import annotations

import pytest

from tests.gazebos import BASE, block
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
    assert messages("GAZ007", text) == [f"Gazebo has no material '{wrong}'"]
    assert fixed("GAZ007", text).count(f"<material> {right} </material>") == 1


@pytest.mark.parametrize(
    "name", ["Gazebo/Aluminum", "Gazebo/Chrome", "steel_brushed_with_scratches", ""]
)
def test_nothing_is_near(name: str) -> None:
    (found,) = reported("GAZ007", BASE + block(f"<material>{name}</material>"))
    said = f"Gazebo has no material '{name}'" if name else "<material> names no material"
    assert (found.message, found.fix) == (said, None)
    assert "did you mean" not in found.help


@pytest.mark.parametrize("name", [*materials(), "PR2/Red"])
def test_materials_of_gazebo_and_of_vendors(name: str) -> None:
    assert reported("GAZ007", BASE + block(f"<material>{name}</material>")) == []
    assert reported("GAZ007", BASE + block(f'<material value="{name}"/>')) == []
