from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import SOUND, link, mesh, messages
from urdfkit.mesh.samples import box, stl


def frame(gap: float) -> bytes:
    """Two plates of 1 x 1 x 0.1 with a gap."""
    return stl([*box((0, 0, 0), (1, 1, 0.1)), *box((0, 0, 0.1 + gap), (1, 1, 0.2 + gap))])


def test_two_plates_far_apart(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH023", link(mesh("a.stl")), {"a.stl": frame(0.8)}) == [
        (
            "link 'arm': the collision mesh 'a.stl' has 2 pieces; its convex hull, which several "
            "simulators take, has 5 times their volume"
        )
    ]


@pytest.mark.parametrize(("gap", "is_reported"), [(0.39, False), (0.41, True)])
def test_the_bound(tmp_path: Path, gap: float, is_reported: bool) -> None:
    found = messages(tmp_path, "MSH023", link(mesh("a.stl")), {"a.stl": frame(gap)})
    assert bool(found) is is_reported


def test_one_piece_or_only_seen(tmp_path: Path) -> None:
    robot = link(mesh("a.stl", "visual"), mesh("b.stl"))
    assert messages(tmp_path, "MSH023", robot, {"a.stl": frame(0.8), "b.stl": SOUND}) == []
