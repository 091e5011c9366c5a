"""One macro gives links of different mass the same inertia tensor.

The tensor stands in the macro as numbers while the mass is a parameter: a wheel of 0.5 kg then
resists turning as much as a body of 8 kg. Gazebo spins such a wheel up as if it were a flywheel,
and gram-light links make the solver unstable. Compute the tensor from mass and size in the macro:
for a box of x, y, z it is `ixx="${mass / 12 * (y*y + z*z)}"`, for a cylinder about z
`ixx="${mass / 12 * (3*r*r + l*l)}"` and `izz="${mass / 2 * r*r}"`, for a sphere
`ixx="${2 / 5 * mass * r*r}"`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Related, Severity
from urdfkit.model import number
from urdfkit.rules import Finding, Need, Written, rule

if TYPE_CHECKING:
    from urdfkit.document import Element, Step, Tag
    from urdfkit.model import Link
    from urdfkit.subject import Subject

BAD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="inertial" params="mass">
    <inertial>
      <mass value="${mass}"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
    </inertial>
  </xacro:macro>
  <link name="base"><xacro:inertial mass="8"/></link>
  <link name="wheel"><xacro:inertial mass="0.5"/></link>
  <joint name="axle" type="continuous"><parent link="base"/><child link="wheel"/></joint>
</robot>
"""
GOOD = BAD.replace('"0.1"', '"${mass * 0.0125}"')

#: Masses this close together may well share a tensor.
_SAME_MASS = 1.05


@rule(
    "XAC014",
    "macro-gives-constant-inertia",
    Severity.WARNING,
    needs=(Need.XACRO, Need.MODEL),
    help="compute ixx ... izz in the macro from mass and size (urdfkit explain XAC014)",
)
def check(subject: Subject) -> Iterator[Finding]:
    groups: dict[Tag, list[Link]] = {}
    for link in subject.model.links:
        tensor = link.inertial.at.child("inertia") if link.inertial else None
        if tensor is not None and _is_written_out(tensor):
            groups.setdefault(tensor.tag_at, []).append(link)
    for tag, links in groups.items():
        masses = sorted(filter(None, map(_mass, links)))
        if masses and masses[-1] > masses[0] * _SAME_MASS:
            yield _finding(links, masses, tag)


def _is_written_out(tensor: Element) -> bool:
    """True for a tensor other than zero whose numbers stand in a macro."""
    in_macro = tensor.frame is not None and tensor.frame.definition is not None
    return (
        in_macro
        and all(attribute.literal for attribute in tensor.attributes.values())
        and any(number(attribute.value) for attribute in tensor.attributes.values())
    )


def _mass(link: Link) -> float | None:
    return link.inertial.mass.value if link.inertial and link.inertial.mass else None


def _finding(links: list[Link], masses: list[float], tag: Tag) -> Finding:
    calls = [(link, step) for link in links if (step := _innermost_call(link, tag))]
    macro = calls[0][1]
    assert macro.definition is not None
    moments = ", ".join(tag.attribute_spans()[key].text for key in ("ixx", "iyy", "izz"))
    return Finding(
        Written(macro.definition),
        f"macro '{macro.name}' gives {len(links)} links of {masses[0]:g} to {masses[-1]:g} kg "
        f"the same inertia tensor ({moments} kg m^2)",
        related=tuple(
            Related(step.span, f"link '{link.name}' of {_mass(link):g} kg") for link, step in calls
        ),
    )


def _innermost_call(link: Link, tag: Tag) -> Step | None:
    """The macro call that gave a link the tensor."""
    tensor = link.inertial.at.child("inertia") if link.inertial else None
    return tensor.via[-1] if tensor is not None and tensor.tag_at == tag else None
