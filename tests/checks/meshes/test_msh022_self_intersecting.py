from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import link, mesh, messages
from urdfkit.mesh.samples import box, stl


def boxes(shared: float) -> bytes:
    """Two boxes of 1 x 1 x 1 that share some of their height."""
    return stl([*box((0, 0, 0), (1, 1, 1)), *box((0, 0, 1 - shared), (1, 1, 2 - shared))])


def test_half_of_each(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH022", link(mesh("a.stl")), {"a.stl": boxes(0.5)}) == [
        (
            "link 'arm': the collision mesh 'a.stl' has 2 pieces that overlap: masses computed "
            "from it count 33 % too much"
        )
    ]


@pytest.mark.parametrize(("shared", "is_reported"), [(-0.1, False), (0.09, False), (0.1, True)])
def test_the_bound(tmp_path: Path, shared: float, is_reported: bool) -> None:
    """Of 2 - shared the part shared counts twice: a twentieth at 2/21."""
    found = messages(tmp_path, "MSH022", link(mesh("a.stl")), {"a.stl": boxes(shared)})
    assert bool(found) is is_reported


def test_what_is_seen_counts_where_nothing_collides(tmp_path: Path) -> None:
    files = {"a.stl": boxes(0.5), "b.stl": boxes(-1)}
    seen = mesh("a.stl", "visual")
    assert len(messages(tmp_path, "MSH022", link(seen), files)) == 1
    assert messages(tmp_path, "MSH022", link(seen, mesh("b.stl")), files) == []
