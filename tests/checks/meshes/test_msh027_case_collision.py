from __future__ import annotations

from pathlib import Path

import pytest

from tests.meshed import SOUND, link, mesh, messages


def test_names_that_differ_in_case_only(tmp_path: Path) -> None:
    (tmp_path / "Case").touch()
    if (tmp_path / "case").exists():
        pytest.skip("this file system does not tell upper from lower case")
    robot = link(mesh("a.stl"), mesh("b.stl"))
    files = {"a.stl": SOUND, "A.STL": SOUND, "b.stl": SOUND, "b.dae": b""}
    assert messages(tmp_path, "MSH027", robot, files) == [
        (
            "link 'arm': the collision mesh 'a.stl' and 'A.STL' beside it differ in upper and "
            "lower case only"
        )
    ]
