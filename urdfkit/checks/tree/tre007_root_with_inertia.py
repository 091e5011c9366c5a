"""The root link has a mass.

KDL, and with it MoveIt's kinematics and every controller that uses KDL, has no body for the root:
it warns and ignores the root's inertia. Simulators do not ignore it. If KDL needs the inertia, add
an empty link above the root and connect the root to it with a fixed joint.

Sources:
    kdl_parser: https://github.com/ros/kdl_parser/blob/noetic-devel/kdl_parser/src/kdl_parser.cpp
    ros/kdl_parser#27: https://github.com/ros/kdl_parser/issues/27
"""

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.link import Link
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import inertial_xml, joint_xml, link_xml, robot_xml
from urdfkit.text.editing.edits import from_macro, insert_before

BAD = link_xml("base", inertial_xml("2", "0.01 0.01 0.02"))
FIXED = GOOD = robot_xml(
    link_xml("base_root"),
    joint_xml("fixed", name="base_root_joint", parent="base_root", child="base"),
    BAD,
)
TARGETS = ("kdl",)


@rule(
    Severity.INFO,
    help="for KDL, add an empty link above it with a fixed joint",
    reports_missing=True,
)
def check(context: Context) -> Findings:
    if context.given_targets and not context.targets.that("builds_kdl"):
        return
    roots = context.tree.roots
    if len(roots) != 1 or roots[0].inertial is None:
        return
    root = roots[0]
    mass = roots[0].inertial.mass
    if mass is None or mass.value > 0:
        yield Finding(
            roots[0].inertial.at,
            f"root link '{root.name}' has "
            + (f"{mass.value:g} kg" if mass else "an inertia")
            + ", which KDL ignores",
            # For other programs, such as Gazebo, a new root would change more than it fixes.
            fix=_empty_root(root, context.model) if "kdl" in context.given_targets else None,
        )


def _empty_root(root: Link, model: RobotModel) -> Fix | None:
    """A massless link and a fixed joint above the root."""
    name = f"{root.name}_root"
    joint = f"{name}_joint"
    literal = root.at.attributes["name"].literal
    if (
        not literal
        or from_macro(root.at)
        or name in model.links_by_name
        or joint in model.joints_by_name
    ):
        return None
    lines = (
        f'<link name="{name}"/>',
        f'<joint name="{joint}" type="fixed">',
        f'  <parent link="{name}"/>',
        f'  <child link="{root.name}"/>',
        "</joint>",
    )
    return Fix(f"add an empty link '{name}' above '{root.name}'", insert_before(root.at, lines))
