"""LAU017: see the rule."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST, launch
from urdfkit import Diagnostic, check

NODE = '<node name="n" pkg="{}" type="t"/>'


def reported(folder: Path, text: str, depends: str = "") -> list[Diagnostic]:
    for name in ("arm", "hand"):
        (folder / name).mkdir()
        own = MANIFEST.replace("<name>arm", f"<name>{name}")
        (folder / name / "package.xml").write_text(
            own.replace("</package>", f"{depends}</package>")
        )
    (folder / "hand" / "b.launch").write_text(launch(NODE.format("hand")))
    (folder / "arm" / "a.launch").write_text(launch(text))
    report = check(folder / "arm" / "a.launch", select=["LAU017"])
    assert report.crashed == ()
    return list(report.diagnostics)


@pytest.mark.parametrize("text", [NODE.format("hand"), '<include file="$(find hand)/b.launch"/>'])
def test_a_package_that_is_there_by_chance(tmp_path: Path, text: str) -> None:
    (found,) = reported(tmp_path, text)
    assert found.message.startswith("package 'hand' is used but not declared in ")
    assert found.help == "add <exec_depend>hand</exec_depend> to package.xml"
    assert found.span.line == 2


@pytest.mark.parametrize(
    ("name", "depends"),
    [
        ("hand", "<exec_depend>hand</exec_depend>"),
        ("hand", "<depend>hand</depend>"),
        ("arm", ""),
        ("rviz", ""),
        ("not_there", ""),
    ],
)
def test_declared_known_or_not_there_is_calm(tmp_path: Path, name: str, depends: str) -> None:
    assert reported(tmp_path, NODE.format(name), depends) == []
