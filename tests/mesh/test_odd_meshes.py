"""Meshes and files that nobody makes on purpose: a result or one clear error, never a crash."""

import os
import random
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np

from tests.mesh.made import ascii_stl
from tests.mesh.shapes_made import cube
from urdfkit.cli import main
from urdfkit.errors import UrdfkitError
from urdfkit.mesh.convex_hull import hull
from urdfkit.mesh.fitting import fit
from urdfkit.mesh.geometry import Mesh, MeshPart
from urdfkit.mesh.repair import repair
from urdfkit.mesh.simplify import to_budget, to_error
from urdfkit.mesh.writers import SUFFIXES, encode

pytestmark = pytest.mark.usefixtures("rough_meshes")
RNG = np.random.default_rng(0)


def loose(number: int, scale: float) -> MeshPart:
    points = RNG.normal(size=(number * 3, 3)) * scale
    return MeshPart(points, np.arange(number * 3).reshape(-1, 3))


def joined(*parts: MeshPart) -> Mesh:
    return Mesh(parts)


MESHES = {
    "nothing": Mesh(()),
    "one triangle": joined(loose(1, 1)),
    "loose triangles": joined(loose(50, 1)),
    "tiny": joined(loose(20, 1e-9)),
    "huge": joined(loose(20, 1e30)),
    "both": joined(loose(5, 1), loose(5, 1e12)),
    "a line": joined(
        MeshPart(np.outer(np.arange(6.0), [1, 1, 1]), np.array([[0, 1, 2], [3, 4, 5]]))
    ),
    "a point": joined(MeshPart(np.zeros((3, 3)), np.array([[0, 1, 2]]))),
    "no numbers": joined(MeshPart(np.full((3, 3), np.nan), np.array([[0, 1, 2]]))),
    "a tangle": joined(MeshPart(RNG.normal(size=(12, 3)), RNG.integers(0, 12, (60, 3)))),
}
ACTIONS: dict[str, Callable[[Mesh], object]] = {
    "repair": repair,
    "to_budget": lambda mesh: to_budget(mesh, 4),
    "to_error": lambda mesh: to_error(mesh, 0.1),
    "hull": hull,
    "fit": lambda mesh: fit(mesh, 0.1, most=1),
}


@pytest.mark.filterwarnings("ignore::RuntimeWarning")  # of numpy, about what is no number
@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("action", ACTIONS)
def test_odd_meshes(name: str, action: str) -> None:
    with suppress(UrdfkitError):
        assert ACTIONS[action](MESHES[name]) is not None


def spoilt(suffix: str, rng: random.Random) -> bytes:
    data = ascii_stl() if rng.random() < 0.2 else encode(cube(), f"a{suffix}")[f"a{suffix}"]
    if rng.random() < 0.5:
        return data[: rng.randrange(len(data))]
    changed = bytearray(data)
    for _ in range(rng.choice([1, 3, 20])):
        changed[rng.randrange(len(data))] = rng.randrange(256)
    return bytes(changed)


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize(
    "words",
    [
        ["info"],
        ["repair"],
        ["convert", "OUT", "--force"],
        ["simplify", "--triangles", "6"],
        ["hull"],
    ],
    ids=lambda words: words[0],
)
def test_spoilt_files(
    words: list[str], suffix: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rng = random.Random(f"{words[0]}{suffix}")
    file, out = tmp_path / f"in{suffix}", tmp_path / "out.stl"
    for _ in range(12):
        file.write_bytes(spoilt(suffix, rng))
        command, *options = [str(out) if word == "OUT" else word for word in words]
        assert main(["mesh", command, str(file), *options]) in (0, 1, 2), capsys.readouterr().err
        assert set(os.listdir(tmp_path)) <= {file.name, out.name}
