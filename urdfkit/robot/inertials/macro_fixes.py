"""Fix that replaces a macro with a constant tensor by macros that compute it from the shape.

A uniform solid has its inertial at the pose of its shape, so that the calls pass this pose.
"""

from __future__ import annotations

import re

from urdfkit.core.record import Record
from urdfkit.robot import DescribedRobot
from urdfkit.robot.link import Body, Link
from urdfkit.text.comments import without_comments
from urdfkit.text.diagnostic import Edit, Fix
from urdfkit.text.document import Attribute, CallFrame, Element, Tag
from urdfkit.text.editing.edits import insert_behind, replace
from urdfkit.text.source import Span

#: The moments about x, y and z of a uniform solid about its centre, by its parameters.
_MOMENTS = {
    "box": (
        ("x", "y", "z"),
        ("${mass / 12 * (y*y + z*z)}", "${mass / 12 * (x*x + z*z)}", "${mass / 12 * (x*x + y*y)}"),
    ),
    "cylinder": (
        ("radius", "length"),
        (
            "${mass / 12 * (3*radius*radius + length*length)}",
            "${mass / 12 * (3*radius*radius + length*length)}",
            "${mass / 2 * radius*radius}",
        ),
    ),
    "sphere": (("radius",), ("${2 / 5 * mass * radius*radius}",) * 3),
}

_PARAMETER = r"\$\{\s*(\w+)\s*\}"
#: A number or an expression of a vector.
_PART = r"(?:\$\{[^}]*\}|\$\([^)]*\)|[^\s$])+"


class _MacroCall(Record):
    """The new call for an old macro call."""

    at: Tag  # the old call
    kind: str  # kind of shape
    arguments: tuple[tuple[str, str], ...]  # of the new call, as text


def shape_macro_fix(description: DescribedRobot, links: list[Link], tensor: Tag) -> Fix | None:
    """A fix with new macros for the shapes of links, and with calls of these macros.

    Args:
        tensor: the ``<inertia>`` in the macro.
    """
    calls: dict[Tag, _MacroCall] = {}
    rejected: set[Tag] = set()
    definition = None
    for link in links:
        frame = _frame(link)
        if frame is None:
            return None
        definition = frame.definition
        call = _call(link, frame)
        if call is None or calls.setdefault(call.at, call) != call:
            rejected.add(frame.call)
    good = [call for call in calls.values() if call.at not in rejected]
    if not good or definition is None:
        return None
    names = _names(description, {call.kind for call in good})
    if names is None:
        return None
    lines = [line for kind, name in names.items() for line in ("", *_macro(kind, name))]
    is_complete = not rejected and _is_only_use(description, tensor, links)
    edits = (*_defined(definition, lines, instead=is_complete), *(_edit(c, names) for c in good))
    # A comment stays: only its author knows whether it applies to the new macros.
    stale = is_complete and _has_comment_above(definition)
    again = "; the comment above was about the old one" if stale else ""
    return Fix(f"compute the tensors from the shapes, by new macros{again}", edits)


def _has_comment_above(definition: Tag) -> bool:
    """True if a comment ends in the line above an element, or before it in the same line."""
    before = definition.source.data[: definition.start]
    text = before.rstrip()
    return text.endswith(b"-->") and before.count(b"\n", len(text)) < 2


def _frame(link: Link) -> CallFrame | None:
    """The macro call that created the inertial of a link, if the macro contains nothing else."""
    assert link.inertial is not None
    at = link.inertial.at
    frame = at.frame
    if frame is None or frame.kind != "macro" or frame.definition is None:
        return None
    origin = at.child("origin")
    if origin and any(_numbers(origin)):
        return None
    body, whole = map(_without_comments, (frame.definition.inner_span, at.tag_at.whole_span))
    return frame if body == whole else None


def _without_comments(span: Span) -> bytes:
    return without_comments(span.source.data[span.start : span.end]).strip()


def _numbers(origin: Element) -> list[str]:
    """The numbers of an origin that are not 0."""
    values = (attribute.value for attribute in origin.attributes.values())
    return [text for value in values for text in value.split() if text.strip("+-0.")]


def _call(link: Link, frame: CallFrame) -> _MacroCall | None:
    """The new call for a link; None if the shape or the mass cannot be passed."""
    mass = _mass(link, frame)
    bodies = link.collisions or link.visuals
    if mass is None or len(bodies) != 1:
        return None
    body = bodies[0]
    shape = body.shape
    if shape is None or shape.kind not in _MOMENTS or shape.at.frame is not frame.outer:
        return None
    sizes = _sizes(shape.at, shape.kind)
    pose = _pose(body, frame)
    if sizes is None or pose is None:
        return None
    return _MacroCall(frame.call, shape.kind, (("mass", mass), *sizes, *pose))


def _mass(link: Link, frame: CallFrame) -> str | None:
    """The mass argument of a call, as text, if it is the only argument."""
    assert link.inertial is not None
    element = link.inertial.at.child("mass")
    value = element.attributes.get("value") if element else None
    parameter = re.fullmatch(_PARAMETER, value.span.text) if value else None
    arguments = frame.call.attribute_spans()
    if parameter is None or set(arguments) != {parameter.group(1)}:
        return None
    return arguments[parameter.group(1)].text


def _sizes(shape: Element, kind: str) -> list[tuple[str, str]] | None:
    """The size arguments of a shape, as written."""
    parameters, _ = _MOMENTS[kind]
    if kind != "box":
        texts = [_text(shape.attributes.get(name)) for name in parameters]
    else:
        size = _text(shape.attributes.get("size"))
        texts = list(re.findall(_PART, size)) if size is not None else []
    if len(texts) != len(parameters) or not all(texts):
        return None
    return [(name, text or "") for name, text in zip(parameters, texts, strict=True)]


def _pose(body: Body, frame: CallFrame) -> list[tuple[str, str]] | None:
    """The pose arguments of a shape; None if they cannot be passed."""
    origin = body.at.child("origin")
    if origin is None or not _numbers(origin):
        return []
    if origin.frame is not frame.outer or "quat_xyzw" in origin.attributes:
        return None
    pairs = [(key, origin.attributes[key]) for key in ("xyz", "rpy") if key in origin.attributes]
    texts = [(key, _text(attribute)) for key, attribute in pairs]
    return [(key, text) for key, text in texts if text] if all(t for _, t in texts) else None


def _text(attribute: Attribute | None) -> str | None:
    """A value as written in its tag."""
    if attribute is None or attribute.written_in is not None:
        return None
    return " ".join(attribute.span.text.split())


def _names(description: DescribedRobot, kinds: set[str]) -> dict[str, str] | None:
    """Unused names of the macros by the kind of shape; None if all are in use."""
    taken = {macro.name.removeprefix("xacro:") for macro in description.xacro.macros}
    for name in ("{}_inertial", "solid_{}_inertial"):
        names = {kind: name.format(kind) for kind in _MOMENTS if kind in kinds}
        if taken.isdisjoint(names.values()):
            return names
    return None


def _is_only_use(description: DescribedRobot, tensor: Tag, links: list[Link]) -> bool:
    """True if only these links use the macro, and no other file can include it."""
    is_private = tensor.source is description.source and description.xacro.is_complete
    return description.uses[tensor] == len(links) and is_private and not description.is_included


def _macro(kind: str, name: str) -> list[str]:
    parameters, (ixx, iyy, izz) = _MOMENTS[kind]
    params = f"mass {' '.join(parameters)} xyz:='0 0 0' rpy:='0 0 0'"
    return [
        f"<!-- Inertial of a uniform {kind}; kg and m -->",
        f'<xacro:macro name="{name}" params="{params}">',
        "  <inertial>",
        '    <origin xyz="${xyz}" rpy="${rpy}"/>',
        '    <mass value="${mass}"/>',
        f'    <inertia ixx="{ixx}" ixy="0" ixz="0"',
        f'             iyy="{iyy}" iyz="0"',
        f'             izz="{izz}"/>',
        "  </inertial>",
        "</xacro:macro>",
    ]


def _defined(definition: Tag, lines: list[str], *, instead: bool) -> tuple[Edit, ...]:
    """Edits that insert the new macros after the old one, or replace it."""
    whole = definition.whole_span
    if not instead:
        return insert_behind(whole, lines)
    return replace(whole, lines)


def _edit(call: _MacroCall, names: dict[str, str]) -> Edit:
    whole: Span = call.at.whole_span
    arguments = "".join(f' {name}="{text}"' for name, text in call.arguments)
    return Edit(whole, f"<xacro:{names[call.kind]}{arguments}/>")
