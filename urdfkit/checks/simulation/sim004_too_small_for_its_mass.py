"""The whole robot is far too small for its mass.

Only with `--simulate`, which assembles the robot with all of its meshes. Its mass divided by the
cube of its size exceeds 1e6 kg/m³, where osmium has 22,590 and no robot fills the cube: its lengths
are a thousand times too small, such as those of meshes in mm with two scales of 0.001. A simulator
throws such a robot, since its inertias are as small. Correct the `scale` of the meshes, and the
origins.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    Osmium: https://en.wikipedia.org/wiki/Osmium
"""

from urdfkit.checks.simulation.reported import findings
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule
from urdfkit.robot.samples import collision_xml, inertial_xml, joint_xml, link_xml, robot_xml


def _arm(size: str, at: str, moment: str) -> str:
    origin = f'<origin xyz="{at} 0 0"/>'
    return robot_xml(
        link_xml("world"),
        link_xml(
            "arm",
            inertial_xml("1", f"{moment} {moment} {moment}", origin),
            collision_xml(f'<box size="{size} {size} {size}"/>', origin),
        ),
        joint_xml(
            "revolute",
            '<axis xyz="0 1 0"/>',
            '<limit lower="-1" upper="1" effort="100" velocity="1"/>',
            parent="world",
        ),
    )


BAD = _arm("0.0001", "0.0005", "1e-9")
GOOD = _arm("0.1", "0.5", "0.002")


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.SIMULATION),
    help="correct the scale of the meshes and the lengths (urdfkit info)",
)
def check(context: Context) -> Findings:
    yield from findings(context, "SIM004")
