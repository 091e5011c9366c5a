"""The robot gains energy or diverges in simulation.

Only with `--simulate`, which runs the tests of `urdfkit simulate` in MuJoCo. A robot that is
released without drives can only lose energy. It gains some if links overlap where they collide,
which pushes them apart (COL001), if a link is too light for what it carries (DYN005), or if a joint
has a negative damping (JNT008). The message states the gain, its bound and what removes it. An
error: in the first second, the robot jumps or explodes. Gains that lift it by less than a third of
its size are not reported.

A warning if the energy error of steps of 2 ms exceeds the kinetic energy, without contacts, damping
and limits: simulate with shorter steps, or correct the masses and inertias.

Sources:
    MuJoCo, energy: https://mujoco.readthedocs.io/en/stable/APIreference/APItypes.html#mjtenablebit
    MuJoCo, contacts: https://mujoco.readthedocs.io/en/stable/computation/index.html#soco
"""

from urdfkit.checks.simulation.reported import findings
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule
from urdfkit.robot.samples import collision_xml, inertial_xml, joint_xml, link_xml, robot_xml

_LIMIT = '<limit lower="-3" upper="3" effort="100" velocity="1"/>'
_BOX = (inertial_xml("50", "2 2 2"), collision_xml('<box size="0.5 0.5 0.5"/>'))
BAD = robot_xml(
    link_xml("world"),
    link_xml("left", *_BOX),
    link_xml("right", *_BOX),
    joint_xml(
        "prismatic", '<axis xyz="1 0 0"/>', _LIMIT, name="left", parent="world", child="left"
    ),
    joint_xml(
        "prismatic",
        '<origin xyz="0.1 0 0"/>',
        '<axis xyz="1 0 0"/>',
        _LIMIT,
        name="right",
        parent="world",
        child="right",
    ),
)
GOOD = BAD.replace("0.1 0 0", "0.6 0 0")


@rule(
    Severity.ERROR,
    needs=(Need.MODEL, Need.SIMULATION),
    help="separate the links, correct masses and inertias, or shorten the step (urdfkit simulate)",
)
def check(context: Context) -> Findings:
    yield from findings(context, "SIM001")
