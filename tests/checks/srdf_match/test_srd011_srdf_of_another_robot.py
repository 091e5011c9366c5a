"""SRD011: see the rule."""

from pathlib import Path

from tests.naming import naming
from tests.srdfs import findings
from urdfkit.text.diagnostic import Severity


def test_both_names_are_reported(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, "", "SRD011", name="other")
    assert finding.message == naming("other", "r")
    assert (finding.span.line, finding.span.text) == (1, "other")
    assert finding.severity is Severity.WARNING  # MoveIt logs it and goes on


def test_srdf_with_the_name_of_the_robot_is_used(tmp_path: Path) -> None:
    (tmp_path / "old.srdf").write_text('<robot name="old"/>')
    assert findings(tmp_path, "", "SRD011") == []
