"""Links of different mass have the same inertia tensor.

A tensor is proportional to the mass: of two links with the same shape, the link of twice the mass
has twice the moments. At most one of the links moves correctly in a simulation: a wheel of 0.5 kg
with the tensor of a body of 8 kg resists rotation like a flywheel, and links of a gram make the
solver unstable.

- A macro has the tensor as numbers while the mass is a parameter: a warning. Compute the tensor
  from mass and size in the macro: for a box of x, y, z it is `ixx="${mass / 12 * (y*y + z*z)}"`,
  for a cylinder about z `ixx="${mass / 12 * (3*r*r + l*l)}"` and `izz="${mass / 2 * r*r}"`, for a
  sphere `ixx="${2 / 5 * mass * r*r}"`.
- The tensor was copied along with the rest of the link: an info. Compute each from its own mass and
  size.

Sources:
    Gazebo Classic, inertia: https://classic.gazebosim.org/tutorials?tut=inertia
    Moments of inertia: https://en.wikipedia.org/wiki/List_of_moments_of_inertia
    Kinovarobotics/kinova-ros#204: https://github.com/Kinovarobotics/kinova-ros/issues/204
"""

from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Severity, rule
from urdfkit.robot.inertials.diagnosis import MAX_RELATED
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.masses import Masses
from urdfkit.robot.inertials.tensor_fix import excessive_joint
from urdfkit.robot.inertials.tensor_text import format_moments
from urdfkit.robot.link import Link
from urdfkit.text.diagnostic import Related
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


@rule(Severity.WARNING, computes_fix=True)
def check(context: Context) -> Findings:
    for tag, links in context.masses.shared_by_macro.items():
        from urdfkit.robot.inertials.macro_fixes import shape_macro_fix

        fix = shape_macro_fix(context, links, tag)
        if fix and any(_is_too_light(link, context.masses) for link in links):
            fix = None
        yield _by_macro(links, tag)._replace(fix=fix)
    for group in context.masses.copies:
        yield _copied(sorted(group, key=lambda inertia: -inertia.mass))


def _by_macro(links: list[Link], tag: Tag) -> Finding:
    masses = sorted(filter(None, (link.mass for link in links)))
    calls = [(link, step) for link in links if (step := _innermost_call(link, tag))]
    macro = calls[0][1]
    assert macro.definition is not None
    written = tag.attribute_spans()  # a moment may be missing: urdfdom reads it as 0
    moments = ", ".join(written[key].text for key in ("ixx", "iyy", "izz") if key in written)
    return Finding(
        macro.definition,
        f"macro '{macro.name}' gives {len(links)} links of {masses[0]:g} to {masses[-1]:g} kg "
        f"the same inertia tensor ({moments} kg·m²)",
        "compute ixx ... izz in the macro from mass and size (urdfkit explain XAC014)",
        related=tuple(
            Related(step.span, f"link '{link.name}' of {link.mass:g} kg") for link, step in calls
        ),
    )


def _is_too_light(link: Link, masses: Masses) -> bool:
    """True if the effort limit of the joint is too large for the tensor of the link's shape."""
    inertia = masses.by_name.get(link.name)
    return bool(inertia and inertia.expected and excessive_joint(inertia, inertia.expected))


def _innermost_call(link: Link, tag: Tag) -> Step | None:
    """The macro call that created the tensor of a link."""
    tensor = link.inertial.at.child("inertia") if link.inertial else None
    return tensor.via[-1] if tensor is not None and tensor.tag_at == tag else None


def _copied(group: list[LinkInertia]) -> Finding:
    heaviest, lightest = group[0], group[-1]
    return Finding(
        lightest.at,
        f"{len(group)} links, from '{lightest.link.name}' of {lightest.mass:g} kg to "
        f"'{heaviest.link.name}' of {heaviest.mass:g} kg, have the same inertia tensor "
        f"({format_moments(heaviest.diagonal)})",
        "compute each tensor from the mass and size of its own link",
        related=tuple(
            Related(inertia.at.span, f"link '{inertia.link.name}' of {inertia.mass:g} kg")
            for inertia in group[:-1][:MAX_RELATED]
        ),
        confidence=Confidence.INFERRED,
        severity=Severity.INFO,
    )
