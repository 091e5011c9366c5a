"""One macro gives links of different mass the same inertia tensor.

The tensor stands in the macro as numbers while the mass is a parameter: a wheel of 0.5 kg then
resists turning as much as a body of 8 kg. Gazebo spins such a wheel up as if it were a flywheel,
and gram-light links make the solver unstable. Compute the tensor from mass and size in the macro:
for a box of x, y, z it is `ixx="${mass / 12 * (y*y + z*z)}"`, for a cylinder about z
`ixx="${mass / 12 * (3*r*r + l*l)}"` and `izz="${mass / 2 * r*r}"`, for a sphere
`ixx="${2 / 5 * mass * r*r}"`.

Sources:
    Gazebo Classic, inertia: https://classic.gazebosim.org/tutorials?tut=inertia
    Moments of inertia: https://en.wikipedia.org/wiki/List_of_moments_of_inertia
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, Need, rule
from urdfkit.robot.inertials.macro_fixes import computing
from urdfkit.robot.model import Link
from urdfkit.text.diagnostic import Related, Severity
from urdfkit.text.document import Step, Tag

BAD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="inertial" params="mass">
    <inertial>
      <mass value="${mass}"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
    </inertial>
  </xacro:macro>
  <link name="base">
    <collision><geometry><sphere radius="0.2"/></geometry></collision>
    <xacro:inertial mass="8"/>
  </link>
  <link name="ball">
    <collision><geometry><sphere radius="0.05"/></geometry></collision>
    <xacro:inertial mass="0.5"/>
  </link>
  <joint name="axle" type="continuous"><parent link="base"/><child link="ball"/></joint>
</robot>
"""
GOOD = BAD.replace('"0.1"', '"${mass * 0.0125}"')
FIXED = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <!-- Inertial of a uniform sphere; kg and m -->
  <xacro:macro name="sphere_inertial" params="mass radius xyz:='0 0 0' rpy:='0 0 0'">
    <inertial>
      <origin xyz="${xyz}" rpy="${rpy}"/>
      <mass value="${mass}"/>
      <inertia ixx="${2 / 5 * mass * radius*radius}" ixy="0" ixz="0"
               iyy="${2 / 5 * mass * radius*radius}" iyz="0"
               izz="${2 / 5 * mass * radius*radius}"/>
    </inertial>
  </xacro:macro>
  <link name="base">
    <collision><geometry><sphere radius="0.2"/></geometry></collision>
    <xacro:sphere_inertial mass="8" radius="0.2"/>
  </link>
  <link name="ball">
    <collision><geometry><sphere radius="0.05"/></geometry></collision>
    <xacro:sphere_inertial mass="0.5" radius="0.05"/>
  </link>
  <joint name="axle" type="continuous"><parent link="base"/><child link="ball"/></joint>
</robot>
"""


@rule(
    Severity.WARNING,
    needs=(Need.XACRO, Need.MODEL),
    help="compute ixx ... izz in the macro from mass and size (urdfkit explain XAC014)",
)
def check(subject: Subject) -> Findings:
    for tag, links in subject.masses.shared_by_macro.items():
        finding = _finding(links, sorted(filter(None, (link.mass for link in links))), tag)
        yield finding._replace(fix=computing(subject, links, tag))


def _finding(links: list[Link], masses: list[float], tag: Tag) -> Finding:
    calls = [(link, step) for link in links if (step := _innermost_call(link, tag))]
    macro = calls[0][1]
    assert macro.definition is not None
    written = tag.attribute_spans()  # in which a moment may be missing: urdfdom takes it for 0
    moments = ", ".join(written[key].text for key in ("ixx", "iyy", "izz") if key in written)
    return Finding(
        Location(macro.definition),
        f"macro '{macro.name}' gives {len(links)} links of {masses[0]:g} to {masses[-1]:g} kg "
        f"the same inertia tensor ({moments} kg m^2)",
        related=tuple(
            Related(step.span, f"link '{link.name}' of {link.mass:g} kg") for link, step in calls
        ),
    )


def _innermost_call(link: Link, tag: Tag) -> Step | None:
    """The macro call that gave a link the tensor."""
    tensor = link.inertial.at.child("inertia") if link.inertial else None
    return tensor.via[-1] if tensor is not None and tensor.tag_at == tag else None
