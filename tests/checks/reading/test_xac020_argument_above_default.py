"""XAC020: xacro stops at such a use; here the default counts, so that the rest is checked."""

from urdfkit import check
from urdfkit.text.source import Source

ROBOT = b"""<robot name="$(arg name)" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="name" default="arm"/>
  <link name="$(arg name)_base"/>
</robot>
"""


def test_the_first_use_is_reported_and_the_rest_is_checked():
    report = check(Source("arm.xacro", ROBOT), select=["XAC", "TRE"])
    (finding,) = report.diagnostics
    assert (finding.code, finding.severity.value) == ("XAC020", "error")
    assert (finding.span.line, finding.span.column, finding.span.text) == (1, 14, "$(arg name)")
    assert [related.span.line for related in finding.related] == [2]
    assert report.skipped == ()


def test_a_value_that_is_passed_is_no_finding():
    report = check(Source("arm.xacro", ROBOT), arguments={"name": "robot"}, select=["XAC"])
    assert report.diagnostics == ()
