"""SRD018: see the rule."""

from pathlib import Path

from tests.srdfs import findings
from urdfkit import check


def test_the_slip_is_told_where_it_is(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, '<group name="g">', "SRD018")
    assert finding.span.source.path == str(tmp_path / "r.srdf")
    assert (finding.span.line, finding.span.text) == (2, '<group name="g">')


def test_one_of_several_that_has_another_name_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "other.srdf").write_text("<robot")
    assert findings(tmp_path, "", "SRD018") == []
    (tmp_path / "r.srdf").write_text("<robot")
    assert len(check(tmp_path / "r.urdf", select=["SRD018"]).diagnostics) == 1


def test_a_sound_one_is_calm(tmp_path: Path) -> None:
    assert findings(tmp_path, '<group name="g"><link name="arm"/></group>', "SRD018") == []
