"""The diff command: options, formats by suffix, exit codes."""

import json
from pathlib import Path

import pytest

from tests.shipped import GRIPPER
from urdfkit.cli import main


@pytest.fixture
def new(tmp_path: Path) -> str:
    """The gripper with other efforts."""
    text = Path(GRIPPER).read_text(encoding="utf-8")
    assert 'effort="' in text
    file = tmp_path / "new.urdf"
    file.write_text(text.replace('effort="', 'effort="1'), encoding="utf-8")
    return str(file)


def test_text_on_standard_output(new: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["diff", GRIPPER, new]) == 1
    out = capsys.readouterr().out
    assert "limits\n  joint '" in out
    assert main(["diff", GRIPPER, GRIPPER]) == 0


def test_the_centre_of_mass_fits_a_terminal(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name, place in (("a", "-0.0123456 0.0123456 -0.0123456"), ("b", "-0.1234567 0 -0.1234567")):
        mass = f'<inertial><origin xyz="{place}"/><mass value="1"/></inertial>'
        text = f'<robot name="r"><link name="l">{mass}</link></robot>'
        (tmp_path / f"{name}.urdf").write_text(text, encoding="utf-8")
    assert main(["diff", str(tmp_path / "a.urdf"), str(tmp_path / "b.urdf")]) == 1
    total = capsys.readouterr().out.split("\n\n")[1].splitlines()
    assert total[2].startswith("  centre of mass  -0.01235 0.01235 -0.01235 -> -0.1235 0 ")
    assert " ".join(total).endswith("mm)")
    assert max(map(len, total)) <= 80


@pytest.mark.parametrize(
    ("words", "code"),
    [
        (["--fail-on", "any"], 1),
        (["--fail-on", "none"], 0),
        (["--fail-on", "links,frames"], 0),
        (["--fail-on", "links,limits"], 1),
        (["--tolerance", "limit=100"], 0),
    ],
)
def test_fail_on(new: str, words: list[str], code: int) -> None:
    assert main(["diff", GRIPPER, new, *words]) == code


def test_the_suffix_is_the_format(new: str, tmp_path: Path) -> None:
    assert main(["diff", GRIPPER, new, "-o", str(tmp_path / "d.json")]) == 1
    assert json.loads((tmp_path / "d.json").read_text())["kinds"] == ["limits"]
    assert main(["diff", GRIPPER, new, "-o", str(tmp_path / "d.md")]) == 1
    assert (tmp_path / "d.md").read_text().startswith("### urdfkit diff\n")


def test_the_configuration_applies_to_both(new: str, tmp_path: Path) -> None:
    inverted = Path(new).read_text().replace('lower="0"', 'lower="9"')
    Path(new).write_text(inverted)
    assert main(["diff", GRIPPER, new, "--fail-on", "findings"]) == 1
    (tmp_path / "urdfkit.toml").write_text('ignore = ["JNT"]\n')
    assert main(["diff", GRIPPER, new, "--fail-on", "findings"]) == 0
    assert main(["diff", GRIPPER, new, "--fail-on", "findings", "--isolated"]) == 1


@pytest.mark.parametrize(
    ("words", "error"),
    [
        ([GRIPPER], "expected two files"),
        ([GRIPPER, GRIPPER, GRIPPER], "expected two files"),
        ([GRIPPER, "none.urdf"], "none.urdf"),
        ([GRIPPER, GRIPPER, "-o", "x.doc"], "the suffix is not one of"),
        (
            [GRIPPER, GRIPPER, "--fail-on", "colour"],
            "--fail-on colour: write some of any, none, links",
        ),
        ([GRIPPER, GRIPPER, "--tolerance", "mass"], "--tolerance mass: write a number from 0"),
        ([GRIPPER, GRIPPER, "--tolerance", "mass=nan"], "--tolerance mass=nan: write a number"),
        ([GRIPPER, GRIPPER, "--tolerance", "links=1"], "--tolerance links=1: write one of mass"),
    ],
)
def test_usage_errors(words: list[str], error: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["diff", *words]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert error in captured.err


def test_html_in_chinese(new: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("jinja2")
    page = tmp_path / "diff.html"
    assert main(["diff", GRIPPER, new, "--lang", "zh", "-o", str(page)]) == 1
    text = page.read_text(encoding="utf-8")
    assert '<html lang="zh">' in text
    assert "<h2>限位</h2>" in text
    assert main(["diff", GRIPPER, new, "--lang", "zh"]) == 2
    assert "--lang is for HTML" in capsys.readouterr().err


@pytest.mark.parametrize("kind", ["html", "markdown"])
def test_a_page_contains_no_local_directory(tmp_path, capsys, kind):
    (tmp_path / ".git").mkdir()
    for name, mass in (("a", 1), ("b", -2)):
        (tmp_path / f"{name}.urdf").write_text(
            f'<robot name="r"><link name="l"><inertial><mass value="{mass}"/><inertia ixx="1" '
            'iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>'
        )
    main(["diff", str(tmp_path / "a.urdf"), str(tmp_path / "b.urdf"), "--format", kind])
    page = capsys.readouterr().out
    assert "b.urdf:1:" in page
    assert str(tmp_path) not in page
