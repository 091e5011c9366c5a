"""A file has one name in everything that a run prints, wherever it was read from."""

import json
import os
import re
from pathlib import Path

import pytest

from tests.workspaces import add_files
from tests.xacros import xacro
from urdfkit.cli import main
from urdfkit.lint.engine import check
from urdfkit.output import formats
from urdfkit.text.source import shown, shown_text, without_directory

#: A file that is named, one beside it, and one that is found by its package, each with a defect.
PARTS = {
    "arm/package.xml": '<package format="3"><name>arm</name></package>',
    "arm/urdf/arm.urdf.xacro": xacro(
        """<xacro:include filename="near.xacro"/>
        <xacro:include filename="$(find arm)/urdf/far.xacro"/>
        <link name="a"/><link name="a"/>"""
    ),
    "arm/urdf/near.xacro": xacro('<link name="b"/><link name="b"/>', ""),
    "arm/urdf/far.xacro": xacro(
        """<link name="c"><visual><geometry>
        <mesh filename="package://arm/meshes/no.stl"/></geometry></visual></link>
        <link name="c"/>""",
        "",
    ),
}
SPELLINGS = (
    "arm/urdf/arm.urdf.xacro",
    "./arm/urdf/arm.urdf.xacro",
    "arm/urdf/../urdf/arm.urdf.xacro",
)


@pytest.fixture
def directory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A workspace that is the current directory."""
    top = tmp_path.resolve() / "ws"
    add_files(top, PARTS)
    (top / ".git").mkdir()
    monkeypatch.chdir(top)
    return top


def test_how_a_path_is_shown(directory: Path) -> None:
    inside = directory / "arm" / "package.xml"
    assert {shown(str(inside)), shown("./arm/package.xml"), shown("arm/urdf/../package.xml")} == {
        os.path.join("arm", "package.xml")
    }
    outside = directory.parent / "other.urdf"
    assert shown("../other.urdf") == shown(str(outside)) == str(outside)
    assert shown("..odd.urdf") == "..odd.urdf"
    assert shown_text(f"tried {inside} and {outside}") == (
        f"tried {os.path.join('arm', 'package.xml')} and {outside}"
    )


@pytest.mark.parametrize("name", formats.names())
def test_every_format_names_files_alike(name: str, directory: Path) -> None:
    spellings = (*SPELLINGS, str(directory / SPELLINGS[0]))
    texts = {formats.get(name)(check(one, select=["NAM001", "MSH001"])) for one in spellings}
    (text,) = texts
    assert str(directory) not in text
    if name != "statistics":
        for part in ("arm/urdf/arm.urdf.xacro", "arm/urdf/far.xacro", "arm/urdf/near.xacro"):
            assert part in text


def test_findings_are_sorted_by_the_names_that_are_shown(directory: Path) -> None:
    for spelling in (*SPELLINGS, str(directory / SPELLINGS[0])):
        report = check(spelling, select=["NAM001"])
        paths = [shown(one.span.source.path) for one in report.diagnostics]
        assert paths == [
            f"arm/urdf/{name}" for name in ("arm.urdf.xacro", "far.xacro", "near.xacro")
        ]


def test_fix_names_files_alike(directory: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(["fix", str(directory / SPELLINGS[0]), "--select", "NAM001"])
    out = capsys.readouterr().out
    assert re.findall(r"left in (.*):", out) == [
        f"arm/urdf/{name}" for name in ("arm.urdf.xacro", "far.xacro", "near.xacro")
    ]


@pytest.mark.parametrize("form", ["html", "md", "json", "csv"])
@pytest.mark.parametrize("inside", [True, False])
def test_a_report_has_no_directory_of_its_author(
    form: str, inside: bool, directory: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not inside:
        (directory.parent / "elsewhere").mkdir()
        monkeypatch.chdir(directory.parent / "elsewhere")
    out = directory.parent / f"report.{form}"
    file = str(directory / SPELLINGS[0])
    assert main(["report", file, "-o", str(out), "--quick"]) == 0
    text = out.read_text(encoding="utf-8").replace("\\_", "_")
    assert str(directory) not in text
    assert "arm/urdf/far.xacro" in text
    if form == "json":
        assert json.loads(text)["file"] == "arm/urdf/arm.urdf.xacro"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "searched {0} and its parent directories, below {0} (1 package)",
            "searched . and its parent directories, below . (1 package)",
        ),
        ("AMENT_PREFIX_PATH ({0}:/opt/ros/jazzy)", "AMENT_PREFIX_PATH (.:/opt/ros/jazzy)"),
        ('pip install -e "{0}[dynamics]"', 'pip install -e "{0}[dynamics]"'),
        (
            'pip install "urdfkit @ file://{0}/urdfkit"',
            'pip install "urdfkit @ file://{0}/urdfkit"',
        ),
        ("{0}-old and {0}.d are others", "{0}-old and {0}.d are others"),
    ],
)
def test_the_current_directory_itself(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str, expected: str
) -> None:
    """Its absolute path differs between machines; a command to install something must work."""
    monkeypatch.chdir(tmp_path)
    assert shown_text(text.format(tmp_path)) == expected.format(tmp_path)


def test_a_page_keeps_its_tags_and_data() -> None:
    page = "<a>x</a> src='data:;base64,x+/a/b+/a='"
    assert without_directory(page, "/a") == page
