"""LAU001: see the rule."""

from urdfkit import check
from urdfkit.text.source import Source


def test_location_is_the_open_tag():
    report = check(Source("a.launch", b"<launch>\n  <node>\n</launch>"))
    (finding,) = report.diagnostics
    assert (finding.code, finding.span.line) == ("LAU001", 2)
    assert report.exit_code() == 1


def test_launch_file_is_not_a_robot():
    assert check(Source("a.launch", b"<launch/>")).diagnostics == ()
