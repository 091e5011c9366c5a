"""The robot does not come to rest on the floor when it is dropped.

Only with `--simulate`, which runs the tests of `urdfkit simulate` in MuJoCo. A robot that stands on
wheels or feet is dropped from 50 mm with its joints locked. It sinks into the floor by more than
20 mm, still jitters after 6 s, or tips over though it stands on wheels or casters. Causes are
masses that are wrong by orders of magnitude, such as grams in place of kilograms, and collisions
that meet the ground at an edge. A centre of mass that is not above the wheels is DYN004.

Sources:
    MuJoCo, contacts: https://mujoco.readthedocs.io/en/stable/computation/index.html#soco
"""

from urdfkit.checks.simulation.reported import findings
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule
from urdfkit.robot.samples import collision_xml, inertial_xml, joint_xml, link_xml, robot_xml


def _wheel(name: str, y: str) -> str:
    return robot_xml(
        link_xml(name, inertial_xml("0.2", "0.0002 0.0002 0.0002"), *_BALL),
        joint_xml(
            "continuous", f'<origin xyz="0 {y} 0"/>', '<axis xyz="0 1 0"/>', name=name, child=name
        ),
    )


_BALL = (collision_xml('<sphere radius="0.05"/>'),)
GOOD = robot_xml(
    link_xml(
        "base", inertial_xml("2", "0.01 0.01 0.01"), collision_xml('<box size="0.3 0.1 0.04"/>')
    ),
    _wheel("left", "0.1"),
    _wheel("right", "-0.1"),
)
BAD = GOOD.replace('mass value="2"', 'mass value="10000"')


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.SIMULATION),
    help="correct the masses, or the collisions that touch the ground (urdfkit simulate)",
)
def check(context: Context) -> Findings:
    yield from findings(context, "SIM003")
