"""Two links, or two joints, have names that differ in upper and lower case only.

Readers tell them apart, people and file systems do not: a reference to the one is meant for the
other sooner or later, and meshes of the two overwrite each other on Windows and macOS.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint, Link

BAD = """\
<link name="hand"/>
<link name="Hand"/>
<joint name="wrist" type="fixed">
  <parent link="hand"/>
  <child link="Hand"/>
</joint>"""
GOOD = BAD.replace("Hand", "palm")


@rule("NAM011", "names-differ-in-case", Severity.INFO, help="give one of them another name")
def check(subject: Subject) -> Iterator[Finding]:
    model = subject.model
    yield from _alike("link", model.links)
    yield from _alike("joint", model.joints)


def _alike(kind: str, things: Iterable[Link | Joint]) -> Iterator[Finding]:
    first: dict[str, Link | Joint] = {}
    for thing in things:
        other = first.setdefault(thing.name.casefold(), thing)
        if other.name != thing.name:
            yield Finding(
                thing.at.attributes.get("name", thing.at),
                f"{kind} '{thing.name}' differs from '{other.name}' in upper and lower case only",
                related=(Related(other.at.span, f"{kind} '{other.name}'"),),
            )
