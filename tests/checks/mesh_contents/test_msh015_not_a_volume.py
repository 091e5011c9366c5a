from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import SOUND, link, mesh, messages, reported
from tests.naming import naming
from urdfkit.mesh.samples import BOX, box, stl

CUBE = box((0, 0, 0), (1, 1, 1))
OPEN = stl(CUBE[2:])
TWISTED = stl([CUBE[0][::-1], *CUBE[1:]])


def test_holes_and_twists(tmp_path: Path) -> None:
    robot = link(mesh("open.stl"), mesh("twisted.stl"), mesh("sound.stl"))
    files = {"open.stl": OPEN, "twisted.stl": TWISTED, "sound.stl": SOUND}
    assert messages(tmp_path, "MSH015", robot, files) == [
        naming("arm", "collision", "open.stl", "4", "10 triangles"),
        naming("arm", "collision", "twisted.stl", "3", "12 triangles"),
    ]


def test_a_visual_may_be_open(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH015", link(mesh("a.stl", "visual")), {"a.stl": OPEN}) == []


def test_a_file_is_reported_once_and_where_it_is_a_collision(tmp_path: Path) -> None:
    robot = link(mesh("a.stl", "visual"), mesh("a.stl"), mesh("a.stl"))
    (found,) = messages(tmp_path, "MSH015", robot, {"a.stl": OPEN})
    assert "the collision mesh" in found


def test_a_sheet_with_two_sides_encloses_nothing(tmp_path: Path) -> None:
    """Each triangle is there both ways round, so that no edge is open."""
    sides = stl([*CUBE[2:], *(face[::-1] for face in CUBE[2:])])
    assert messages(tmp_path, "MSH015", link(mesh("a.stl")), {"a.stl": sides}) == [
        naming("arm", "collision", "a.stl", "nothing", "20 triangles")
    ]
    assert messages(tmp_path, "MSH015", link(mesh("a.stl", "visual")), {"a.stl": sides}) == []


FLAT = stl(box((0, 0, 0), (1, 1, 1), BOX[:2]))


def test_a_square_is_flat(tmp_path: Path) -> None:
    robot = link(mesh("a.stl"), mesh("b.stl"))
    (found,) = reported(tmp_path, "MSH015", robot, {"a.stl": FLAT, "b.stl": SOUND})
    assert found.severity.value == "warning"
    assert found.message == naming("arm", "collision", "a.stl", "0 x 1 x 1 m")


def test_an_oblique_sheet_is_flat_in_a_box_that_is_not(tmp_path: Path) -> None:
    """The parts of a convex decomposition in BestMan_Pybullet."""
    flat = stl([[(0, 0, 0), (1, 0, 1), (1, 1, 1)], [(0, 0, 0), (1, 1, 1), (0, 1, 0)]])
    assert messages(tmp_path, "MSH015", link(mesh("a.stl")), {"a.stl": flat}) == [
        naming("arm", "collision", "a.stl", "1 x 1 x 1 m")
    ]


def test_a_label_may_be_flat(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH015", link(mesh("a.stl", "visual")), {"a.stl": FLAT}) == []


def test_thin_is_not_flat(tmp_path: Path) -> None:
    thin = stl(box((0, 0, 0), (1, 1, 1e-4)))
    assert messages(tmp_path, "MSH015", link(mesh("a.stl")), {"a.stl": thin}) == []


def boxes(shared: float) -> bytes:
    """Two boxes of 1 x 1 x 1 that share some of their height."""
    return stl([*box((0, 0, 0), (1, 1, 1)), *box((0, 0, 1 - shared), (1, 1, 2 - shared))])


def test_overlapping_pieces(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH015", link(mesh("a.stl")), {"a.stl": boxes(0.5)}) == [
        naming("arm", "collision", "a.stl", "2", "33 %")
    ]


@pytest.mark.parametrize(("shared", "is_reported"), [(-0.1, False), (0.09, False), (0.1, True)])
def test_the_bound_of_overlap(tmp_path: Path, shared: float, is_reported: bool) -> None:
    """Of 2 - shared the part shared counts twice: a twentieth at 2/21."""
    found = messages(tmp_path, "MSH015", link(mesh("a.stl")), {"a.stl": boxes(shared)})
    assert bool(found) is is_reported


def test_overlap_in_a_visual_matters_without_collisions(tmp_path: Path) -> None:
    files = {"a.stl": boxes(0.5), "b.stl": boxes(-1)}
    visual = mesh("a.stl", "visual")
    assert len(messages(tmp_path, "MSH015", link(visual), files)) == 1
    assert messages(tmp_path, "MSH015", link(visual, mesh("b.stl")), files) == []
