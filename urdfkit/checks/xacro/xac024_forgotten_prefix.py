"""A reference to a link or joint lacks the prefix or the condition of its definition.

The robot is right while the prefix is empty, and breaks with any other prefix: with
`prefix:=left_` there is no `elbow_joint`, only `left_elbow_joint`. To compare the names, urdfkit
expands the robot once more with a value for each empty argument, independent of its name. Write
`${prefix}` or `$(arg prefix)` in the reference, too. The same holds for names in an SRDF that is a
xacro and has the argument of the prefix, too.

If a package of the robot is not found, a link is also reported that a joint names without a prefix
that is not empty.

A macro that calls a link `${name}_link` and its parent joint's child `lidar_link` is right for one
value of its parameter only: a second call, or another name, breaks it.

The same is true for a link that `<xacro:if value="${with_camera}">` adds: if it is the parent of a
joint outside of the condition, the robot breaks with `with_camera:=false`. A `<gazebo>` block
outside of the condition is an info: Gazebo ignores the block. A reference in another package than
the condition is not reported: a MoveIt configuration is for the robot with its arm.

Sources:
    ROS-Industrial, coordinate frames and prefixes: https://wiki.ros.org/Industrial/Tutorials/WorkingWithRosIndustrialRobotSupportPackages
    ros-industrial/universal_robot#432: https://github.com/ros-industrial/universal_robot/issues/432
"""

import re
from collections.abc import Iterator

from urdfkit.lint.empty_arguments import empty_arguments
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Related, Severity, rule
from urdfkit.robot.samples import xacro_xml
from urdfkit.text.document import Attribute, CallFrame, Element
from urdfkit.text.source import Source, Span

BAD = xacro_xml(
    '<xacro:arg name="prefix" default=""/>',
    '<link name="$(arg prefix)base"/>',
    '<link name="$(arg prefix)tip"/>',
    '<joint name="$(arg prefix)end" type="fixed">',
    '<parent link="base"/><child link="$(arg prefix)tip"/></joint>',
)
GOOD = BAD.replace('link="base"', 'link="$(arg prefix)base"')

#: Value of the prefix in the second expansion.
_PREFIX = "left_"
_DEFINED = ("link", "joint")
#: Attributes that refer to a link or joint; ``name`` refers to one in `_DEFINED` in other elements.
_ATTRIBUTES = ("link", "joint", "reference")
#: Tags whose text is the name of a link or a joint.
_NAMING = ("frame", "link", "joint", "body")


@rule(Severity.WARNING, needs=(Need.XACRO, Need.MODEL))
def check(context: Context) -> Findings:
    yield from _names_without_parameter(context.document.root)
    if context.part is not None:
        yield from _names_without_value(context)
    if context.is_part or not context.xacro.defaults:
        return
    from urdfkit.checks.xacro.forgotten_condition import forgotten_conditions  # needs arguments

    yield from _forgotten_prefixes(context)
    yield from forgotten_conditions(context)


def _forgotten_prefixes(context: Context) -> Findings:
    root = context.document.root
    arguments = empty_arguments(context)
    if not arguments:
        return
    srdf = context.srdf if context.srdf and context.srdf.path.endswith(".xacro") else None
    prefixed = {name for name, at in _definitions(root) if not at.literal}
    suspects = {
        name
        for name, span, element in _references(root, prefixed)
        if _written(name, span, element.frame)
    }
    for argument in arguments if suspects or srdf else ():
        values = {**context.arguments, argument: _PREFIX}
        other = context.expanded_with(values)
        if other is None:
            continue
        names = {name for name, _ in _definitions(other.root)}
        if srdf is not None:
            from urdfkit.checks.xacro.prefixes_in_srdf import without_prefix  # imports MoveIt

            yield from without_prefix(context, srdf, argument, _PREFIX, names)
        lost = {name for name in suspects - names if f"{_PREFIX}{name}" in names}
        for name, span, element in _references(other.root, lost):
            written = _written(name, span, element.frame) or span
            yield Finding(
                Location(written, element.frame),
                f"'{name}' is called '{_PREFIX}{name}' if {argument} is '{_PREFIX}'; "
                f"<{element.tag}> names it without",
                f"write {_expression(argument, written.source)}{name}",
                related=tuple(_defined(root, name)),
            )
        suspects -= lost


def _names_without_parameter(root: Element) -> Findings:
    """Names that a macro writes out, but defines with one of its parameters."""
    defined: dict[CallFrame, dict[str, Attribute]] = {}
    for name, attribute in _definitions(root):
        frame = attribute.element.frame
        if frame and not attribute.literal and _has_parameter(attribute.span.text, frame):
            defined.setdefault(frame, {})[name] = attribute
    names = {name for of_call in defined.values() for name in of_call}
    for name, span, element in _references(root, names) if names else ():
        attribute_of = defined.get(element.frame, {}) if element.frame else {}
        if name in attribute_of and span.text.strip() == name:
            written = attribute_of[name].span
            yield Finding(
                Location(span, element.frame),
                f"'{name}' is defined as '{written.text}' in this macro; <{element.tag}> names it "
                "without the parameter",
                f"write {written.text}",
                related=(Related(written, "it is defined here"),),
            )


def _names_without_value(context: Context) -> Findings:
    """Names without the value of an argument that is not empty; REF001 needs all packages."""
    root = context.document.root
    defined = dict(_definitions(root))
    values = {**context.xacro.defaults, **context.arguments}
    lacking = {
        name[len(value) :]: (argument, value, at)
        for name, at in defined.items()
        for argument, value in values.items()
        if value.strip() and name.startswith(value) and name != value and not at.literal
    }
    for name, span, element in _references(root, lacking.keys() - defined.keys()):
        argument, value, at = lacking[name]
        written = _written(name, span, element.frame) or span
        yield Finding(
            Location(written, element.frame),
            f"'{name}' is called '{at.value}', because {argument} is '{value}'; <{element.tag}> "
            "names it without",
            f"write {_expression(argument, written.source)}{written.text.strip()}",
            related=(Related(at.span, "it is defined here"),),
        )


def _has_parameter(written: str, frame: CallFrame) -> bool:
    """True if an expression contains a parameter of the macro of a call."""
    spans = frame.definition.attribute_spans() if frame.definition else {}
    parameters = re.findall(r"[A-Za-z_]\w*", spans["params"].text) if "params" in spans else ()
    used = re.findall(r"[A-Za-z_]\w*", " ".join(re.findall(r"\$\{[^{}]*\}", written)))
    return not set(used).isdisjoint(parameters)


def _expression(argument: str, source: Source) -> str:
    """The value of an argument, as a file writes it: a macro without it has no such property."""
    used = re.search(rb"\$\{[^{}]*\b" + argument.encode() + rb"\b", source.data)
    return f"${{{argument}}}" if used else f"$(arg {argument})"


def _definitions(root: Element) -> Iterator[tuple[str, Attribute]]:
    """The names of links and joints, with their locations."""
    for element in root.children:
        attribute = element.attributes.get("name")
        if element.tag in _DEFINED and attribute:
            yield attribute.value, attribute


def _references(root: Element, names: set[str]) -> Iterator[tuple[str, Span, Element]]:
    """The uses of names: in attributes, and as the text of tags that refer to a link or a joint."""
    for element in root.walk():
        is_named = element.tag in _DEFINED and element.parent is not root
        for key in ("name", *_ATTRIBUTES) if is_named else _ATTRIBUTES:
            attribute = element.attributes.get(key)
            if attribute and attribute.value in names:
                yield attribute.value, attribute.span, element
        text = element.text.strip() if not element.children else ""
        if text in names and any(word in element.tag.lower() for word in _NAMING):
            yield text, element.tag_at.inner_span, element


def _written(name: str, span: Span, frame: CallFrame | None) -> Span | None:
    """The literal source of a name: the use itself, or the macro call that passes it."""
    if span.text.strip() == name:
        return span
    for call in frame.outwards() if frame else ():
        for given in call.call.attribute_spans().values():
            if given.text == name:
                return given
    return None


def _defined(root: Element, name: str) -> Iterator[Related]:
    for defined, at in _definitions(root):
        if defined == name:
            yield Related(at.span, "it is defined here")
