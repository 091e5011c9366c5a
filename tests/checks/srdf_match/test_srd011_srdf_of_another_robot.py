"""SRD011: see the rule."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.srdfs import findings
from urdfkit import check
from urdfkit.text.diagnostic import Severity


def test_both_names_are_reported(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, "", "SRD011", name="other")
    assert finding.message == naming("other", "r")
    assert (finding.span.line, finding.span.text) == (1, "other")
    assert finding.severity is Severity.WARNING  # MoveIt logs it and goes on


def test_srdf_with_the_name_of_the_robot_is_used(tmp_path: Path) -> None:
    (tmp_path / "old.srdf").write_text('<robot name="old"/>')
    assert findings(tmp_path, "", "SRD011") == []


@pytest.mark.parametrize(
    ("robot", "named"), [("arm", "robot.srdf"), ("C:\\robots\\arm", "robot.urdf")]
)
def test_the_name_that_is_fixed(tmp_path: Path, robot: str, named: str) -> None:
    """onshape-to-robot on Windows writes the path of the directory as the name."""
    (tmp_path / "robot.urdf").write_text(f'<robot name="{robot}"><link name="base"/></robot>')
    (tmp_path / "robot.srdf").write_text('<robot name="robot"/>')
    (found,) = check(tmp_path / "robot.urdf", select=["SRD011"]).diagnostics
    assert found.fix is not None
    assert [edit.span.source.path.endswith(named) for edit in found.fix.edits] == [True]
