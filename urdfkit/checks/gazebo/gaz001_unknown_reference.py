"""A `<gazebo reference>` refers to neither a link nor a joint.

Gazebo's converter compares the reference with the names of links and joints and drops the whole
block, with its sensors and friction, without a message. Correct the name; xacro prefixes are a
usual cause. It is a warning if the block sets properties of a link, and no similar name exists, or
only that of a link which has the properties already: a file that several robots include may contain
the properties of all their links. It is also a warning if only a colour is lost, and if a file of
the robot defines the link, but an argument disables it: the sensor is not needed, either.

A link that another `<gazebo>` adds as SDF is not part of the URDF: a warning, as the tags can be
written in that link. A joint added in this way must refer to existing links.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    gazebosim/gz-sim#2961: https://github.com/gazebosim/gz-sim/issues/2961
"""

import os
import re
from collections.abc import Collection, Iterable

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.lint.switched_off import is_switched_off, uncalled_macro
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.catalog.extensions import copied, extensions
from urdfkit.ros.gazebo.samples import gazebo_xml, solid_xml
from urdfkit.text.comments import blank_comments
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import fix_value

BAD = robot_xml(solid_xml("wheel"), gazebo_xml("<mu1>0.8</mu1>", reference="whel"))
FIXED = GOOD = BAD.replace("whel", "wheel")

#: What the robot lacks without the block; the rest is about a link that the robot does not have.
_THINGS = frozenset(("sensor", "plugin"))
_NONE: frozenset[str] = frozenset()
#: What stands before the name of a link, a joint or a macro's part, and not of a property.
_NAMED = rb"<(?!xacro:(?:property|arg)\b)[\w:.-]+\s[^<>]*?"


@rule(
    Severity.ERROR,
    help="name a link or a joint of this robot",
    reports_missing=True,
    depends_on_arguments=True,
)
def check(context: Context) -> Findings:
    model = context.model
    links, joints = model.links_by_name, model.joints_by_name
    known = {**links, **joints}
    suggesters = {"link": Suggester(links), "joint": Suggester(joints), "": Suggester(known)}
    parts = (part for block in model.gazebo for part in (*block.all("link"), *block.all("joint")))
    added = {part.get("name") for part in parts}
    properties = _properties(model)
    # The base of a robot may be behind an argument that chooses it.
    is_fragment = context.source.path.endswith(".xacro") and not context.tree.has_base
    for block in model.gazebo:
        reference = block.attributes.get("reference")
        if reference is None or not reference.value or reference.value in known:
            continue
        if context.is_part or is_fragment:  # the file that includes this part defines the link
            return
        if not block.children:
            continue
        tags = {child.tag: None for child in block.children}
        if reference.value in added:
            yield Finding(
                reference,
                f"'{reference.value}' is SDF of another <gazebo>, not of the URDF: Gazebo ignores "
                f"{_listed(tags)}",
                "write the tags as SDF into that element",
                severity=Severity.WARNING,
            )
        else:
            suggested = suggesters[_kind(tags)].suggested(reference.value)
            if not properties.get(suggested, _NONE).isdisjoint(tags):
                suggested = ""  # the block would replace what another one says of that link
            yield _unknown(context, reference, suggested, tags)
    if context.is_part or not any(block.all("joint") for block in model.gazebo):
        return
    for joint, end, into in context.gazebo.lost_joint_ends():
        if not into:
            yield Finding(
                end,
                f"joint '{joint.get('name')}' in <gazebo>: {end.tag} '{end.text.strip()}' is not "
                "in the converted model",
                "name a link that Gazebo has; 'urdfkit gazebo' lists them",
            )


def _properties(model: RobotModel) -> dict[str, set[str]]:
    """The properties that are set for each link and joint, by its name."""
    found: dict[str, set[str]] = {}
    for block in model.gazebo:
        tags = {child.tag for child in block.children} - _THINGS
        found.setdefault(block.get("reference") or "", set()).update(tags)
    return found


def _kind(tags: Iterable[str]) -> str:
    """``link`` or ``joint`` if only one of them has all of some tags, otherwise empty."""
    kinds = {"link", "joint"}
    for tag in tags:
        extension = extensions().get(tag)
        on = {extension.on} if extension else {kind for kind in kinds if tag in copied(kind)}
        kinds &= on if on <= {"link", "joint"} and on else kinds
    return kinds.pop() if len(kinds) == 1 else ""


def _unknown(
    context: Context, reference: Attribute, suggested: str, tags: Collection[str]
) -> Finding:
    message = f"unknown link or joint '{reference.value}': Gazebo ignores {_listed(tags)}"
    help = f"did you mean '{suggested}'?" if suggested else ""
    fix = severity = None
    if macro := uncalled_macro(context, reference.value):
        help, severity = f"call macro '{macro}', which defines it", Severity.WARNING
    elif is_switched_off(context, reference.value):
        help, severity = "put the <gazebo> behind the condition of the link", Severity.WARNING
    elif other := _robot_with(context, reference):
        help = f"add '{reference.value}', which {other} has, or include the file only there"
        severity = Severity.WARNING if _THINGS.isdisjoint(tags) else None
    elif suggested:
        from urdfkit.lint.misspelt_names import corrected_definition  # for few robots

        model = context.model
        defined = model.links_by_name.get(suggested) or model.joints_by_name.get(suggested)
        written = defined.at.attributes["name"] if defined else None
        if written and not written.literal and suggested.endswith(reference.value):
            # The value of the prefix differs from robot to robot.
            help = f"write the prefix as in the name of '{suggested}': {written.span.text}"
        else:
            fix = corrected_definition(context, defined, reference.value)
            fix = fix or fix_value(reference, suggested)
        severity = Severity.WARNING if set(tags) <= {"material"} else None
    elif _THINGS.isdisjoint(tags):
        severity = Severity.WARNING
    group_key = "" if suggested else "unknown"
    return Finding(reference, message, help, fix, group_key=group_key, severity=severity)


def _robot_with(context: Context, reference: Attribute) -> str:
    """Another robot that includes the file of a reference, and has what it names; empty if none."""
    file, packages = reference.span.source.path, context.resolver.packages
    if file == context.source.path or context.reading.xacro is None:
        return ""
    from urdfkit.workspace.includes import includers  # few references are unknown

    value = re.escape(reference.value.encode())
    name = re.compile(_NAMED + rb"""\bname\s*=\s*["']""" + value + rb"""["']""")
    own = {os.path.abspath(source.path) for source in context.reading.xacro.sources}
    for path in sorted(set(map(os.path.abspath, includers(file, packages) or ())) - own):
        source = context.resolver.readable(path)
        if source and name.search(blank_comments(source.data)):
            return os.path.basename(path)
    return ""


def _listed(tags: Collection[str]) -> str:
    return ", ".join(f"<{tag}>" for tag in tags)
