from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import SOUND, link, mesh, messages
from urdfkit.mesh.samples import BOX, box, stl

CUBE = box((0, 0, 0), (1, 1, 1))
OPEN = stl(CUBE[2:])
TWISTED = stl([CUBE[0][::-1], *CUBE[1:]])


def test_holes_and_twists(tmp_path: Path) -> None:
    robot = link(mesh("open.stl"), mesh("twisted.stl"), mesh("sound.stl"))
    files = {"open.stl": OPEN, "twisted.stl": TWISTED, "sound.stl": SOUND}
    assert messages(tmp_path, "MSH015", robot, files) == [
        "link 'arm': the collision mesh 'open.stl' is not closed: 4 open edges among 10 triangles",
        (
            "link 'arm': the collision mesh 'twisted.stl' is not closed: 3 twisted edges among 12 "
            "triangles"
        ),
    ]


def test_a_visual_may_be_open(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH015", link(mesh("a.stl", "visual")), {"a.stl": OPEN}) == []


def test_a_file_is_told_once_and_where_it_is_a_collision(tmp_path: Path) -> None:
    robot = link(mesh("a.stl", "visual"), mesh("a.stl"), mesh("a.stl"))
    (found,) = messages(tmp_path, "MSH015", robot, {"a.stl": OPEN})
    assert "the collision mesh" in found


def test_what_is_flat_is_told_elsewhere(tmp_path: Path) -> None:
    flat = stl(box((0, 0, 0), (1, 1, 1), BOX[:2]))
    assert messages(tmp_path, "MSH015", link(mesh("a.stl")), {"a.stl": flat}) == []


def test_a_sheet_with_two_sides_encloses_nothing(tmp_path: Path) -> None:
    """Each triangle is there both ways round, so that no edge is open."""
    sides = stl([*CUBE[2:], *(face[::-1] for face in CUBE[2:])])
    assert messages(tmp_path, "MSH015", link(mesh("a.stl")), {"a.stl": sides}) == [
        (
            "link 'arm': the collision mesh 'a.stl' encloses nothing: its 20 triangles are two "
            "sides of a sheet"
        )
    ]
    assert messages(tmp_path, "MSH015", link(mesh("a.stl", "visual")), {"a.stl": sides}) == []
