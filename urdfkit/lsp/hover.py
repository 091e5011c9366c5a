"""Hover texts: properties of a robot, origins of a value, explanations of a rule."""

import os
from collections.abc import Iterable, Iterator

from urdfkit.core.words import few, spaced
from urdfkit.errors import UnknownRule, UrdfkitError
from urdfkit.lint import rule_index
from urdfkit.lint.ignore_comments import ignores
from urdfkit.lsp.grammar import grammar_of
from urdfkit.lsp.markup import Cursor, Markup, TagNode, cursor
from urdfkit.lsp.names import NameUse, plugin_parameters
from urdfkit.lsp.open_robot import OpenRobot
from urdfkit.mesh.io.sniff import sniff_file
from urdfkit.robot.inertia import principal_moments
from urdfkit.robot.joint import DEGREES_OF_FREEDOM, Joint
from urdfkit.robot.link import Link
from urdfkit.ros.catalog import extensions, plugins
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.document import Attribute
from urdfkit.text.markdown import escape
from urdfkit.text.source import Span
from urdfkit.text.terminal import printable
from urdfkit.xacro.origin import Origin

#: Limit of the values of an expression, levels of origins, and other listed items.
MAX_SHOWN = 6
#: Size limit in bytes of a mesh that is measured for a hover.
MAX_MESH = 5_000_000


def hover(robot: OpenRobot, markup: Markup, offset: int, diagnostics: Iterable[Diagnostic]) -> str:
    """Markdown for an offset; empty without information."""
    here = cursor(markup, offset)
    parts = [*_values(robot, here), *_name(robot, markup, offset), *_mesh(robot, here)]
    parts += [*_plugin(here), *_grammar(here)]
    parts += _rules(markup, offset, diagnostics)
    return "\n\n---\n\n".join(parts)


# ---------------------------------------------------------------- expressions


def _values(robot: OpenRobot, here: Cursor) -> Iterator[str]:
    """The values of an expression, and their origins."""
    written = here.attribute
    if here.place != "value" or here.node is None or written is None or "$" not in written.value:
        return
    attributes = robot.expanded(here.node.source, here.node.start, written.name)
    values = list(dict.fromkeys(attribute.value for attribute in attributes))
    if not values:
        return
    shown = few([f"`{_code(value)}`" for value in values], MAX_SHOWN)
    lines = [f"**{escape(written.name)}** = {shown}"]
    if len(attributes) > 1:
        lines[0] += f" in {len(attributes)} calls"
    lines += _origins(robot, attributes[0])
    yield "\n".join(lines)


def _origins(robot: OpenRobot, attribute: Attribute) -> Iterator[str]:
    xacro = robot.traced
    stack = [(0, origin) for origin in reversed(xacro.inputs(attribute))] if xacro else []
    while stack:
        level, origin = stack.pop()
        yield f"{'  ' * level}- {_origin(origin)}"
        if level < MAX_SHOWN:
            stack += [(level + 1, deeper) for deeper in reversed(origin.inputs)]


def _origin(origin: Origin) -> str:
    text = f"`{_code(origin.name)}` = `{_code(origin.value)}`, {origin.kind}"
    if origin.text and origin.text != origin.value:
        text += f" `{_code(' '.join(origin.text.split()))}`"
    return f"{text} at {_place(origin.span)}" if origin.span else text


# ---------------------------------------------------------------------- names


def _name(robot: OpenRobot, markup: Markup, offset: int) -> Iterator[str]:
    name = robot.names.at(markup.source, offset)
    if name is None:
        return
    if name.kind in ("link", "joint", "frame"):
        yield from _link_or_joint(robot, name)
    elif name.kind == "macro":
        macro = robot.names.macros.get(name.text)
        if macro is not None:
            params = " ".join(macro.get("params").split())
            at = _place(macro.name_span)
            yield f"**macro** `{_code(name.text)}`({_code(params)}), defined at {at}"
    elif name.kind in ("property", "arg"):
        for use in robot.names.occurrences(name):
            if use.is_definition:
                text = use.node.get("value") or use.node.get("default")
                yield f"**{name.kind}** `{_code(name.text)}` = `{_code(text)}`, {_place(use.span)}"
    elif name.kind == "package":
        packages = robot.resolver.packages.known(markup.source.path)
        directory = packages.get(name.text)
        location = f"`{_code(directory)}`" if directory else "not found"
        yield f"**package** `{_code(name.text)}`: {location}"


def _link_or_joint(robot: OpenRobot, name: NameUse) -> Iterator[str]:
    model = robot.model
    if model is None:
        return
    for value in sorted(robot.names.values(name))[:MAX_SHOWN]:
        if name.kind != "joint" and (link := model.links_by_name.get(value)):
            yield "\n".join(_link(robot, link))
        elif name.kind != "link" and (joint := model.joints_by_name.get(value)):
            yield "\n".join(_joint(joint))


def _link(robot: OpenRobot, link: Link) -> Iterator[str]:
    yield f"**link** `{_code(link.name)}`"
    inertial = link.inertial
    if inertial is None or inertial.mass is None:
        yield "- no mass"
    else:
        x, y, z = inertial.origin.position
        yield f"- {link.mass:g} kg, centre of mass at {x:g} {y:g} {z:g} m"
    if inertial and inertial.tensor:
        tensor = inertial.tensor.value
        yield f"- ixx {tensor.ixx:g}, iyy {tensor.iyy:g}, izz {tensor.izz:g} kg·m²"
        a, b, c = principal_moments(tensor)
        yield f"- principal moments {a:.4g}, {b:.4g}, {c:.4g} kg·m²"
    for role, bodies in (("visual", link.visuals), ("collision", link.collisions)):
        shapes = [body.shape.kind for body in bodies if body.shape]
        if shapes:
            yield f"- {role}: {', '.join(shapes[:MAX_SHOWN])}"
    if robot.document is not None:
        for joint in robot.context.tree.parents.get(link.name, ())[:1]:
            kind, name = _kind(joint), _code(joint.name)
            yield f"- child of `{_code(joint.parent_name)}` by the {kind} joint `{name}`"


def _joint(joint: Joint) -> Iterator[str]:
    ends = [end or "?" for end in (joint.parent_name, joint.child_name)]
    kind, name = _kind(joint), _code(joint.name)
    yield f"**{kind} joint** `{name}`: `{_code(ends[0])}` to `{_code(ends[1])}`"
    if joint.axis and joint.kind != "fixed":
        yield "- axis " + spaced(joint.axis.value)
    limit = joint.limit
    unit, force = (joint.unit, joint.effort_unit) if joint.is_single_dof else ("", "")
    if limit and limit.lower and limit.upper:
        yield f"- from {limit.lower.value:g} to {limit.upper.value:g} {unit}"
    if limit and limit.effort and limit.velocity:
        yield f"- at most {limit.effort.value:g} {force} and {limit.velocity.value:g} {unit}/s"
    if (mimic := joint.mimic) and joint.leader:
        yield f"- follows `{_code(joint.leader)}` times {mimic.multiplier:g} plus {mimic.offset:g}"


# --------------------------------------------------------------------- meshes


def _mesh(robot: OpenRobot, here: Cursor) -> Iterator[str]:
    node, written = here.node, here.attribute
    if here.place != "value" or node is None or written is None or written.name != "filename":
        return
    if node.name not in ("mesh", "texture"):
        return
    values = robot.names.expanded(node, "filename") or [written.value]
    for value in values[:MAX_SHOWN]:
        yield "\n".join(_file(robot, node, value))


def _file(robot: OpenRobot, node: TagNode, reference: str) -> Iterator[str]:
    located = robot.resolver.locate(reference, node.source.path, robot.path)
    if located.path is None:
        missing = "no such file" if located.directory or not located.package else "no such package"
        yield f"**{escape(node.name)}** `{_code(reference)}`: {missing}"
        for tried in (located.tried or located.searched)[:MAX_SHOWN]:
            yield f"- tried `{_code(tried)}`"
        return
    yield f"**{escape(node.name)}** `{_code(located.path)}`"
    if node.name == "mesh":
        facts = sniff_file(located.path)
        yield f"- {facts.format or 'unknown format'}, {facts.size / 1024:.1f} KiB"
        if facts.defect:
            yield f"- {facts.defect.reason}"
        if facts.size <= MAX_MESH:
            yield from _measures(located.path)


def _measures(path: str) -> Iterator[str]:
    """Triangles and size, if the extra for meshes is installed."""
    try:
        from urdfkit.mesh.describe import describe

        mesh = describe(path)
    except (ImportError, UrdfkitError):  # some formats need more libraries than others
        return
    size = " x ".join(f"{high - low:.4g}" for low, high in zip(mesh.low, mesh.high, strict=True))
    yield f"- {mesh.health.faces} triangles, {size} m"
    yield f"- {'a closed solid' if mesh.health.is_solid else 'not a closed solid'}"


# --------------------------------------------------------- tags and attributes


def _plugin(here: Cursor) -> Iterator[str]:
    """The description of a Gazebo plugin, or of its parameter."""
    node = here.node
    if node is None:
        return
    if here.place == "value" and here.attribute and node.name == "plugin":
        if here.attribute.name == "filename":
            for entry in plugins.find(here.attribute.value.strip()):
                origin = "not in" if entry.removed else f"of {entry.package},"
                text = f"**plugin** {origin} {entry.generation}"
                successor = f"; replaced by `{entry.successor}`" if entry.successor else ""
                yield text + successor
        return
    for entry, parameter in plugin_parameters(node) if here.place == "tag" else ():
        words = [parameter.type] + ["required"] * parameter.required
        if parameter.default:
            words.append(f"`{_code(parameter.default)}` by default")
        yield f"**{escape(node.name)}** ({entry.generation}): {', '.join(words)}"


def _grammar(here: Cursor) -> Iterator[str]:
    """The type of a URDF attribute, or the type and unit of a Gazebo extension."""
    node = here.node
    if here.place == "attribute" and node is not None and here.attribute is not None:
        grammar = grammar_of(node)
        rule = grammar.attributes.get(here.attribute.name) if grammar else None
        if rule is not None:
            yield f"**{here.attribute.name}**: {rule.type}" + ", required" * rule.required
    elif here.place == "tag" and node is not None and node.ancestor("gazebo"):
        extension = extensions.extensions().get(node.name)
        if extension is not None and not node.ancestor("plugin", "sensor"):
            unit = f" in {extension.unit}" if extension.unit else ""
            yield f"**{escape(node.name)}** for a {extension.on}: {extension.type}{unit}"


# ---------------------------------------------------------------------- rules


def _rules(markup: Markup, offset: int, diagnostics: Iterable[Diagnostic]) -> Iterator[str]:
    """The explanations of the rules with findings at an offset, or in an ignore comment there."""
    codes = [each.code for each in diagnostics if each.span.start <= offset <= max(each.span[1:])]
    for comment in ignores(markup.source):
        codes += [code for code, span in comment.codes if span.start <= offset <= span.end]
    for code in list(dict.fromkeys(codes))[:MAX_SHOWN]:
        try:
            rule = rule_index.find_rule(code)
        except UnknownRule:
            continue
        text = f"**{rule.code}** {rule.name}\n\n{rule.explanation}"
        yield text + (f"\n\nHelp: {escape(rule.help)}." if rule.help else "")


def _place(span: Span) -> str:
    return f"`{_code(os.path.basename(span.source.path))}:{span.line}:{span.column}`"


def _code(text: str) -> str:
    """A text for a code span in Markdown."""
    text = printable(" ".join(text.split())).replace("`", "'")
    return text if len(text) <= 200 else text[:200] + "..."


def _kind(joint: Joint) -> str:
    """The type of a joint, as code if it is unknown."""
    types = (*DEGREES_OF_FREEDOM, "fixed")
    return joint.kind if joint.kind in types else f"`{_code(joint.kind)}`"
