"""Nodes and parameters in launch files of XML."""

import os
import re
from itertools import pairwise

from urdfkit.ros.launch.collect import frame_at, path_from
from urdfkit.ros.launch.components import executable_of
from urdfkit.ros.launch.contents import (
    PARAMETERS,
    RVIZ,
    GivenParameters,
    StartedProgram,
    file_of,
    started_process,
    with_words,
)
from urdfkit.ros.launch.signature import arguments_in
from urdfkit.ros.launch.substitutions import unresolved
from urdfkit.ros.launch.xml_file import XmlLaunchFile
from urdfkit.text.diagnostic import Problem
from urdfkit.text.document import Attribute, CallFrame, Element
from urdfkit.text.source import Span

#: A list of names as YAML.
_LIST = re.compile(r"\s*\[([^\[\]]+)\]\s*")
_DESCRIPTION = re.compile(r"(^|/)\w*robot_description$")


def start_node(file: XmlLaunchFile, element: Element) -> None:
    """Read a ``<node>`` or ``<test>``, without its children."""
    program, arguments = _program(file, element), element.attributes.get("args")
    words = file.substitutions.words(arguments)
    if not program.package or "rviz" in program.package:
        for option, path in pairwise(word.text for word in words):
            if arguments and option in ("-d", "--display-config") and path:
                full_path = path_from(file.source, path)
                file.collector.file(full_path, arguments.span, RVIZ)
    executable = element.attributes.get("exec") or element.attributes.get("type")
    is_ros_2, texts = "type" not in element.attributes, [word.text for word in words]
    program = program._replace(
        executable=file.text(executable) or "",
        words=words,
        remappings=with_words(program.remappings, texts, is_ros_2=is_ros_2),
    )
    file.collector.start(program)


def start_component(file: XmlLaunchFile, element: Element) -> None:
    """Read a ``<composable_node>``, without its children."""
    executable = executable_of(file.text(element.attributes.get("plugin")))
    program = _program(file, element)._replace(executable=executable, is_component=True)
    file.collector.start(program)


def _program(file: XmlLaunchFile, element: Element) -> StartedProgram:
    """What nodes and composable nodes have in common."""
    return StartedProgram(
        _package(file, element),
        "",
        (),
        element.span,
        file.frame,
        is_sure=not file.unknown_conditions,
        remappings=_remappings(file, element),
        parameters=_parameters(file, element),
        namespace=_namespace(file, element),
        name=element.get("name") or "",
    )


def _package(file: XmlLaunchFile, element: Element) -> str:
    """The package of a node, which is recorded; empty if it is known only at run time."""
    attribute = element.attributes.get("pkg")
    name = file.text(attribute)
    if attribute and name:
        file.collector.started_package(name, file.source, attribute.span)
    return name or ""


def _remappings(file: XmlLaunchFile, node: Element) -> dict[str, str] | None:
    texts = [
        (file.text(remap.attributes.get("from")), file.text(remap.attributes.get("to")))
        for remap in node.all("remap")
    ]
    known = {old: new for old, new in texts if old and new}
    return known if len(known) == len(texts) else None


def _namespace(file: XmlLaunchFile, node: Element) -> str | None:
    written = node.attributes.get("namespace") or node.attributes.get("ns")
    text = file.text(written) if written else ""
    return None if text is None else text.strip("/")


def start_executable(file: XmlLaunchFile, element: Element) -> None:
    """Read an ``<executable>``: a program that is not a node."""
    words = file.substitutions.words(element.attributes.get("cmd"))
    is_sure = not file.unknown_conditions
    file.collector.start(started_process(words, element.span, file.frame, is_sure))


def _parameters(file: XmlLaunchFile, node: Element) -> GivenParameters:
    """The parameters of a node in ROS 2; in ROS 1 they do not belong to a node."""
    values: dict[str, str | None] = {}
    files: list[str] = []
    lists: dict[str, tuple[str | None, ...]] = {}
    at: dict[str, Span] = {}
    is_whole = file.ros == 2 and "ros_args" not in node.attributes
    for child in node.all("param"):
        source = child.attributes.get("from")
        if source is None:
            name, text = child.get("name") or "", file.text(child.attributes.get("value"))
            values[name] = text
            if (value := child.attributes.get("value")) and "type" not in child.attributes:
                at[name] = value.span
            if text and (match := _LIST.fullmatch(text)):
                lists[name] = tuple(item.strip(" '\"") for item in match.group(1).split(","))
            continue
        path = file.path(source)
        is_whole = is_whole and path is not None
        files += [path] if path else []
    return GivenParameters(values, tuple(files), is_whole, lists, at=at)


def read_param(file: XmlLaunchFile, element: Element) -> None:
    """Read a ``<param>``: a robot description, a parameter file, or the type of a controller."""
    written = element.attributes.get("name")
    # MoveIt's files have it in an argument.
    name = (file.text(written) or written.value).strip() if written else ""
    frame = frame_at(file.source, element.tag_at, file.frame)
    if name.endswith("/type"):  # of a controller, in ROS 1
        file.collector.names_parameters = True
    for key in ("command", "textfile", "value", "from"):
        attribute = element.attributes.get(key)
        if attribute is None:
            continue
        if key == "from":
            _parameter_file(file, attribute, "allow_substs")
        elif key == "textfile" and _DESCRIPTION.search(name):
            path = file.text(attribute)
            if path is not None:
                path = path_from(file.source, path)
                file.collector.description(path, {}, attribute.span, frame, is_expanded=False)
                file.collector.unexpanded(path, attribute.span, file.frame)
        elif _DESCRIPTION.search(name):
            _described(file, attribute, frame)
        elif purpose := file_of(name, _package_of(file, element)):
            _parameter_for_file(file, attribute, purpose)


def _parameter_for_file(file: XmlLaunchFile, attribute: Attribute, purpose: str) -> None:
    """Record the file of a parameter that names one; a relative path is known at run time."""
    path = file.text(attribute)
    if path and os.path.isabs(path):
        file.collector.file(path, attribute.span, purpose)


def _package_of(file: XmlLaunchFile, parameter: Element) -> str:
    """The package of the node of a parameter; empty if unknown."""
    node = parameter.parent
    return file.text(node.attributes.get("pkg")) or "" if node else ""


def _described(file: XmlLaunchFile, attribute: Attribute, frame: CallFrame) -> None:
    """Read the command of a robot description: an attribute, or ``$(command '...')`` in ROS 2."""
    text = attribute.value
    if attribute.name == "value":
        match = re.fullmatch(r"\s*\$\(command\s+(['\"])(.*)\1[^)]*\)\s*", text, re.DOTALL)
        if match is None:
            return
        text = match.group(2)
    command = file.substitutions.command_line(text, attribute.span)
    is_yaml = attribute.name == "value" and attribute.element.get("type") is None
    file.collector.command(command, attribute.span, frame, is_yaml=is_yaml)


def read_rosparam(file: XmlLaunchFile, element: Element) -> None:
    """Read a ``<rosparam>``: a parameter file, or parameters in the text of the element."""
    attribute = element.attributes.get("file")
    if element.get("command") not in (None, "load"):
        return
    if attribute:
        _parameter_file(file, attribute, "subst_value")
    if not attribute or "ns" in element.attributes or "param" in element.attributes:
        file.collector.names_parameters = True


def _parameter_file(file: XmlLaunchFile, attribute: Attribute, switch: str) -> None:
    """Read a parameter file; the attribute ``switch`` enables substitutions in it."""
    path = file.path(attribute)
    if path is None or not file.collector.file(path, attribute.span, PARAMETERS):
        return
    value = attribute.element.get(switch)
    if value not in (None, "false", "False", "0") or file.ros is None:
        return
    if substitution := unresolved(path, file.ros, file.collector.resolver):
        message = f"'{os.path.basename(path)}' contains {substitution}, which is not resolved"
        help = f'write {switch}="true"' + _undeclared(substitution, attribute.element)
        problem = Problem("LAU019", attribute.span, message, help, file.frame)
        file.collector.problems.append(problem)


def _undeclared(substitution: str, element: Element) -> str:
    """Help for a substitution of an undeclared argument, at which roslaunch stops."""
    if not substitution.startswith("$(arg "):
        return ""
    name = substitution[len("$(arg ") : -1]
    while element.parent is not None:
        element = element.parent
    is_declared = name in {argument.get("name") for argument in arguments_in(element)}
    return "" if is_declared else f', and declare <arg name="{name}"/>'
