"""A link that a joint moves has no moment of inertia about one of its axes.

It is as thin as a line about that axis, which no part is. MuJoCo refuses such a moving body;
engines that invert the tensor divide by zero, and a joint about that axis turns without effort.
The moment was rounded to nothing, or a CAD program exported a wire or a surface. Give the part its
thickness: even a rod has `mass / 2 * radius^2` about its length.

Sources:
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    Moments of inertia: https://en.wikipedia.org/wiki/List_of_moments_of_inertia
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.inertials.diagnosis import MAX_RELATED
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.inertials.masses import Masses

BAD = """\
<link name="base"/>
<link name="rod">
  <inertial>
    <mass value="0.3"/>
    <inertia ixx="0.025" ixy="0" ixz="0" iyy="0.025" iyz="0" izz="0"/>
  </inertial>
</link>
<joint name="pivot" type="continuous">
  <parent link="base"/>
  <child link="rod"/>
</joint>"""
GOOD = BAD.replace('izz="0"', 'izz="1.5e-5"')


@rule(
    "INE018",
    "singular-inertia",
    Severity.WARNING,
    help="write the moment about the thin axis too: mass / 2 * radius^2 for a rod",
    by_target={"mujoco": Severity.ERROR},
)
def check(subject: Subject) -> Iterator[Finding]:
    found = sorted(_findings(subject.masses), key=lambda finding: -finding.weight)
    if found:
        worst, *others = found
        more = f" ({len(others)} more links likewise)" if others else ""
        related = tuple(Related(one.at.span, one.message) for one in others[:MAX_RELATED])
        yield worst._replace(message=worst.message + more, related=related)


def _findings(masses: Masses) -> Iterator[Finding]:
    for body in masses.singular:
        assert body.joint is not None
        weighed = masses.by_name.get(body.top.name)
        if weighed is not None:
            low, middle, high = masses.moments_of(body)
            yield Finding(
                weighed.at,
                f"link '{body.top.name}', moved by the {body.joint.kind} joint "
                f"'{body.joint.name}', has principal moments of inertia of {low:.1g}, "
                f"{middle:.3g} and {high:.3g} kg m^2: nothing about one axis",
                weight=body.mass,
            )
