"""Launch files in XML, of ROS 1 and ROS 2."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfkit.document import Attribute, Element, Frame
from urdfkit.errors import UnreadableFile
from urdfkit.launch.collect import UNKNOWN, Collector, frame_at
from urdfkit.launch.found import MAX_DEPTH, PARAMETERS, Launch
from urdfkit.reading import Problem, read_xml
from urdfkit.source import Source, Span
from urdfkit.workspace.resolve import Resolver

_RVIZ = re.compile(r"(?:^|\s)(?:-d|--display-config)\s+(\S+)")
#: What launch refuses to read.
_BROKEN = ("XML001", "XML002", "XML006", "XAC013")
_DESCRIPTION = re.compile(r"(^|/)\w*robot_description$")


def read(source: Source, resolver: Resolver, arguments: dict[str, str]) -> Launch:
    """What a launch file in XML needs; files that it includes are followed."""
    collector = Collector(resolver)
    _File(collector, source, arguments, None, 0).read()
    return collector.launch()


class _File:
    """One launch file, with the values of its arguments."""

    def __init__(
        self,
        collector: Collector,
        source: Source,
        arguments: dict[str, str],
        frame: Frame | None,
        depth: int,
    ) -> None:
        self.collector = collector
        self.source = source
        self.given = dict(arguments)
        self.values: dict[str, str] = dict(arguments)
        self.frame = frame
        self.depth = depth

    def read(self) -> None:
        document, problems = read_xml(self.source)
        is_launch = document is not None and document.root.tag == "launch"
        broken = [problem for problem in problems if problem.code in _BROKEN]
        if broken:
            self._unreadable(broken[0].span, broken[0].message)
        elif not is_launch:
            self._unreadable(Span(self.source, 0, 0), "the root element is not <launch>")
        if document is not None and is_launch:
            self._children(document.root)

    def _unreadable(self, at: Span, reason: str) -> None:
        problem = Problem("LAU001", at, f"not a launch file: {reason}", frame=self.frame)
        self.collector.problems.append(problem)

    def _children(self, parent: Element) -> None:
        for element in parent.children:
            if self._is_off(element):
                continue
            handle = getattr(self, f"_{element.tag.replace('-', '_')}", None)
            if handle is not None:
                handle(element)

    def _is_off(self, element: Element) -> bool:
        """True if a condition says so; what cannot be known counts as on."""
        for name, off in (("if", ("false", "0")), ("unless", ("true", "1"))):
            attribute = element.attributes.get(name)
            if attribute and (self.text(attribute) or "").strip().lower() in off:
                return True
        return False

    # ------------------------------------------------------------- elements

    def _group(self, element: Element) -> None:
        self._children(element)

    def _arg(self, element: Element) -> None:
        name = element.get("name") or ""
        attribute = element.attributes.get("value") or element.attributes.get("default")
        if attribute and name not in self.given:
            value = self.text(attribute)
            if value is not None:
                self.values[name] = value

    _let = _arg

    def _include(self, element: Element) -> None:
        attribute = element.attributes.get("file")
        path = self.text(attribute) if attribute else None
        if attribute is None or path is None:
            return
        path = self._path(path)
        if not self.collector.file(path, attribute.span, "the included launch file"):
            return
        if self.depth < MAX_DEPTH and not path.endswith(".py"):
            arguments = self._passed(element)
            frame = frame_at(self.source, element.tag_at, self.frame)
            try:
                source = self.collector.resolver.read(path)
            except UnreadableFile:
                return
            _File(self.collector, source, arguments, frame, self.depth + 1).read()

    def _passed(self, element: Element) -> dict[str, str]:
        passed: dict[str, str] = {}
        for child in element.children:
            attribute = child.attributes.get("value")
            if child.tag in ("arg", "let") and attribute:
                value = self.text(attribute)
                if value is not None:
                    passed[child.get("name") or ""] = value
        return passed

    def _param(self, element: Element) -> None:
        name = (element.get("name") or "").strip()
        frame = frame_at(self.source, element.tag_at, self.frame)
        for key in ("command", "textfile", "value", "from"):
            attribute = element.attributes.get(key)
            if attribute is None:
                continue
            if key == "from":
                self._named_file(attribute, PARAMETERS)
            elif key == "textfile" and _DESCRIPTION.search(name):
                path = self.text(attribute)
                if path is not None:
                    self.collector.description(self._path(path), {}, attribute.span, frame)
            elif _DESCRIPTION.search(name):
                self._described(attribute, frame)

    def _described(self, attribute: Attribute, frame: Frame) -> None:
        """The command of a robot description: ROS 1's attribute, ROS 2's ``$(command '...')``."""
        text = attribute.value
        if attribute.name == "value":
            found = re.fullmatch(r"\s*\$\(command\s+(['\"])(.*)\1[^)]*\)\s*", text, re.DOTALL)
            if found is None:
                return
            text = found.group(2)
        command = self._substituted(text, attribute.span)
        if command is not None:
            self.collector.command(command, attribute.span, frame)

    def _node(self, element: Element) -> None:
        package = element.attributes.get("pkg")
        name = self.text(package) if package else None
        if package and name:
            self.collector.package(name, self.source, package.span)
        arguments = element.attributes.get("args")
        if arguments:
            found = _RVIZ.search(self.text(arguments) or "")
            if found:
                path = self._path(found.group(1))
                self.collector.file(path, arguments.span, "the RViz configuration")
        self._children(element)

    def _rosparam(self, element: Element) -> None:
        attribute = element.attributes.get("file")
        if attribute and element.get("command") in (None, "load"):
            self._named_file(attribute, PARAMETERS)

    def _named_file(self, attribute: Attribute, purpose: str) -> None:
        path = self.text(attribute)
        if path is not None:
            self.collector.file(self._path(path), attribute.span, purpose)

    def _path(self, text: str) -> str:
        return os.path.normpath(
            os.path.join(os.path.dirname(os.path.abspath(self.source.path)), text)
        )

    # -------------------------------------------------------- substitutions

    def text(self, attribute: Attribute) -> str | None:
        """The value of an attribute; None where it cannot be known without running it."""
        return self._substituted(attribute.value, attribute.span)

    def _substituted(self, text: str, span: Span) -> str | None:
        parts: list[str] = []
        for is_command, part in _pieces(text):
            value = self._command(part, span) if is_command else part
            if value is None:
                return None
            parts.append(value)
        return "".join(parts)

    def _command(self, content: str, span: Span) -> str | None:
        inner = self._substituted(content, span)
        words = inner.split(None, 1) if inner else []
        if not words:
            return None
        command, rest = words[0], words[1].strip() if len(words) > 1 else ""
        if command in ("find", "find-pkg-share", "find-pkg-prefix"):
            # Only the file in the package matters; that xacro itself is installed does not.
            found = self.collector.package(rest, self.source, span)
            return found if found is not None else f"{UNKNOWN}/{rest}"
        if command in ("arg", "var"):
            return self.values.get(rest)
        if command == "dirname":
            return os.path.dirname(os.path.abspath(self.source.path))
        if command in ("optenv", "env"):
            default = rest.split(None, 1)
            return default[1].strip("'\"") if len(default) > 1 else None
        return None  # eval, anon, exec-in-pkg, command


def _pieces(text: str) -> Iterator[tuple[bool, str]]:
    """The text outside of ``$(...)``, and the contents of those, nested ones kept whole."""
    start = position = 0
    while (opening := text.find("$(", position)) >= 0:
        depth, end = 0, opening
        for end in range(opening, len(text)):
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            if text[end] == ")" and depth == 0:
                break
        else:
            break
        if opening > start:
            yield False, text[start:opening]
        yield True, text[opening + 2 : end]
        start = position = end + 1
    if start < len(text):
        yield False, text[start:]
