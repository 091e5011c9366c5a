"""GEO004, rotation: see the rule."""

from math import pi
from pathlib import Path

import pytest

from tests import meshed
from tests.massive import link, shape
from tests.mesh.made import whole_gltf
from tests.naming import naming, values
from tests.reported import messages, places
from urdfkit.mesh import samples

ROD = '<cylinder radius="0.04" length="0.5"/>'
BAR = '<box size="0.08 0.08 0.5"/>'
QUARTER = pi / 2


def pair(rpy: str, xyz: str = "0 0 0") -> str:
    return link("a", shape("visual", BAR, xyz, rpy), shape("collision", ROD, xyz))


@pytest.mark.parametrize("rpy", [f"{QUARTER!r} 0 0", f"0 {-QUARTER!r} 0", f"1 {QUARTER!r} 1"])
def test_a_quarter_turn_explains_it(rpy: str) -> None:
    (message,) = messages("GEO004", pair(rpy, "0.1 0 0.2"))
    assert message.startswith("link 'a': ")
    assert values(message)[1::2] == ["9%", "100%"]
    assert "for the visual" in message


@pytest.mark.parametrize("rpy", ["0 0 0", f"0 0 {QUARTER!r}", f"{pi!r} 0 0", "0.3 0 0"])
def test_what_lies_alike_or_is_turned_on_purpose(rpy: str) -> None:
    assert messages("GEO004", pair(rpy)) == []


def test_the_body_with_a_rotation_is_turned() -> None:
    turned = link("a", shape("visual", BAR), shape("collision", ROD, rpy=f"{QUARTER!r} 0 0"))
    (message,) = messages("GEO004", turned)
    assert message == naming("a", "visual", "collision", "9%", 'rpy="0 0 0"', "collision", "100%")


def test_of_several_shapes_none_is_turned_alone() -> None:
    half = '<box size="0.08 0.08 0.25"/>'
    halves = [shape("visual", half, f"0 0 {z}") for z in (0.125, -0.125)]
    turned = shape("collision", ROD, rpy=f"{QUARTER!r} 0 0")
    (message,) = messages("GEO004", link("a", *halves, turned))
    assert message == naming("a", "visual", "collision", "9%", 'rpy="0 0 0"', "collision", "100%")
    ((_, text),) = places("GEO004", link("a", *halves, turned))
    assert text == f'<origin xyz="0 0 0" rpy="{QUARTER!r} 0 0"/>'


class TestMeshes:
    @pytest.fixture(autouse=True)
    def _measured(self) -> None:
        for library in ("numpy", "lxml", "manifold3d"):
            pytest.importorskip(library)

    def reported(self, directory: Path, seen: str, data: bytes, rpy: str) -> list[str]:
        files = {seen: data, "touched.stl": samples.stl(samples.box((0, 0, 0), (0.2, 0.2, 0.25)))}
        visual = meshed.mesh(seen, "visual", origin=f'<origin rpy="{rpy}"/>')
        robot = meshed.link(visual, meshed.mesh("touched.stl"))
        return meshed.messages(directory, "GEO004", robot, files)

    def test_one_part_twice_tells_the_slightest_turn(self, tmp_path: Path) -> None:
        part = samples.stl(samples.box((0, 0, 0), (0.2, 0.2, 0.249)))
        assert self.reported(tmp_path, "seen.stl", part, "0 0 0") == []
        (message,) = self.reported(tmp_path, "seen.stl", part, f"{QUARTER!r} 0 0")
        assert message == naming(
            "arm", "visual", "collision", "0%", 'rpy="0 0 0"', "visual", "100%"
        )

    def test_programs_do_not_agree_on_the_axes_of_gltf(self, tmp_path: Path) -> None:
        assert self.reported(tmp_path, "seen.gltf", whole_gltf(), f"{QUARTER!r} 0 0") == []
