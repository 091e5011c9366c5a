"""An attribute has a name that URDF does not know.

Every reader passes over it and takes the default of the attribute that was meant: a joint with
`velocty="2"` has no velocity limit. Correct the name, or remove the attribute.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Fix, Severity
from urdfkit.edits import rename_attribute
from urdfkit.grammar import owner
from urdfkit.rules import Finding, rule

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<link name="base"/>
<link name="lid"/>
<joint name="hinge" type="continuous">
  <parent link="base"/>
  <child link="lid"/>
  <dynamics damping="0.1" fricton="0.2"/>
</joint>"""
GOOD = BAD.replace("fricton", "friction")
FIXED = GOOD


@rule(
    "URD002",
    "unknown-attribute",
    Severity.WARNING,
    help="remove it, or give it the namespace prefix of the program that reads it",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for element, attribute, _, meant in subject.deviations.get("URD002", ()):
        assert attribute is not None
        name = attribute.name
        message = f"{owner(element)}: <{element.tag}> has no attribute '{name}'"
        edits = rename_attribute(attribute, meant) if meant else None
        yield Finding(
            attribute,
            f"{message}; did you mean '{meant}'?" if meant else message,
            f"rename it to {meant}" if meant else "",
            Fix(f"rename {name} to {meant}", edits) if edits else None,
        )
