"""Warnings of numpy and other libraries are findings or silence, whatever the vertices are."""

import warnings
from collections.abc import Callable
from math import inf, nan
from pathlib import Path

import pytest

from tests.mesh.made import ascii_stl
from urdfkit.cli import main
from urdfkit.mesh.samples import BOX, collada

pytest.importorskip("manifold3d")
pytestmark = pytest.mark.usefixtures("rough_meshes")

Corners = list[list[float]]


def obj(corners: Corners) -> str:
    lines = ["v {!r} {!r} {!r}".format(*corner) for corner in corners]
    return "\n".join([*lines, *("f {} {} {}".format(*(i + 1 for i in face)) for face in BOX)])


def ply(corners: Corners) -> str:
    head = "ply\nformat ascii 1.0\nelement vertex 8\n"
    head += "".join(f"property double {axis}\n" for axis in "xyz")
    head += "element face 12\nproperty list uchar int vertex_indices\nend_header\n"
    lines = ["{!r} {!r} {!r}".format(*corner) for corner in corners]
    return head + "\n".join([*lines, *("3 {} {} {}".format(*face) for face in BOX)]) + "\n"


def stl(corners: Corners) -> str:
    return ascii_stl([[corners[i] for i in face] for face in BOX]).decode()


def dae(corners: Corners) -> str:
    values = " ".join(repr(value) for corner in corners for value in corner)
    triangles = " ".join(str(i) for face in BOX for i in face)
    text = collada().decode()
    for old, new in (
        ('count="9">0 0 0 1 0 0 0 1 0', f'count="24">{values}'),
        ('source="#numbers" count="3"', 'source="#numbers" count="8"'),
        ('material="wood" count="1"', 'material="wood" count="12"'),
        ("<p>0 1 2</p>", f"<p>{triangles}</p>"),
    ):
        assert old in text
        text = text.replace(old, new)
    return text


COMMANDS = [
    "info FILE",
    "convert FILE out.obj --scale 1e300",
    "convert FILE out.dae --upright",
    "convert FILE out.glb",
    "convert FILE out.ply",
    "convert FILE out.stl",
    "repair FILE -o out.stl",
    "simplify FILE --triangles 6 -o out.stl",
    "simplify FILE --error 0.01 -o out.stl",
    "hull FILE -o out.stl",
    "decompose FILE -o out.obj",
]
#: What one corner of a box has for a coordinate, and what all corners are multiplied with.
VALUES = [nan, inf, -inf, 1e38, 1e308, 9e8, 5e-324, 1e-160, 0.0, 1.0]
CASES = [(obj, value) for value in VALUES] + [(w, v) for w in (ply, stl, dae) for v in (nan, 1e308)]


@pytest.mark.parametrize(("write", "value"), CASES)
@pytest.mark.parametrize("everywhere", [False, True], ids=["one", "all"])
def test_no_command_warns(
    write: Callable[[Corners], str],
    value: float,
    everywhere: bool,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    corners = [[float(n >> 2 & 1), float(n >> 1 & 1), float(n & 1)] for n in range(8)]
    if everywhere:
        corners = [[x * value for x in corner] for corner in corners]
    else:
        corners[7][2] = value
    file = f"box.{write.__name__}"
    Path(file).write_text(write(corners))
    for command in COMMANDS:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            code = main(["mesh", *command.replace("FILE", file).split(), *_force(command)])
        out, error = capsys.readouterr()
        assert code in (0, 1, 2), (command, error)
        assert ("Warning" in out + error, error.count("\n")) == (False, code // 2), command


def _force(command: str) -> list[str]:
    return [] if command.startswith("info") else ["--force"]
