"""Links of different mass have the same inertia tensor.

With the same shape, a link of twice the mass has twice the moments; the tensor was copied along
with the rest of the link. At most one of the links moves as it should in a simulation. Compute each
tensor from its own mass and size.

Sources:
    Moments of inertia: https://en.wikipedia.org/wiki/List_of_moments_of_inertia
    Kinovarobotics/kinova-ros#204: https://github.com/Kinovarobotics/kinova-ros/issues/204
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.inertials.diagnosis import MAX_RELATED, values
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.text.diagnostic import Confidence, Related, Severity

BAD = """\
<link name="base">
  <inertial>
    <mass value="0.7"/>
    <inertia ixx="0.002" ixy="1e-6" ixz="0" iyy="0.002" iyz="0" izz="0.001"/>
  </inertial>
</link>
<link name="finger">
  <inertial>
    <mass value="0.05"/>
    <inertia ixx="0.002" ixy="1e-6" ixz="0" iyy="0.002" iyz="0" izz="0.001"/>
  </inertial>
</link>
<joint name="knuckle" type="continuous">
  <parent link="base"/>
  <child link="finger"/>
</joint>"""
GOOD = BAD.replace(
    """"0.05"/>
    <inertia ixx="0.002" ixy="1e-6" ixz="0" iyy="0.002" iyz="0" izz="0.001"/>""",
    """"0.05"/>
    <inertia ixx="1.5e-5" ixy="0" ixz="0" iyy="1.5e-5" iyz="0" izz="6e-6"/>""",
)


@rule(Severity.INFO, help="compute each tensor from the mass and size of its own link")
def check(subject: Subject) -> Findings:
    for group in subject.masses.copies:
        yield _finding(sorted(group, key=lambda link: -link.mass))


def _finding(group: list[LinkInertia]) -> Finding:
    heaviest, lightest = group[0], group[-1]
    return Finding(
        lightest.at,
        f"{len(group)} links, from '{lightest.link.name}' of {lightest.mass:g} kg to "
        f"'{heaviest.link.name}' of {heaviest.mass:g} kg, have the same inertia tensor "
        f"({values(heaviest.diagonal)})",
        related=tuple(
            Related(link.at.span, f"link '{link.name}' of {link.mass:g} kg")
            for link in group[:-1][:MAX_RELATED]
        ),
        confidence=Confidence.INFERRED,
    )
