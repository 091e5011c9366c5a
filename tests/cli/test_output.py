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


def test_errors_of_one_code_are_counted_after_the_first_ones() -> None:
    """Cassie has 34 joints without a velocity."""
    found = [(f"a.urdf:{number}", "no velocity", "JNT002") for number in range(1, 35)]
    lines = list(output.errors([*found, ("a.urdf:99", "no link", "")]))
    assert lines[0] == "  a.urdf:1: no velocity (JNT002)"
    assert lines[4:] == [
        "  a.urdf:5: no velocity (JNT002)",
        "  and 29 more (JNT002)",
        "  a.urdf:99: no link",
    ]
