"""A baseline tolerates what was there, under edits elsewhere, and nothing else."""

from pathlib import Path

import pytest

from urdfkit import check
from urdfkit.baseline import BaselineError, dump, fingerprints, load, sift
from urdfkit.diagnostic import Diagnostic

AXIS = '    <axis xyz="1 0 0"/>\n'
JOINT = """  <joint name="{name}" type="fixed">
    <parent link="{parent}"/>
    <child link="{name}_link"/>
{axis}  </joint>
  <link name="{name}_link"/>
"""


def robot(folder: Path, *joints: str, comment: str = "") -> tuple[Diagnostic, ...]:
    body = "".join(JOINT.format(name=name, parent="base", axis=AXIS) for name in joints)
    path = folder / "r.urdf"
    path.write_text(f'<robot name="r">\n{comment}  <link name="base"/>\n{body}</robot>\n')
    return check(path, select=["JNT020"]).diagnostics


def save(folder: Path, diagnostics: tuple[Diagnostic, ...]) -> str:
    path = folder / "baseline.json"
    path.write_text(dump(diagnostics, str(folder)))
    return str(path)


def test_what_was_there_is_tolerated_wherever_it_moves(tmp_path):
    known = load(save(tmp_path, robot(tmp_path, "a", "b")))
    moved = robot(tmp_path, "b", "a", comment="<!-- new -->\n\n")
    assert sift(moved, known, str(tmp_path)) == ([], 2)


def test_one_more_of_the_same_is_new(tmp_path):
    known = load(save(tmp_path, robot(tmp_path, "a", "b")))
    new, tolerated = sift(robot(tmp_path, "a", "b", "c"), known, str(tmp_path))
    assert tolerated == 2
    assert [diagnostic.element for diagnostic in new] == ["joint/c/axis"]


def test_the_same_findings_give_the_same_text(tmp_path):
    found = robot(tmp_path, "a", "b")
    assert dump(found, str(tmp_path)) == dump(reversed(found), str(tmp_path))


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"version": 9}', '{"version": 1}', "\x00"])
def test_another_file_is_refused_by_name(tmp_path, text):
    path = tmp_path / "b.json"
    path.write_text(text)
    with pytest.raises(BaselineError, match=r"b\.json"):
        load(str(path))


def test_a_missing_file_is_refused_by_name(tmp_path):
    with pytest.raises(BaselineError, match="there is no such file"):
        load(str(tmp_path / "none.json"))


def test_marks_are_stable_and_tell_equal_findings_apart(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    first = fingerprints(robot(tmp_path, "a", "b"))
    again = fingerprints(robot(tmp_path, "a", "b", comment="<!-- moved -->\n"))
    assert first == again
    assert len(set(first)) == 2
