"""Launch files in XML, of ROS 1 and ROS 2, and in the YAML of ROS 2."""

import os
from collections.abc import Callable, Iterable, Mapping
from functools import partial

from urdfkit.core.suggest import is_typo
from urdfkit.ros.launch.argument_checks import (
    ArgumentUses,
    declares_others,
    is_included,
    missing_in_include,
    unknown_to_included,
)
from urdfkit.ros.launch.collect import SIM_TIME, Collector, frame_at
from urdfkit.ros.launch.contents import (
    INCLUDED,
    MAX_DEPTH,
    MAX_INCLUDED,
    EnvironmentSetting,
    IncludedFile,
    LaunchedFile,
    Word,
)
from urdfkit.ros.launch.markup import YAML, parsed
from urdfkit.ros.launch.signature import Signature, arguments_in, signature
from urdfkit.ros.launch.tags import SCOPES, dialect, without_effect, wrong_tags
from urdfkit.ros.launch.xml_file import XmlLaunchFile
from urdfkit.ros.launch.xml_nodes import (
    read_param,
    read_rosparam,
    start_component,
    start_executable,
    start_node,
)
from urdfkit.ros.node_parameters import node_parameters
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.document import Attribute, Element
from urdfkit.text.located_yaml import items, load
from urdfkit.text.source import Source, Span
from urdfkit.workspace.manifest import manifest_of

#: Greatest depth of nested groups.
MAX_LEVELS = 50
#: Most problems that are reported for a launch file.
MAX_PROBLEMS = 1000
#: Help for a file of another program with the suffix of a launch file.
_FOREIGN = "ignore this, or rename the file: launch files are recognised by name"
#: Usual actions of launch files.
_ACTIONS = ("arg", "group", "include", "let", "node")
#: Values that launch rejects.
_BROKEN = ("XML001", "XML002", "XAC013")


def read(collector: Collector, file: LaunchedFile) -> None:
    """Collect the contents of a launch file in XML or YAML, and of included files."""
    _XmlReader(collector, file, (), collector.outer).read()


class _XmlReader(XmlLaunchFile):
    """Reads a launch file and its included files.

    Args:
        inherited: arguments that the file may use without a declaration.
        outer: paths of the launch files that include it.
    """

    def __init__(
        self,
        collector: Collector,
        file: LaunchedFile,
        inherited: Iterable[str],
        outer: tuple[str, ...],
    ) -> None:
        super().__init__(collector, file)
        self._given = file.arguments
        self._outer = outer
        self._level = 0
        self._arguments = ArgumentUses({*file.arguments, *inherited})
        self._is_whole = True

    def read(self) -> None:
        document, problems = parsed(self.source)
        is_launch = document is not None and document.root.tag == "launch"
        is_yaml = self.source.path.endswith(YAML)
        broken = [problem for problem in problems if problem.code in _BROKEN]
        if self.source.data.startswith(b"#!"):
            self._foreign("it is a script")
        elif broken:
            self._unreadable(broken[0].span, broken[0].message)
        elif document is not None and document.root.tag == "launchConfiguration":
            self._foreign("<launchConfiguration> belongs to Eclipse")
        elif is_yaml and node_parameters(self.source):
            self._foreign("it contains node parameters")
        elif is_yaml and self._is_of_another_program():
            self._foreign("its root has other keys")
        elif not is_launch:
            root = "root key is not launch" if is_yaml else "root element is not <launch>"
            self._unreadable(Span(self.source, 0, 0), f"the {root}")
        if document is not None and is_launch:
            self.ros = 2 if is_yaml else dialect(document.root, self._ros_of_package)
            self._children(document.root)
            self.collector.problems += self._arguments.problems(
                self.frame,
                carries_over=self.ros == 2,
                is_sure=self._is_sure,
                is_lost=self.ros == 1 and bool(self._outer),
            )

    def _is_of_another_program(self) -> bool:
        """True for a YAML file with several keys, none of them similar to `launch` or an action.

        False in a directory of launch files, and for a file that another one includes.
        """
        directory = os.path.basename(os.path.dirname(os.path.abspath(self.source.path)))
        keys = [str(key) for key, _ in items(load(self.source))]
        is_of_ros = any(is_typo(key, "launch") or key in _ACTIONS for key in keys)
        return len(keys) > 1 and not (is_of_ros or self._outer or directory == "launch")

    def _unreadable(self, at: Span, reason: str) -> None:
        problem = Problem("LAU001", at, f"not a launch file: {reason}", frame=self.frame)
        self.collector.problems.append(problem)

    def _foreign(self, reason: str) -> None:
        """Report a file of another program with the suffix of a launch file."""
        at, message = Span(self.source, 0, 0), f"not a launch file of ROS: {reason}"
        problem = Problem("LAU001", at, message, _FOREIGN, self.frame, severity=Severity.INFO)
        self.collector.problems.append(problem)

    def _children(self, parent: Element) -> None:
        if self._level >= MAX_LEVELS:
            return
        self._level += 1
        if self.ros == 2:
            self.collector.problems += without_effect(parent, self.frame)
        handles: dict[str, Callable[[Element], None]] = {
            "arg": self._arg,
            "composable_node": self._component,
            "append_env": self._set_environment,
            "executable": partial(start_executable, self),
            "gz_server": self._action,
            "gz_spawn_model": self._action,
            "group": self._children,
            "include": self._include,
            "let": self._arg,
            "load_composable_node": self._children,
            "node": self._node,
            "node_container": self._children,
            "param": partial(read_param, self),
            "ros_gz_bridge": self._action,
            "rosparam": partial(read_rosparam, self),
            "set_env": self._set_environment,
            "test": self._node,
        }
        for element in parent.children:
            self._arguments.use(element, ("if", "unless"))
            if self.is_off(element):
                self._arguments.declare(e.get("name") or "" for e in arguments_in(element))
                self._switched_off(element)
                continue
            self._check(element)
            if self._is_scope(element):
                is_parameter = element.tag == "set_parameter" and element.get("name") == SIM_TIME
                self.collector.scope(of_sim_time=is_parameter or element.tag == "set_use_sim_time")
            self._mentions(element)
            if handle := handles.get(element.tag):
                is_unknown = self.has_unknown_condition(element)
                self.unknown_conditions += is_unknown
                handle(element)
                self.unknown_conditions -= is_unknown
        self._level -= 1

    def _switched_off(self, element: Element) -> None:
        """Read what other values of the arguments start, unless an including file gives them."""
        if self.frame:
            return
        self.unknown_conditions += 1
        if element.tag in ("node", "test"):
            self._node(element)
        elif element.tag == "include":
            attribute = element.attributes.get("file")
            if attribute and (path := self.path(attribute)):
                self.collector.file(path, attribute.span, INCLUDED)
        elif element.tag == "rosparam":
            self._mentions(element)  # its file may define what a node next to it starts
        elif element.tag == "group" and self._level < MAX_LEVELS:
            self._level += 1
            for child in element.children:
                self._switched_off(child)
            self._level -= 1
        self.unknown_conditions -= 1

    def _is_scope(self, element: Element) -> bool:
        """True for what applies to several nodes; an empty namespace does not."""
        namespaces = filter(None, map(element.attributes.get, ("ns", "namespace")))
        texts = [self.text(attribute) for attribute in namespaces]
        if texts and element.tag != "node":
            return any(text != "" for text in texts)
        return element.tag in SCOPES

    def _mentions(self, element: Element) -> None:
        """Record paths in packages whose use is unknown, such as the path of a world."""
        for attribute in element.attributes.values():
            if "$(find" in attribute.value:
                for word in (self.text(attribute) or "").split():
                    if os.path.isabs(word):
                        self.collector.mention(word, attribute.span)

    def _ros_of_package(self) -> int | None:
        manifest = manifest_of(self.collector.resolver, self.source.path)
        return manifest.ros if manifest else None

    def _check(self, element: Element) -> None:
        if self.ros is not None and len(self.collector.problems) < MAX_PROBLEMS:
            self.collector.problems += wrong_tags(element, self.ros, self.frame)
        self._arguments.use(element, element.attributes)

    def _is_sure(self) -> bool:
        """True if no other file can declare the arguments that this file uses."""
        return (self.ros == 1 or self._is_whole) and not self._may_inherit()

    def _may_inherit(self) -> bool:
        """True if other launch files may include this file and pass unknown arguments."""
        return not self._outer and is_included(self.source.path, self.collector.resolver)

    def _node(self, element: Element) -> None:
        start_node(self, element)
        self._children(element)

    def _set_environment(self, element: Element) -> None:
        name, value = element.get("name"), element.attributes.get("value")
        if name and value is not None:
            word = Word(self.text(value), value.span)
            self.collector.environment.append(EnvironmentSetting(name, word))

    def _component(self, element: Element) -> None:
        start_component(self, element)
        self._children(element)

    def _action(self, element: Element) -> None:
        """Read an action of ros_gz, which includes a launch file."""
        words = {
            name: Word(self.text(attribute), attribute.span)
            for name, attribute in element.attributes.items()
        }
        is_sure = not self.unknown_conditions
        self.collector.action(element.tag, words, element.span, self.frame, is_sure=is_sure)

    def _arg(self, element: Element) -> None:
        name = element.get("name") or ""
        self._arguments.declare([name])
        attribute = element.attributes.get("value") or element.attributes.get("default")
        if attribute and name not in self._given:
            value = self.text(attribute)
            if value is not None:
                self.values[name] = value

    def _include(self, element: Element) -> None:
        for child in element.children:
            is_misplaced = self.ros == 2 and child.tag in ("param", "remap")
            if is_misplaced or child.tag in ("arg", "env", "let"):  # roslaunch ignores other tags
                self._check(child)
        attribute = element.attributes.get("file")
        path = self.path(attribute) if attribute else None
        visible = self._visible(element)
        if path:
            is_sure = not self.unknown_conditions
            included = IncludedFile(path, visible, element.span, self.frame, is_sure)
            self.collector.include(included)
        if attribute and path and self.collector.file(path, attribute.span, INCLUDED):
            self._included(element, path, {name: word.text for name, word in visible.items()})
            return
        self.collector.not_read(path or "")
        self._is_whole = self._is_whole and not declares_others(path or "")

    def _included(self, element: Element, path: str, passed: Mapping[str, str | None]) -> None:
        source = self.collector.resolver.readable(path)
        if source is None:
            return
        if self.ros == 1 and path.endswith((".py", *YAML)):
            self._of_other_ros(element.attributes["file"], path)
            return
        taken = signature(source)
        self._is_whole = self._is_whole and taken.is_whole
        self._compare(element, taken, source)
        if self.ros == 2:
            self._arguments.declare(taken.names)  # an include declares them here, too
        frame = frame_at(self.source, element.tag_at, self.frame)
        if path.endswith((".py", *YAML)):
            is_sure = not self.unknown_conditions
            self.collector.follow(path, self.source, passed, frame, is_sure=is_sure)
            return
        here = (*self._outer, self.source.path)
        is_followed = path not in here and len(here) <= MAX_DEPTH
        self.collector.included += 1
        if not is_followed or self.collector.included > MAX_INCLUDED:
            self.collector.unread.append(path)
            return
        inherited = {child.get("name") or "" for child in element.children}
        if self._passes_all(element):
            inherited |= self._arguments.declared
        file = LaunchedFile(source, passed, frame)
        _XmlReader(self.collector, file, inherited, here).read()

    def _of_other_ros(self, attribute: Attribute, path: str) -> None:
        message = f"roslaunch reads only XML, but '{os.path.basename(path)}' is for ROS 2"
        help = "include a launch file of ROS 1, or write this file for ROS 2"
        problem = Problem("LAU010", attribute.span, message, help, self.frame)
        self.collector.problems.append(problem)
        self.collector.unread.append(path)

    def _passes_all(self, element: Element) -> bool:
        """True if an included file sees all arguments of this file."""
        return self.ros == 2 or element.get("pass_all_args") in ("true", "True", "1")

    def _compare(self, element: Element, taken: Signature, source: Source) -> None:
        """Report differences between the arguments of an include and those of the included file."""
        passed = [
            (name.value, name.span)
            for child in element.children
            if (name := child.attributes.get("name"))
            and child.tag == "arg"
            and not self.is_off(child)
        ]
        if element.get("pass_all_args"):
            return  # arguments of the command line are passed, too
        known = {name for name, _ in passed}
        if self.ros == 2:
            known |= self._arguments.declared
        problems = self.collector.problems
        problems += unknown_to_included(passed, taken, source, self.frame, ros=self.ros or 2)
        if self.ros == 1 or not self._may_inherit():
            problems += missing_in_include(known, taken, source, element.span, self.frame)

    def _visible(self, element: Element) -> dict[str, Word]:
        """The arguments that an included file sees, with their locations."""
        place = element.span
        own = self.values if self._passes_all(element) else {}
        visible = {name: Word(value, place) for name, value in own.items()}
        for child in element.children:
            attribute = child.attributes.get("value")
            if child.tag in ("arg", "let") and attribute and not self.is_off(child):
                visible[child.get("name") or ""] = Word(self.text(attribute), attribute.span)
        return visible
