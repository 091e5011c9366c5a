"""LAU003: see the rule."""

from urdfkit import check
from urdfkit.source import Source


def test_the_nearest_file_is_named(tmp_path):
    (tmp_path / "robot.yaml").write_text("a: 1")
    text = b'<launch><rosparam file="$(dirname)/robt.yaml"/></launch>'
    (finding,) = check(Source(str(tmp_path / "a.launch"), text)).diagnostics
    assert finding.code == "LAU003"
    assert "robt.yaml" in finding.message
    assert "'robot.yaml'" in finding.help


def test_a_file_that_is_there_is_calm(tmp_path):
    (tmp_path / "robot.yaml").write_text("a: 1")
    text = b'<launch><rosparam file="$(dirname)/robot.yaml"/></launch>'
    assert check(Source(str(tmp_path / "a.launch"), text)).diagnostics == ()
