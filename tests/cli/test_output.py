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


def test_a_name_that_is_too_long_has_a_line_and_the_others_stay_in_their_column(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("COLUMNS", "40")
    values = "1.0 2.0 3.0 4.0 5.0"
    rows = [("base", values), ("a_link_with_a_very_long_name", values), ("", values)]
    assert list(output.two_columns([*rows, ("tip", values)])) == [
        f"base {values}",
        "a_link_with_a_very_long_name",
        f"     {values}",
        f"     {values}",
        f"tip  {values}",
    ]


def test_values_below_their_names_if_most_names_are_too_long(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("COLUMNS", "40")
    values = "1.0 2.0 3.0 4.0 5.0 6.0 7.0"
    rows = [("left_wheel_link", values), ("right_wheel_link", values), ("a", values)]
    assert list(output.two_columns(rows))[:2] == ["left_wheel_link", f"  {values}"]
