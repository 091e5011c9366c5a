"""An element is unknown to URDF, or in a place where URDF does not have it.

URDF parsers ignore the element and its content without a message. Usually the name is misspelt, or
the tag belongs to another format (SDF, an old ROS tutorial, another simulator). A `<material>`
inside `<geometry>` sets no colour, an `<origin>` directly in a link moves nothing, a `<mass>`
outside `<inertial>` has no effect. Correct the name, move the element, or remove it. A tag with a
namespace prefix, such as `drake:proximity_properties`, is an extension and is reported only if
Drake defines another tag with nearly the same name. xacro drops the root element of an included
file: if it is a `<link>`, its shapes are directly in the `<robot>`. An info is an element that a
program in the same package, in a neighbouring one or in a dependency reads, an old tag whose
attributes are all zero, a tag in the axis of a fixed joint, a tag that `<xacro:element>` creates,
and one with data that resembles no tag of URDF and occurs four times or more, or directly in
`<robot>` in four files of the directory: it is for another program.

It is an error if a required element is misspelt: without `<inertial>` Gazebo drops the link with
its children; without `<geometry>`, `<mass>` or a shape, urdfdom drops all shapes of the link;
without `<parent>` or `<child>` it rejects the robot.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
    urdf-usd-converter, benchmarks: misplaced in 74 of 408 public models: https://github.com/newton-physics/urdf-usd-converter
"""

import os
import re
from collections import Counter
from collections.abc import Sequence
from functools import lru_cache
from itertools import islice

from urdfkit.core import disk
from urdfkit.core.words import more_like_this
from urdfkit.lint.rules import (
    Context,
    Finding,
    Findings,
    Fix,
    Location,
    Related,
    Severity,
    rule,
)
from urdfkit.robot.samples import collision_xml, link_xml
from urdfkit.text.comments import without_comments
from urdfkit.text.document import CallFrame, Element
from urdfkit.text.editing.edits import move_after, remove_element, rename_element
from urdfkit.text.file_kinds import is_xacro
from urdfkit.text.grammar import calling_macro, owner, places_of
from urdfkit.text.schema import SRDF_TAGS
from urdfkit.text.source import shown
from urdfkit.workspace.program_strings import xml_readers
from urdfkit.workspace.resolve import Resolver

BAD = link_xml("base", collision_xml('<box size="0.2 0.2 0.1"/>')).replace("collision", "colision")
FIXED = GOOD = BAD.replace("colision", "collision")

#: The element of today, and what it replaces of early versions.
_SUCCESSOR = "dynamics"
_INSTEAD = {"joint_properties": "write <dynamics> instead, which has the same attributes"}

#: The first element of a file.
_ROOT = rb"<([A-Za-z][\w:.-]*)(?![\w:.-])(?=[^<>]*>)"

#: Number of elements with the same tag in the same wrong place that a finding lists.
_MAX_NAMED = 5


#: So often an unknown element is not there by mistake: it is for another program.
_OWN = 4
#: Most descriptions next to this one that are searched for an unknown element.
_MAX_BESIDE = 50
_TAG = rb"<([A-Za-z_][\w.-]*)"


@rule(Severity.WARNING, help="remove it, unless a program of yours reads it")
def check(context: Context) -> Findings:
    misplaced: list[Element] = []
    unknown: list[tuple[Element, str]] = []
    srdfs = _included_srdfs(context)
    for element, _, needed, suggested in context.deviations.get("URD001", ()):
        if not suggested and places_of(element):
            misplaced.append(element)
        elif needed:
            yield _needed(element, needed)
        elif element.frame not in srdfs:
            unknown.append((element, suggested))
    yield from map(_of_srdf, srdfs)
    tags = {element.tag for element, suggested in unknown if not suggested}
    readers = xml_readers(tags, context.source.path, context.resolver) if tags else {}
    counts = Counter(
        element.tag
        for element, suggested in unknown
        if not suggested and (element.attributes or element.children or element.text.strip())
    )
    for element, suggested in unknown:
        finding = _unknown(element, suggested, readers.get(element.tag))
        is_own = counts[element.tag] >= _OWN and element.tag not in _INSTEAD
        if counts[element.tag] and element.parent is context.document.root:
            directory = os.path.dirname(context.source.path)
            is_own = is_own or _tags_in(directory, context.resolver)[element.tag] >= _OWN
        yield finding._replace(severity=Severity.INFO) if is_own else finding
    yield from _misplaced(misplaced)


@lru_cache(maxsize=1)
def _tags_in(directory: str, resolver: Resolver) -> Counter[str]:
    """The number of descriptions in a directory that have each tag."""
    names = (name for name in disk.names_or_empty(directory) if name.endswith((".urdf", ".xacro")))
    paths = (os.path.join(directory, name) for name in islice(sorted(names), _MAX_BESIDE))
    sources = (resolver.readable(path) for path in paths)
    tags = (set(re.findall(_TAG, without_comments(one.data))) for one in sources if one)
    return Counter(tag.decode() for found in tags for tag in found)


def _included_srdfs(context: Context) -> list[CallFrame]:
    """The includes of SRDFs, whose elements are right there."""
    children = context.document.root.children
    of_srdf = {element.frame for element in children if element.tag in SRDF_TAGS}
    of_urdf = {element.frame for element in children if element.tag in ("link", "joint")}
    return [frame for frame in of_srdf - of_urdf if frame and frame.kind == "include"]


def _of_srdf(include: CallFrame) -> Finding:
    return Finding(
        Location(include.call.span, include.outer),
        f"{os.path.basename(include.name)} is an SRDF, which URDF parsers ignore",
        "remove the <xacro:include>: MoveIt reads the SRDF as robot_description_semantic",
        severity=Severity.INFO,
    )


def _needed(element: Element, needed: str) -> Finding:
    """A misspelt element that the robot needs."""
    edits = rename_element(element, needed)
    title = f"rename <{element.tag}> to <{needed}>"
    message = f"{owner(element)}: unknown element <{element.tag}>, and <{needed}> is missing"
    return Finding(element, message, title, Fix.of(title, edits), severity=Severity.ERROR)


def _unknown(element: Element, suggested: str, reader: str | None) -> Finding:
    """An unknown element.

    Args:
        suggested: the intended tag; empty if no tag is similar.
        reader: the source file of a program that reads the element; None if there is none.
    """
    assert element.parent is not None
    is_computed = element.tag_at.name_span.text == "xacro:element"
    if is_computed:  # from an argument, which may have another value
        suggested = ""
    who = owner(element.parent)
    message = f"{who}: unknown element <{element.tag}> in <{element.parent.tag}>"
    message += f"; {shown(reader)} reads it" if reader else " (ignored)"
    return Finding(
        element,
        f"{message}; did you mean <{suggested}>?" if suggested else message,
        "give it the namespace prefix of its program" if reader else _help(element, suggested),
        None if reader or is_computed else _fix(element, suggested),
        group_key=f"{element.tag} in {element.parent.tag}",
        severity=Severity.INFO if reader or is_computed or _has_no_effect(element) else None,
    )


def _has_no_effect(element: Element) -> bool:
    """True for an old tag with zeros, and for a tag in the axis of a joint without axis."""
    parent = element.parent
    joint = parent.parent if parent is not None and parent.tag == "axis" else None
    if joint is not None and joint.attributes.get("type"):
        return joint.attributes["type"].value == "fixed"
    return element.tag in _INSTEAD and not element.children and _is_zero(element)


def _help(element: Element, suggested: str) -> str:
    macro = calling_macro(element)
    if element.tag.startswith("xacro."):
        return f"write <xacro:{element.tag[6:]}>, with a colon"
    if not suggested:
        has_successor = element.parent and element.parent.child(_SUCCESSOR)
        return "" if has_successor else _INSTEAD.get(element.tag, "")
    return f"rename it to <{suggested}>" + (f" in the call of macro '{macro}'" if macro else "")


def _fix(element: Element, suggested: str) -> Fix | None:
    """Rename the element, or remove an empty one."""
    if suggested:
        edits = rename_element(element, suggested)
        fix = Fix.of(f"rename <{element.tag}> to <{suggested}>", edits)
        # A block that parsers ignored so far may change the robot once they read it.
        return fix._replace(safe=False) if fix and calling_macro(element) else fix
    if element.children or element.text.strip() or not _is_zero(element):
        return None  # its values may belong elsewhere
    # In a xacro it may be a call of a macro without its prefix and its include.
    is_call = is_xacro(element.tag_at.source)
    safe = not element.attributes and not is_call
    return Fix(f"remove the <{element.tag}>", remove_element(element), safe=safe)


def _misplaced(elements: list[Element]) -> Findings:
    """Elements that URDF defines in other places."""
    by_place: dict[tuple[str, str], list[Element]] = {}
    for element in elements:
        assert element.parent is not None
        fix = _moved(element, element.parent)
        if fix is None:
            by_place.setdefault((element.tag, element.parent.tag), []).append(element)
        else:
            yield _in_place(element, element.parent, fix=fix)
    rootless: set[str] = set()
    for first, *others in by_place.values():
        assert first.parent is not None
        source = first.tag_at.source
        is_child = first.parent.tag == "robot"
        root = re.search(_ROOT, without_comments(source.data)) if is_child else None
        if root and root[1] in (b"link", b"joint"):
            if source.path not in rootless:
                rootless.add(source.path)
                yield _without_robot(first, root[1].decode())
            continue
        yield _in_place(first, first.parent, others)


def _without_robot(element: Element, root: str) -> Finding:
    """Elements that an include added to the robot without the root of its file."""
    file = os.path.basename(element.tag_at.source.path)
    return Finding(
        element,
        f"the root of {file} is <{root}>, which xacro:include drops: <{element.tag}> is put "
        "directly into <robot>",
        f"wrap the <{root}> of {file} in <robot>",
    )


def _in_place(
    element: Element, parent: Element, others: Sequence[Element] = (), fix: Fix | None = None
) -> Finding:
    """One finding for all elements with the same tag in the same wrong place."""
    places = " or ".join(f"<{place}>" for place in places_of(element))
    message = (
        f"{owner(parent)}: URDF parsers ignore <{element.tag}> inside <{parent.tag}>; "
        f"it belongs in {places}{more_like_this(len(others))}"
    )
    related = tuple(Related(other.span, owner(other)) for other in others[:_MAX_NAMED])
    # The colour of a collision is not shown; onshape-to-robot writes an <origin> of zeros in links.
    is_material = element.tag == "material" and parent.tag == "collision"
    is_idle = is_material or (element.tag == "origin" and _is_zero(element))
    severity = Severity.INFO if is_idle else None
    return Finding(element, message, f"move it into {places}", fix, related, severity=severity)


def _is_zero(element: Element) -> bool:
    """True for an element whose attributes, if it has any, are zeros."""
    words = " ".join(attribute.value for attribute in element.attributes.values()).split()
    return all(word.strip("+-0.") == "" for word in words)


def _moved(element: Element, parent: Element) -> Fix | None:
    """The only move that is unambiguous: a material out of the geometry, into its visual."""
    visual = parent.parent
    if element.tag != "material" or parent.tag != "geometry" or visual is None:
        return None
    if visual.tag != "visual" or visual.child("material") or len(parent.all("material")) > 1:
        return None
    return Fix("move the <material> out of the <geometry>", move_after(element, parent))
