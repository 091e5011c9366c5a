"""The moments of inertia stand at the wrong axes.

They are those of the link's shape, but in another order, or about axes that are turned: a wheel
that lies along y has the tensor of one along z, or a product of inertia has the wrong sign. URDF
turns the tensor with the `<origin>` of the `<inertial>`, not with that of the collision or the
visual, which are often turned by a quarter. The wheel then spins up faster than it should and
resists tipping less. Swap the values, or give the `<inertial>` the same `rpy` as the shape.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    Moments of inertia: https://en.wikipedia.org/wiki/List_of_moments_of_inertia
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.inertials.diagnosis import as_solid, of_wrong_axes, opposite, replacement, values
from urdfkit.text.diagnostic import Confidence, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.inertials.link_comparison import LinkInertia

BAD = """\
<link name="wheel">
  <collision>
    <origin rpy="1.5707963267948966 0 0"/>
    <geometry><cylinder radius="0.1" length="0.04"/></geometry>
  </collision>
  <inertial>
    <mass value="0.6"/>
    <inertia ixx="0.00158" ixy="0" ixz="0" iyy="0.00158" iyz="0" izz="0.003"/>
  </inertial>
</link>"""
FIXED = GOOD = BAD.replace('iyy="0.00158"', 'iyy="0.003"').replace('izz="0.003"', 'izz="0.00158"')

#: Moments within this factor are those of the shape.
_SAME = 1.2


@rule(
    "INE015",
    "transposed-tensor",
    Severity.WARNING,
    help="swap the values, or give the <inertial> the rpy of the shape",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for weighed in subject.masses.diagnoses.get("INE015", ()):
        _, tensor = of_wrong_axes(weighed)
        flipped = opposite(weighed.tensor, tensor)
        fix = replacement(weighed, tensor)
        yield Finding(
            weighed.at,
            _signs(weighed, flipped) if flipped else _moments(weighed),
            f"{fix.title}, or turn the <inertial>" if fix else "",
            fix,
            confidence=Confidence.INFERRED,
        )


def _moments(weighed: LinkInertia) -> str:
    return (
        f"link '{weighed.link.name}' has moments of inertia of {values(weighed.diagonal)}"
        f" about x, y and z; {as_solid(weighed)} as it lies"
    )


def _signs(weighed: LinkInertia, keys: list[str]) -> str:
    """Products of inertia, of which only the sign differs from that of the shape."""
    pairs = [(getattr(weighed.tensor, key), getattr(weighed.expected, key)) for key in keys]
    return (
        f"link '{weighed.link.name}' has "
        + " and ".join(f"{key} {old:.3g}" for key, (old, _) in zip(keys, pairs, strict=True))
        + f" kg m^2, with the sign opposite to that of the solid {weighed.solid}, which has "
        + " and ".join(f"{new:.3g}" for _, new in pairs)
    )
