"""A robot with one sensor, for the tests of the rules about sensors."""

from urdfkit import Diagnostic, check
from urdfkit.text.source import Source

ROBOT = """<robot name="r">
<link name="base"><inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<collision><geometry><sphere radius="1"/></geometry></collision></link>
<link name="tip"><inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<collision name="end"><geometry><sphere radius="1"/></geometry></collision></link>
<joint name="wrist" type="fixed"><parent link="base"/><child link="tip"/></joint>
<gazebo reference="{reference}">{beside}<sensor name="s" type="{type}">
{inner}
</sensor></gazebo>
</robot>
"""


def findings(
    code: str,
    type: str,
    inner: str = "",
    *,
    reference: str = "base",
    beside: str = "",
    targets: tuple[str, ...] = (),
) -> list[Diagnostic]:
    """What one rule says about a sensor; ``inner`` begins in line 10."""
    text = ROBOT.format(reference=reference, beside=beside, type=type, inner=inner)
    return list(check(Source("r.urdf", text.encode()), select=[code], targets=targets).diagnostics)


def scan(
    first: float, last: float, samples: int = 360, least: float = 0.1, most: float = 10
) -> str:
    """The settings of a lidar."""
    return (
        f"<ray><scan><horizontal><samples>{samples}</samples><min_angle>{first}</min_angle>\n"
        f"<max_angle>{last}</max_angle></horizontal></scan>\n"
        f"<range><min>{least}</min><max>{most}</max></range></ray>"
    )
