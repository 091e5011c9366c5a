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

from urdfkit.diagnostic import Confidence, Severity
from urdfkit.editing.edits import from_macro
from urdfkit.inertials.diagnosis import as_solid, replacement, values, written
from urdfkit.rules import Finding, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.inertials.weighed import Weighed
    from urdfkit.model import Tensor
    from urdfkit.subject import Subject

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
    for weighed in subject.masses.claims.get("INE015", ()):
        expected = weighed.expected
        assert expected is not None
        yield Finding(
            weighed.at,
            f"link '{weighed.link.name}' has {_difference(weighed, expected)} as it lies",
            "" if from_macro(weighed.at) else f"write {written(expected)}, or turn the <inertial>",
            replacement(weighed, expected),
            confidence=Confidence.INFERRED,
        )


def _difference(weighed: Weighed, expected: Tensor) -> str:
    """What is not that of the shape: the moments, or else the products of inertia."""
    if not weighed.fits(expected, _SAME):
        return (
            f"moments of inertia of {values(weighed.diagonal)} about x, y and z; "
            f"{as_solid(weighed)}"
        )
    keys = [key for key in ("ixy", "ixz", "iyz") if _differs(key, weighed, expected)]
    there, right = (
        ", ".join(f"{key} = {getattr(tensor, key):.3g}" for key in keys)
        for tensor in (weighed.tensor, expected)
    )
    return f"{there} kg m^2; the solid {weighed.solid} has {right}"


def _differs(key: str, weighed: Weighed, expected: Tensor) -> bool:
    apart: float = abs(getattr(weighed.tensor, key) - getattr(expected, key))
    return apart > (_SAME - 1) * weighed.moments[2]
