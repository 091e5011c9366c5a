"""XAC023: see the rule."""

import pytest

from urdfkit import check
from urdfkit.robot.samples import xacro_xml
from urdfkit.text.source import Source


@pytest.mark.parametrize(
    ("condition", "count"),
    [
        ("${camera == 'true'}", 1),
        ("${camera == 'True'}", 1),
        ("${(camera != 'false')}", 1),
        ("${camera}", 0),
        ("${camera == True}", 0),
        ("${camera == 'true' or camera == True}", 0),
        ("${'$(arg camera)' == 'true'}", 0),
        ("${kind == 'true'}", 0),  # which is text
        ("${camera == 'zed'}", 0),
    ],
)
@pytest.mark.parametrize("tag", ["if", "unless"])
def test_conditions(condition: str, count: int, tag: str) -> None:
    text = xacro_xml(
        '<xacro:arg name="camera" default="true"/>',
        '<xacro:property name="camera" value="$(arg camera)"/>',
        """<xacro:property name="kind" value="'true'"/>""",
        '<link name="base_${camera}${kind}"/>',
        f'<xacro:{tag} value="{condition}"><gazebo/></xacro:{tag}>',
        f'<!-- <xacro:if value="{condition}"/> -->',
    )
    report = check(Source("r.xacro", text.encode()), select=["XAC023"])
    assert len(report.diagnostics) == count


def test_parameters_of_macros() -> None:
    macro = """<xacro:macro name="m" params="sim"><xacro:if value="${{sim == 'true'}}">
<gazebo/></xacro:if></xacro:macro><link name="base"/><xacro:m sim="{}"/>"""
    for value, count in (("true", 1), ("'true'", 0)):
        source = Source("r.xacro", xacro_xml(macro.format(value)).encode())
        assert len(check(source, select=["XAC023"]).diagnostics) == count
