from math import pi
from pathlib import Path

import pytest

from tests import meshed
from tests.conftest import MISSION
from tests.massive import BALL, BOX, MESH, link, shape
from tests.naming import naming
from tests.reported import messages, reported
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Severity

CUBE = '<box size="1 1 1"/>'


def pair(seen: str, touched: str, xyz: str = "0 0 0", rpy: str = "0 0 0") -> str:
    return link("a", shape("visual", seen, xyz, rpy), shape("collision", touched))


@pytest.mark.parametrize(
    ("shift", "common"),
    [("0.49 0 0", None), ("0.51 0 0", "32%"), ("0 0 0.9", "5%"), ("0 3 0", "0%")],
)
def test_a_cube_that_is_moved(shift: str, common: str | None) -> None:
    expected = [naming("a", common, "34%", "moved", f"{shift} m")] if common else []
    assert messages("GEO004", pair(CUBE, CUBE, shift)) == expected


@pytest.mark.parametrize(("xyz", "rpy"), [("0 0 0.9", "0 0 0"), ("0 0 0", "0 1.5 0")])
def test_a_link_without_a_name(xyz: str, rpy: str) -> None:
    rod = '<cylinder radius="0.05" length="1"/>'
    (message,) = messages("GEO004", pair(rod, rod, xyz, rpy).replace('name="a"', 'name=""'))
    assert message.startswith("link '': ")


def test_the_bounding_boxes_are_those_of_turned_shapes() -> None:
    rod = '<cylinder radius="0.05" length="1"/>'
    assert messages("GEO004", pair(rod, rod, rpy=f"0 {pi / 2!r} 0")) == [
        naming("a", "5%", "34%", "rotated")
    ]
    assert messages("GEO004", pair(BALL, BALL, rpy="1 2 3")) == []


def test_all_shapes_of_a_link_make_one_box() -> None:
    halves = [shape("collision", '<box size="0.5 1 1"/>', f"{x} 0 0") for x in (-0.25, 0.25)]
    assert messages("GEO004", link("a", shape("visual", CUBE), *halves)) == []
    assert messages("GEO004", link("a", shape("visual", CUBE), halves[0])) == []


@pytest.mark.parametrize(
    ("seen", "touched"),
    [
        ('<sphere radius="0.01"/>', '<sphere radius="0.1"/>'),  # a margin
        ('<box size="1 1 1"/>', '<box size="0.2 0.2 0.2"/>'),  # a core
        ('<box size="0.001 0.001 0.001"/>', '<box size="1 1 1"/>'),  # a marker
    ],
)
def test_larger_or_smaller_about_the_same_place(seen: str, touched: str) -> None:
    assert not any("in common" in message for message in messages("GEO004", pair(seen, touched)))


def test_a_marker_may_be_anywhere() -> None:
    assert messages("GEO004", pair(CUBE, '<box size="0.005 0.005 0.005"/>', "9 0 0")) == []


class TestMeshes:
    @pytest.fixture(autouse=True)
    def _measured(self) -> None:
        for library in ("numpy", "lxml", "manifold3d"):
            pytest.importorskip(library)

    def reported(self, directory: Path, seen: str, touched: str) -> list[str]:
        robot = meshed.link(seen, touched)
        return meshed.messages(directory, "GEO004", robot, {"a.stl": meshed.SOUND})

    @pytest.mark.parametrize(
        ("origin", "why"),
        [
            ('<origin xyz="0 -1.57 0"/>', ["moved", "0 1.57 0 m"]),
            ('<origin rpy="1.5707963267948966 0 0"/>', ["rotated"]),
            ('<origin xyz="0.04 0 0"/>', None),
            ("", None),
        ],
    )
    def test_the_same_mesh_elsewhere(
        self, tmp_path: Path, origin: str, why: list[str] | None
    ) -> None:
        touched = meshed.mesh("a.stl", origin=origin)
        found = self.reported(tmp_path, meshed.mesh("a.stl", "visual"), touched)
        if why is None:
            assert found == []
        else:
            assert found == [naming("arm", "0%", "34%", *why)]

    @pytest.mark.parametrize(("x", "is_reported"), [(0.44, False), (0.46, True)])
    def test_a_primitive_may_stand_for_a_part_of_a_mesh(
        self, tmp_path: Path, x: float, is_reported: bool
    ) -> None:
        """The mesh is 0.3 m long and reaches to 0.1 m, the cube begins 0.05 m before its middle."""
        touched = shape("collision", '<box size="0.1 0.1 0.1"/>', f"{x} 0 0.1")
        assert bool(self.reported(tmp_path, meshed.mesh("a.stl", "visual"), touched)) is is_reported


def test_a_mesh_that_is_missing_is_not_measured() -> None:
    assert messages("GEO004", pair(MESH, CUBE, "9 0 0")) == []
    assert messages("GEO004", pair(CUBE, MESH, "9 0 0")) == []


def test_two_different_shapes() -> None:
    (found,) = reported("GEO004", pair(BOX, BALL, "1 0 0"))
    assert found.message.endswith("less than 34%")
    assert [note.message for note in found.related] == ["the visual"]


def test_the_mission_s_model() -> None:
    (found,) = engine.check(MISSION, select=["GEO004"]).diagnostics
    assert found.message == naming("base_link", "20%", "34%", "rotated", "0 0 0.05 m")
    assert (found.span.line, found.span.text) == (63, "<collision>")
    assert found.severity is Severity.WARNING


def test_what_has_the_origin_of_the_inertia_is_right() -> None:
    rod = '<cylinder radius="0.1" length="0.02"/>'
    turned = f"{pi / 2!r} 0 0"
    inertial = (
        f'<inertial><origin rpy="{turned}"/><mass value="1"/>'
        '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    )
    bodies = (shape("visual", rod), shape("collision", rod, "0 0 0", turned))
    (found,) = reported("GEO004", link("a", *bodies, inertial))
    assert found.span.text == "<visual>"
    assert found.help == naming("visual", "<origin>", "collision")
    (found,) = reported("GEO004", link("a", *bodies))
    assert found.span.text == "<collision>"
