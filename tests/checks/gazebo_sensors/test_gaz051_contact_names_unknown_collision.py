"""GAZ051: see the rule."""

import pytest

from tests.naming import naming
from tests.sensing import findings


@pytest.mark.parametrize(
    ("reference", "name", "count"),
    [
        ("base", "base_collision", 0),
        ("base", "base_fixed_joint_lump__end_collision_1", 0),
        ("tip", "base_fixed_joint_lump__end_collision_1", 0),
        ("tip", "end", 1),
        ("base", "collision", 1),
        ("base", "__default__", 0),
    ],
)
def test_the_names_are_those_after_the_conversion(reference, name, count):
    inner = f"<contact><collision>{name}</collision></contact>"
    assert len(findings("GAZ051", "contact", inner, reference=reference)) == count


def test_the_nearest_is_reported():
    inner = "<contact><collision>base_colision</collision></contact>"
    (finding,) = findings("GAZ051", "contact", inner)
    assert finding.message == naming(
        "s", "unknown", "collision", "base_colision", "base", "base_collision"
    )


def test_nothing_is_suggested_where_nothing_is_alike():
    inner = "<contact><collision>wheel_17</collision></contact>"
    (finding,) = findings("GAZ051", "contact", inner)
    assert "did you mean" not in finding.message


@pytest.mark.parametrize("name", ["end", "end_collision", "tip_collision"])
def test_what_gazebo_calls_it_is_reported(name):
    inner = f"<contact><collision>{name}</collision></contact>"
    (finding,) = findings("GAZ051", "contact", inner, reference="tip")
    assert "is 'base_fixed_joint_lump__end_collision_1'" in finding.message
    assert finding.fix
    name = "base_fixed_joint_lump__end_collision_1"
    assert finding.fix.title == naming(f"<collision>{name}</collision>")


@pytest.mark.parametrize("inner", ["", "<contact/>"])
def test_a_sensor_must_name_a_collision(inner):
    (finding,) = findings("GAZ051", "contact", inner)
    assert finding.message == naming("s", "<collision>", "<contact>")
    assert findings("GAZ051", "imu", inner) == []
