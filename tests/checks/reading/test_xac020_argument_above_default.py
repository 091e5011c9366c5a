"""XAC020: xacro stops at such a use; here the default counts, so that the rest is checked."""

from tests.naming import naming
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


def test_a_parameter_of_the_macro_that_is_written_as_an_argument():
    """realsense2_description: the macro of one camera, and the argument of the next one."""
    text = b"""<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:macro name="camera" params="plug:=false"><link name="a$(arg plug)"/></xacro:macro>
<xacro:camera/><xacro:arg name="plug" default="1"/></robot>"""
    (finding,) = check(Source("arm.xacro", text), select=["XAC020"]).diagnostics
    assert finding.help == naming("${plug}", "macro")
