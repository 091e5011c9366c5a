"""A joint does not move in simulation.

Only with `--simulate`, which runs the tests of `urdfkit simulate` in MuJoCo:

- Links collide when the joint moves from its start by 0.1 rad or 20 mm to either side, in its
  initial pose and in 20 random poses of the other joints: it is jammed. Correct its range, its
  origin, or the collisions.
- Driven by its whole `effort` for a second without gravity, the joint reaches neither a tenth of
  its velocity nor 0.1 rad/s or m/s: inertia or damping is too large, or the effort too small. Or it
  is thrown: what it moves has no mass to speak of.
- A joint with `<mimic>` does not follow its leader.

Friction that exceeds the effort is JNT041, an effort of zero JNT008, a mimic joint with too small a
range JNT016.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    MuJoCo, equality constraints: https://mujoco.readthedocs.io/en/stable/computation/index.html#coequality
"""

from urdfkit.checks.simulation.reported import findings
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule
from urdfkit.robot.samples import collision_xml, inertial_xml, joint_xml, link_xml, robot_xml

_BOX = collision_xml('<box size="0.1 0.1 0.1"/>')
BAD = robot_xml(
    link_xml("base", collision_xml('<box size="0.1 0.1 0.1"/>', '<origin xyz="0 0 -1"/>')),
    link_xml("back", _BOX),
    link_xml("front", _BOX),
    link_xml("cart", inertial_xml("1", "0.002 0.002 0.002"), _BOX),
    joint_xml("fixed", '<origin xyz="-0.11 0 0"/>', name="back", child="back"),
    joint_xml("fixed", '<origin xyz="0.11 0 0"/>', name="front", child="front"),
    joint_xml(
        "prismatic",
        '<axis xyz="1 0 0"/>',
        '<limit lower="-2" upper="2" effort="100" velocity="1"/>',
        name="slide",
        child="cart",
    ),
)
GOOD = BAD.replace("0.11 0 0", "0.15 0 0")


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.SIMULATION),
    help="correct its range, its effort, or what it collides with (urdfkit simulate)",
)
def check(context: Context) -> Findings:
    yield from findings(context, "SIM002")
