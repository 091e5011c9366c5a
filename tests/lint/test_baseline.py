"""A baseline tolerates what was there, under edits elsewhere, and nothing else."""

import os
from collections import Counter
from pathlib import Path

import pytest

from urdfkit import check
from urdfkit.lint import rule_index
from urdfkit.lint.baseline import (
    BaselineError,
    Fingerprint,
    apply_baseline,
    dump,
    fingerprints,
    load,
)
from urdfkit.lint.report import Report

AXIS = '    <axis xyz="1 0 0"/>\n'
JOINT = """  <joint name="{name}" type="fixed">
    <parent link="{parent}"/>
    <child link="{name}_link"/>
{axis}  </joint>
  <link name="{name}_link"/>
"""


def robot(directory: Path, *joints: str, comment: str = "") -> Report:
    body = "".join(JOINT.format(name=name, parent="base", axis=AXIS) for name in joints)
    path = directory / "r.urdf"
    path.write_text(f'<robot name="r">\n{comment}  <link name="base"/>\n{body}</robot>\n')
    return check(path, select=["JNT020"])


def save(directory: Path, report: Report) -> str:
    path = directory / "baseline.json"
    path.write_text(dump(report, str(directory)))
    return str(path)


def sifted(report: Report, known: Counter[Fingerprint], directory: Path) -> tuple[list[str], int]:
    """The elements of what is new, and how much is tolerated."""
    now = apply_baseline(report, known, str(directory))
    return [found.element for found in now.diagnostics], now.tolerated


def test_findings_of_a_rule_with_another_code_now(tmp_path, monkeypatch):
    path = Path(save(tmp_path, robot(tmp_path, "a", "b")))
    path.write_text(path.read_text().replace("JNT020", "TRE999", 1))
    monkeypatch.setattr(rule_index, "_redirects", {"TRE999": "JNT020"})
    assert sifted(robot(tmp_path, "a", "b"), load(str(path)), tmp_path) == ([], 2)


def test_what_was_there_is_tolerated_wherever_it_moves(tmp_path):
    known = load(save(tmp_path, robot(tmp_path, "a", "b")))
    moved = robot(tmp_path, "b", "a", comment="<!-- new -->\n\n")
    assert sifted(moved, known, tmp_path) == ([], 2)


def test_what_was_there_is_tolerated_in_a_file_that_was_renamed(tmp_path):
    known = load(save(tmp_path, robot(tmp_path, "a", "b")))
    (tmp_path / "r.urdf").rename(tmp_path / "renamed.urdf")
    moved = check(tmp_path / "renamed.urdf", select=["JNT020"])
    assert sifted(moved, known, tmp_path) == ([], 2)
    # A copy is new: the file that had the findings is still there.
    robot(tmp_path, "a", "b")
    new, tolerated = sifted(moved, known, tmp_path)
    assert (len(new), tolerated) == (2, 0)


def test_one_more_of_the_same_is_new(tmp_path):
    known = load(save(tmp_path, robot(tmp_path, "a", "b")))
    now = robot(tmp_path, "a", "b", "c")
    assert sifted(now, known, tmp_path) == (["joint/c/axis"], 2)


def test_the_same_findings_give_the_same_text(tmp_path):
    found = robot(tmp_path, "a", "b")
    turned = found._replace(diagnostics=found.diagnostics[::-1])
    assert dump(found, str(tmp_path)) == dump(turned, str(tmp_path))


def test_the_file_is_as_projects_have_committed_it(tmp_path):
    text = (
        '{\n "version": 1,\n "findings": [\n  {\n   "path": "r.urdf",\n   "code": "JNT020",\n'
        '   "text": "<axis xyz=\\"1 0 0\\"/>",\n   "count": 2\n  }\n ]\n}\n'
    )
    found = robot(tmp_path, "轮", "b")
    assert dump(found, str(tmp_path)) == text
    assert sifted(found, load(save(tmp_path, found)), tmp_path) == ([], 2)


def test_a_later_version_is_refused(tmp_path):
    path = tmp_path / "b.json"
    path.write_text('{"version": 2, "findings": []}')
    with pytest.raises(BaselineError, match=r"b\.json: a baseline of version 2, not 1; write"):
        load(str(path))


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"version": 1}', "\x00", "[" * 100_000])
def test_another_file_is_refused_by_name(tmp_path, text):
    path = tmp_path / "b.json"
    path.write_text(text)
    with pytest.raises(BaselineError, match=r"b\.json"):
        load(str(path))


def test_a_missing_file_is_refused_by_name(tmp_path):
    with pytest.raises(BaselineError, match="file not found"):
        load(str(tmp_path / "none.json"))


def test_marks_are_stable_and_tell_equal_findings_apart(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    first = fingerprints(robot(tmp_path, "a", "b").diagnostics)
    again = fingerprints(robot(tmp_path, "a", "b", comment="<!-- moved -->\n").diagnostics)
    assert first == again
    assert [mark.partition(":")[2] for mark in first] == ["1", "2"]
    assert len({mark.partition(":")[0] for mark in first}) == 1


def test_a_name_that_is_no_text_has_a_mark(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = robot(tmp_path, "a").diagnostics
    os.rename("r.urdf", b"\xff.urdf")
    (mark,) = fingerprints(check(os.fsdecode(b"\xff.urdf"), select=["JNT020"]).diagnostics)
    assert mark != fingerprints(found)[0]


UNDEFINED = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wheel" params=""><link name="wheel"/></xacro:macro>
  <link name="base"/><wheel/>
  <joint name="j" type="fixed"><parent link="base"/><child link="wheel"/></joint>
  {more}
</robot>
"""
MORE = '<joint name="k" type="fixed"><parent link="base"/><child link="lost"/></joint>'


def test_a_tolerated_cause_silences_nothing(tmp_path: Path) -> None:
    path = tmp_path / "r.xacro"
    path.write_text(UNDEFINED.format(more=""))
    report = check(path, select=["XAC002", "REF001"])
    assert [found.code for found in report.diagnostics] == ["XAC002"]
    known = load(save(tmp_path, report))
    assert apply_baseline(report, known, str(tmp_path)).diagnostics == ()
    path.write_text(UNDEFINED.format(more=MORE))
    now = check(path, select=["XAC002", "REF001"])
    assert [found.code for found in now.diagnostics] == ["XAC002"]
    (new,) = apply_baseline(now, known, str(tmp_path)).diagnostics
    assert (new.code, new.span.line) == ("REF001", 5)
