"""``mesh info`` and ``mesh repair`` of shells that overlap and of sheets with two sides."""

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("manifold3d")

from urdfkit.cli import main
from urdfkit.mesh.samples import box, stl

NESTED = stl([*box((0, 0, 0), (1, 1, 1)), *box((0.2, 0.2, 0.2), (0.8, 0.8, 0.8))])
HALF = box((0, 0, 0), (1, 1, 1))[2:]
SHEET = stl([*HALF, *(face[::-1] for face in HALF)])


@pytest.mark.parametrize(
    ("data", "what", "option"),
    [
        (NESTED, "bodies that overlap: the volume is 22 % too large", "--union"),
        (SHEET, "20 triangles of double-sided sheets without volume", "--one-sided"),
    ],
)
def test_a_double_sided_mesh_is_reported_and_repaired(
    data: bytes, what: str, option: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = str(tmp_path / "a.stl")
    Path(file).write_bytes(data)
    assert main(["mesh", "info", file]) == 0
    reported = capsys.readouterr().out
    assert f"surface {what}" in " ".join(reported.split())
    assert "a solid" not in reported
    assert main(["mesh", "repair", file]) == 1
    reported = " ".join(capsys.readouterr().out.split())
    assert reported.startswith(f"not repaired: {what}")
    assert option in reported
    assert main(["mesh", "repair", file, option, "--write"]) == 0
    capsys.readouterr()
    assert main(["mesh", "repair", file]) == 0
    assert "nothing to repair" in capsys.readouterr().out
