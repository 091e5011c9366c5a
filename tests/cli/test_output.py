"""Standard output and standard error."""

from pathlib import Path

import pytest

from urdfkit.cli import output
from urdfkit.text.editing.diff import diff


def test_a_diff_of_files_elsewhere_says_where_patch_takes_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """``patch`` ignores "potentially dangerous" absolute names."""
    (tmp_path / "urdf").mkdir()
    (tmp_path / "parts").mkdir()
    changes = "".join(
        diff(str(tmp_path / name), b"a\n", b"b\n") for name in ("urdf/r.urdf", "parts/p.xacro")
    )
    output.write_diff(changes)
    assert (
        capsys.readouterr().err == f"note: patch rejects absolute paths: run this in {tmp_path}\n"
    )
    monkeypatch.chdir(tmp_path)
    output.write_diff(diff(str(tmp_path / "urdf" / "r.urdf"), b"a\n", b"b\n"))
    assert capsys.readouterr().err == ""
