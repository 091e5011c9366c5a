import pytest

from tests.conftest import MISSION
from tests.massive import BALL, BOX, MESH, WHEEL, link
from tests.naming import naming
from tests.reported import messages, places
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Severity


def robot(rgba: str, material: str, name: str = "paint") -> str:
    color = f'<material name="{name}"><color rgba="{rgba}"/></material>'
    visual = f"<visual><geometry>{BALL}</geometry>{color}</visual>"
    block = f'<gazebo reference="arm">\n<material>{material}</material></gazebo>'
    return link("arm", visual) + block


def test_red_and_green() -> None:
    text = robot("0 1 0 1", "Gazebo/Red")
    assert messages("GEO009", text) == [
        naming("arm", "Gazebo/Red", "1 0 0", "Gazebo", "paint", "0 1 0")
    ]
    assert places("GEO009", text) == [(4, "<material>")]


@pytest.mark.parametrize(
    ("rgba", "material", "name"),
    [
        ("1 0 0 1", "Gazebo/Red", "paint"),
        ("0.8 0.1 0.1 0.5", "Gazebo/Red", "paint"),  # near it
        ("0.2 0.3 0.1 1", "Gazebo/Green", "Dark_Green"),  # meant to be the same
        ("1 0 0 1", "Gazebo/Wood", "paint"),  # a texture
        ("1 0 0 1", "Gazebo/Pink", "paint"),  # GAZ007
    ],
)
def test_what_is_alike_or_not_known(rgba: str, material: str, name: str) -> None:
    assert messages("GEO009", robot(rgba, material, name)) == []


def test_the_older_form_and_the_last_block_count() -> None:
    text = robot("0 1 0 1", "Gazebo/Green")
    last = '<gazebo reference="arm"><material value="Gazebo/Red"/></gazebo>'
    assert len(messages("GEO009", text + last)) == 1
    assert messages("GEO009", robot("0 1 0 1", "Gazebo/Red") + last.replace("Red", "Green")) == []


def test_a_link_without_a_colour_has_nothing_to_compare() -> None:
    text = link("arm", f"<visual><geometry>{BALL}</geometry></visual>")
    block = '<gazebo reference="arm"><material>Gazebo/Red</material></gazebo>'
    assert messages("GEO009", text + block) == []
    assert messages("GEO009", text + block.replace("arm", "leg")) == []


@pytest.mark.parametrize(
    ("target", "found"),
    [("classic-ros1", 1), ("gz-fortress", 0), ("gz-harmonic", 1), ("ros2", 1)],
)
def test_fortress_has_no_such_materials(target: str, found: int) -> None:
    assert len(messages("GEO009", robot("0 1 0 1", "Gazebo/Red"), targets=(target,))) == found


def test_gz_draws_another_grey() -> None:
    text = robot("0.25 0.25 0.25 1", "Gazebo/Grey")
    assert len(messages("GEO009", text, targets=("classic-ros2",))) == 1
    assert messages("GEO009", text, targets=("gz-harmonic",)) == []


LOGO = '<material name="logo"><texture filename="logo.png"/></material>\n'


def logo_on(name: str, geometry: str) -> str:
    visual = f'<visual><geometry>{geometry}</geometry><material name="logo"/></visual>'
    return link(name, visual)


@pytest.mark.parametrize(
    ("geometry", "kind"), [(BOX, "box"), (BALL, "sphere"), (WHEEL, "cylinder")]
)
def test_a_texture_is_reported_once(geometry: str, kind: str) -> None:
    text = LOGO + logo_on("a", geometry) + logo_on("b", geometry)
    message = naming("a", "texture", kind, "RViz")
    assert messages("GEO009", text) == [message]
    assert messages("GEO009", text, targets=("gz-fortress",)) == [message]
    assert places("GEO009", text) == [(2, "logo.png")]


def test_a_mesh_has_texture_coordinates() -> None:
    assert messages("GEO009", LOGO + logo_on("a", MESH)) == []
    assert messages("GEO009", LOGO + link("a")) == []


def test_the_mission_s_model() -> None:
    found = engine.check(MISSION, select=["GEO009"]).diagnostics
    assert [(one.message, one.severity, one.span.text) for one in found] == [
        (naming(*expected), Severity.INFO, "<material>")
        for expected in (
            ("base_link", "Gazebo/Orange", "1 0.509 0.0468", "white", "1 1 1"),
            ("wheel_1", "Gazebo/Red", "1 0 0", "black", "0 0 0"),
            ("wheel_3", "Gazebo/Red", "1 0 0", "black", "0 0 0"),
            ("imu_link", "Gazebo/Orange", "1 0.509 0.0468", "green", "0 1 0"),
        )
    ]
    assert [one.span.line for one in found] == [278, 281, 287, 396]
