"""A joint is faster than the drives of our arms.

They turn with 3.14 rad/s at most. A planner that reads a higher limit plans motions which the arm
follows late, and the controller then stops it for its position error. Write the true limit.
"""

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Attribute

#: Of our drives, in rad/s.
FASTEST = 3.14

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="shoulder" type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <limit lower="-1" upper="1" effort="40" velocity="6"/>
</joint>
"""
GOOD = BAD.replace('velocity="6"', 'velocity="2"')
FIXED = BAD.replace('velocity="6"', 'velocity="3.14"')


@rule(Severity.WARNING, help="write the limit of the drive")
def check(context: Context) -> Findings:
    for joint in context.model.joints:
        if joint.kind != "revolute" or joint.limit is None or joint.limit.velocity is None:
            continue
        velocity = joint.limit.velocity
        if velocity.value > FASTEST:
            message = f"joint '{joint.name}': {velocity.value:g} rad/s is over {FASTEST:g} rad/s"
            yield Finding(velocity, message, fix=_fix(velocity.at))


def _fix(at: object) -> Fix | None:
    """Only where the file holds the number itself, not an expression that gave it."""
    if isinstance(at, Attribute) and at.literal:
        return Fix(f"write {FASTEST:g}", (Edit(at.span, f"{FASTEST:g}"),))
    return None
