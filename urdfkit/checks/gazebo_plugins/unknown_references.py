"""What plugins look up in the simulated robot, and do not find because it is nowhere."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Finding
from urdfkit.text.diagnostic import Fix
from urdfkit.text.editing.edits import rewrite

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.ros.gazebo.plugins import Reference


def unknown(subject: Subject, kind: str) -> Iterator[Finding]:
    """A finding for each parameter of a plugin that names what is not there.

    Args:
        subject: the robot.
        kind: ``link`` or ``joint``.
    """
    model = subject.model
    own = model.links_by_name.keys() if kind == "link" else model.joints_by_name.keys()
    known = own | subject.gazebo.added | ({"world"} if kind == "link" else set())
    suggester = Suggester(own)
    for use in subject.plugins:
        for reference in use.references():
            if reference.kind != kind or reference.name in known:
                continue
            if subject.is_part:  # the file that includes it has the link or the joint
                return
            suggested = suggester.suggested(reference.name)
            yield Finding(
                reference.item.at,
                f"{use.title} looks for {kind} '{reference.name}', which does not exist"
                f"{use.outcome}",
                f"did you mean '{suggested}'?" if suggested else "",
                _renamed(reference, suggested) if suggested else None,
            )


def _renamed(reference: Reference, suggested: str) -> Fix | None:
    """Another name, where it is all that the parameter holds."""
    item, name = reference.item, reference.name
    edits = rewrite(item.at, suggested) if item.text == name else None
    return Fix.of(f"rename '{name}' to '{suggested}'", edits)
