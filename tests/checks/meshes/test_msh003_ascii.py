"""MSH003: paths with characters outside ASCII."""

from pathlib import Path

import pytest

from tests.meshed import SOUND, link, mesh, messages
from tests.naming import naming


@pytest.mark.parametrize("name", ["größe.stl", "звезда.stl", "meshes/手/a.stl"])
def test_they_are_not_portable(tmp_path: Path, name: str) -> None:
    (found,) = messages(tmp_path, "MSH003", link(mesh(name)), {name: SOUND})
    assert found == naming("arm", "collision", name, "outside", "ASCII")


def test_the_directories_of_a_machine_may_have_them(tmp_path: Path) -> None:
    directory = tmp_path / "größe"
    assert messages(directory, "MSH003", link(mesh("a.stl")), {"a.stl": SOUND}) == []
