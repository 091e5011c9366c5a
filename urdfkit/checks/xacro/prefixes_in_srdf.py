"""The names of links and joints in an SRDF that lack the prefix of the robot."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.lint.rules import Context, Finding, Findings, Location
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.ros.moveit.srdf_reader import expanded
from urdfkit.text.document import Attribute

_PAIRS = ("disable_collisions", "enable_collisions")


def without_prefix(
    context: Context, srdf: Srdf, argument: str, prefix: str, names: set[str]
) -> Findings:
    """Names that the SRDF writes out, where it has the prefix of the robot as an argument, too.

    Args:
        names: the links and joints of the robot with this prefix.
    """
    values = {**context.arguments, argument: prefix}
    other, arguments = expanded(srdf.path, context, values)
    if other is None or argument not in arguments:
        return
    references = list(_references(other))
    if not any(name.value in names and name.value.startswith(prefix) for name in references):
        return  # it is for the robot without a prefix
    lost = {
        name.value: name
        for name in reversed(references)
        if name.value not in names and f"{prefix}{name.value}" in names
    }
    for value, name in reversed(lost.items()):
        yield Finding(
            Location(name.span, name.element.frame),
            f"'{value}' is called '{prefix}{value}' if {argument} is '{prefix}'; "
            f"<{name.element.tag}> of the SRDF names it without",
            f"write the prefix before {name.span.text.strip()}, as for other names",
        )


def _references(srdf: Srdf) -> Iterator[Attribute]:
    """The links and joints that an SRDF names."""
    yield from (name for kind, name in srdf.references() if kind != "group")
    for tag in _PAIRS:
        for pair in srdf.root.all(tag):
            yield from (
                pair.attributes[key] for key in ("link1", "link2") if key in pair.attributes
            )
