"""Fixes and ignore comments: what they are worth is that the finding is gone."""

from pathlib import Path

import pytest

from tests.conftest import MISSION
from tests.lsp.edited import Edited
from urdfkit.lsp.actions import actions
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.editing.apply import apply_edits


def found(file: Edited) -> list[Diagnostic]:
    file.workspace.check(file.path)
    return file.workspace.diagnostics(file.path)


@pytest.mark.parametrize("code", ["XAC007", "URD008", "MSH001", "GEO004", "TRE008", "GEO009"])
def test_a_comment_accepts_the_finding_and_no_other(code: str) -> None:
    file = Edited(MISSION, MISSION.read_text(encoding="utf-8"))
    before = found(file)
    diagnostic = next(one for one in before if one.code == code)
    *_, action = actions(file.markup, diagnostic)
    assert action.title == f"Suppress {code} here with a comment"
    file.type(apply_edits(file.markup.source.data, action.edits).decode())
    gone = [one.message for one in before]
    for left in found(file):
        gone.remove(left.message)
    assert gone == [diagnostic.message]


def test_a_comment_stands_on_a_line_of_its_own(tmp_path: Path) -> None:
    text = '<robot name="r">\r\n\t<link name="a"/>\r\n\t<link name="a"/>\r\n</robot>\r\n'
    file = Edited(tmp_path / "r.urdf", text)
    diagnostic = next(one for one in found(file) if one.code == "NAM001")
    (action,) = actions(file.markup, diagnostic)
    assert apply_edits(file.markup.source.data, action.edits).decode() == text.replace(
        '\r\n\t<link name="a"/>\r\n</',
        '\r\n\t<!-- urdfkit: ignore[NAM001] -->\r\n\t<link name="a"/>\r\n</',
    )


def test_the_root_is_not_accepted_as_a_whole(tmp_path: Path) -> None:
    file = Edited(tmp_path / "r.urdf", '<robot name="r"></robot>')
    (diagnostic,) = [one for one in found(file) if one.code == "TRE001"]
    assert list(actions(file.markup, diagnostic)) == []


def test_the_fix_comes_first_and_is_preferred_if_it_is_safe(tmp_path: Path) -> None:
    file = Edited(MISSION, MISSION.read_text(encoding="utf-8"))
    diagnostic = next(one for one in found(file) if one.code == "XAC007")
    fix, _ = actions(file.markup, diagnostic)
    assert diagnostic.fix is not None
    assert (fix.edits, fix.preferred) == (diagnostic.fix.edits, diagnostic.fix.safe)
    assert fix.title == "Use the built-in pi"
    file.type(apply_edits(file.markup.source.data, fix.edits).decode())
    assert "XAC007" not in {one.code for one in found(file)}
