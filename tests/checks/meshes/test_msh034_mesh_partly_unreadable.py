from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import SOUND, link, mesh, messages
from urdfkit.mesh.samples import collada


def test_a_bad_colour(tmp_path: Path) -> None:
    bad = collada(look="<diffuse><color>0.01.0 0 1</color></diffuse>")
    robot = link(mesh("a.dae", "visual"), mesh("b.stl"))
    assert messages(tmp_path, "MSH034", robot, {"a.dae": bad, "b.stl": SOUND}) == [
        (
            "link 'arm': the visual mesh 'a.dae' is broken in parts: 1 colour that cannot be read "
            "('0.01.0 0 1')"
        )
    ]


def test_nothing_is_left(tmp_path: Path) -> None:
    bad = collada().replace(b"<p>0 1 2</p>", b"<p>0 1 7</p>")
    assert messages(tmp_path, "MSH034", link(mesh("a.dae")), {"a.dae": bad}) == [
        (
            "link 'arm': the collision mesh 'a.dae' shows no triangles (1 triangle with a vertex "
            "that is not in the file)"
        )
    ]


def test_what_the_bytes_give_away_is_told_elsewhere(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH034", link(mesh("a.stl")), {"a.stl": SOUND[:-1]}) == []


@pytest.mark.parametrize(("role", "number"), [("visual", 1), ("collision", 0)])
def test_the_looks_of_a_collision_matter_to_nobody(tmp_path: Path, role: str, number: int) -> None:
    bad = collada(look="<diffuse><color>0.01.0 0 1</color></diffuse>")
    assert len(messages(tmp_path, "MSH034", link(mesh("a.dae", role)), {"a.dae": bad})) == number
