"""A tag that only Gazebo reads stands outside a `<gazebo>` block.

Gazebo gets the robot through a URDF reader, and URDF readers pass over what is not URDF: friction
(`mu1`, `mu2`), contact stiffness (`kp`, `kd`), `preserveFixedJoint`, sensors and plugins inside a
link or joint never arrive, and nothing says so. Move the tag into `<gazebo reference="...">` with
the name of the link or joint.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Severity
from urdfkit.document import Element
from urdfkit.grammar import owner
from urdfkit.rules import Finding, rule

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<link name="wheel">
  <mu1>0.5</mu1>
</link>"""
GOOD = """\
<link name="wheel"/>
<gazebo reference="wheel">
  <mu1>0.5</mu1>
</gazebo>"""


@rule("URD008", "gazebo-tag-misplaced", Severity.WARNING)
def check(subject: Subject) -> Iterator[Finding]:
    for element, *_ in subject.deviations.get("URD008", ()):
        assert element.parent is not None
        yield Finding(
            element,
            f"{owner(element.parent)}: Gazebo never sees the <{element.tag}> in "
            f"<{element.parent.tag}>, which URDF readers pass over",
            f"move it into {_block(element)}",
        )


def _block(element: Element) -> str:
    """The block that it belongs in."""
    owners = [ancestor for ancestor in _ancestors(element) if ancestor.tag in ("link", "joint")]
    name = owners[-1].get("name") if owners else None
    return f'<gazebo reference="{name}">' if name else "a <gazebo> block"


def _ancestors(element: Element) -> Iterator[Element]:
    while element.parent is not None:
        element = element.parent
        yield element
