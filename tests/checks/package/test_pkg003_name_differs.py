from __future__ import annotations

from pathlib import Path

import pytest

from urdfkit import Diagnostic, check

ROBOT = """<robot name="r"><link name="base">
<visual><geometry><mesh filename="package://arm/a.stl"/></geometry></visual>
</link></robot>"""


def reported(folder: Path, build: str, file: str = "CMakeLists.txt") -> list[Diagnostic]:
    (folder / "package.xml").write_text("<package><name>arm</name></package>")
    (folder / file).write_text(build)
    (folder / "r.urdf").write_text(ROBOT)
    report = check(folder / "r.urdf", select=["PKG003"])
    assert report.crashed == ()
    return list(report.diagnostics)


@pytest.mark.parametrize(
    ("file", "build"),
    [
        ("CMakeLists.txt", "# project(arm)\nproject(amr VERSION 1.0)\n"),
        ("CMakeLists.txt", 'PROJECT (\n  "amr")\n'),
        ("setup.py", "from setuptools import setup\npackage_name = 'amr'\n"),
    ],
)
def test_another_name(tmp_path: Path, file: str, build: str) -> None:
    (found,) = reported(tmp_path, build, file)
    assert found.message == f"{file} calls the package 'amr', and package.xml calls it 'arm'"
    assert found.span.source.path == str(tmp_path / file)
    assert found.span.text == "amr"


@pytest.mark.parametrize(
    "build", ["project(arm)", "project(${NAME})", "", "# no project here", "myproject(amr)"]
)
def test_the_same_name_or_none_that_is_written_out(tmp_path: Path, build: str) -> None:
    assert reported(tmp_path, build) == []
