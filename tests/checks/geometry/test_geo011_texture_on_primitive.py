import pytest

from tests.massive import BALL, BOX, MESH, WHEEL, link
from tests.reported import messages, places

LOGO = '<material name="logo"><texture filename="logo.png"/></material>\n'


def seen(name: str, geometry: str, material: str = '<material name="logo"/>') -> str:
    return link(name, f"<visual><geometry>{geometry}</geometry>{material}</visual>")


@pytest.mark.parametrize(
    ("geometry", "kind"), [(BOX, "box"), (BALL, "sphere"), (WHEEL, "cylinder")]
)
def test_once_per_texture(geometry: str, kind: str) -> None:
    robot = LOGO + seen("a", geometry) + seen("b", geometry)
    assert messages("GEO011", robot) == [
        f"link 'a' has a texture on a {kind}, which only RViz shows"
    ]
    assert places("GEO011", robot) == [(2, "logo.png")]


def test_a_mesh_has_texture_coordinates() -> None:
    assert messages("GEO011", LOGO + seen("a", MESH)) == []
    assert messages("GEO011", LOGO + link("a")) == []
