"""Collects packages, files and xacro command lines of launch files of all formats."""

import os
import re
from collections.abc import Callable, Iterator, Mapping
from typing import TypeAlias

from urdfkit.core import disk
from urdfkit.core.paths import is_within
from urdfkit.core.suggest import is_typo
from urdfkit.errors import PackageNotFound
from urdfkit.ros.launch.bridges import config_file
from urdfkit.ros.launch.command_line import UNKNOWN_PART, command_words
from urdfkit.ros.launch.command_options import wrong_options
from urdfkit.ros.launch.contents import (
    BRIDGE,
    MAP,
    MAX_DEPTH,
    MAX_INCLUDED,
    MENTIONED,
    PARAMETERS,
    SPAWNED,
    EnvironmentSetting,
    FileUse,
    IncludedFile,
    Launch,
    LaunchedDescription,
    LaunchedFile,
    PackageUse,
    StartedProgram,
    Word,
)
from urdfkit.ros.launch.forwarding import file_of_action, forwarded_nodes, is_forwarding
from urdfkit.ros.launch.known_packages import shipped_nodes, wrong_references
from urdfkit.ros.launch.spawned_controllers import parameter_files
from urdfkit.text.comments import blank_comments
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.document import CallFrame, Tag
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

#: Shorter names of files may differ by a letter: ``a.yaml``, ``b.yaml``.
_MIN_STEM = 4
#: The directory of a package that was not found; files in it are not checked.
UNKNOWN = "/package-not-found"
#: The parameter of all nodes that remappings and namespaces do not concern.
SIM_TIME = "use_sim_time"

_FORMER = "xacro.py"
_XACRO = ("xacro", _FORMER)
_EXPAND = "pass it through the xacro command, or write xacro.process_file(path).toxml() in Python"
#: What only xacro reads: URDF parsers ignore a property, an argument and a macro that is not used.
_NEEDS_XACRO = re.compile(rb"<xacro:(?!(?:property|arg|macro)\b)|\$[{(]").search
#: Reads a launch file of any format.
Reader: TypeAlias = "Callable[[Collector, LaunchedFile], None]"


class Collector:
    """Collects the contents of launch files while they are read.

    Args:
        reader: reads launch files of any format.
        outer: paths of the including launch files.
        included: number of included files so far.
    """

    def __init__(
        self, resolver: Resolver, reader: Reader, outer: tuple[str, ...] = (), included: int = 0
    ) -> None:
        self.resolver = resolver
        self._reader = reader
        self.outer = outer
        self.descriptions: list[LaunchedDescription] = []
        #: Robots that MoveIt gets, which another launch file may start.
        self.configured: list[LaunchedDescription] = []
        self.built: list[tuple[LaunchedDescription, FileUse | None]] = []
        self.files: list[FileUse] = []
        self.optional: set[str] = set()  # paths that a program looks for before it uses them
        self.packages: dict[str, PackageUse] = {}
        self.problems: list[Problem] = []
        self.started: list[StartedProgram] = []
        self.started_by_included: list[StartedProgram] = []
        self.environment: list[EnvironmentSetting] = []
        self.unread: list[str] = []
        self.has_scopes = self.sets_sim_time = False
        self.includes: list[IncludedFile] = []
        self.names_parameters = False
        self.included = included

    def scope(self, *, of_sim_time: bool) -> None:
        """Note an action that applies to the nodes after it."""
        self.has_scopes = self.has_scopes or not of_sim_time
        self.sets_sim_time = self.sets_sim_time or of_sim_time

    def package(self, name: str, source: Source, span: Span) -> str | None:
        """The directory of a package; records that its files are needed."""
        return self._package(name, source, span)

    def started_package(self, name: str, source: Source, span: Span) -> None:
        """Record that a program of a package is needed."""
        self._package(name, source, span, is_only_started=True)

    def _package(
        self, name: str, source: Source, span: Span, *, is_only_started: bool = False
    ) -> str | None:
        if "/" in name and name[:1].isalpha():
            self._path_as_package(name, span)
            return None
        try:
            directory: str | None = self._built(name, source.path)
            searched = None
        except PackageNotFound as error:
            directory, searched = None, error.searched
        use = PackageUse(name, span, searched, is_only_started)
        first = self.packages.setdefault(name, use)
        if first.is_only_started and not is_only_started:
            self.packages[name] = first._replace(is_only_started=False)
        return directory

    def _built(self, name: str, path: str) -> str:
        """The directory of a package, as a build finds it.

        A directory around the package of the launch file is none if it only has the name.
        """
        packages, directory = self.resolver.packages, self.resolver.package(name, path)
        own = packages.enclosing(path)
        is_around = own is not None and own[1] != directory and is_within(own[1], directory)
        if is_around and packages.name_of(directory) is None and name not in packages.explicit:
            raise PackageNotFound(name, packages.searched(name, path))
        return directory

    def _path_as_package(self, name: str, span: Span) -> None:
        """Report a path in place of the name of a package."""
        package, _, rest = name.partition("/")
        message = f"'{name}' is a path, not the name of a package"
        help = f"name only the package '{package}', and write /{rest} after the substitution"
        problem = Problem("LAU010", span, message, help, severity=Severity.ERROR)
        if problem not in self.problems:
            self.problems.append(problem)

    def file(self, path: str, span: Span, purpose: str) -> bool:
        """Record that a file is needed; True if it exists and is readable."""
        if path.startswith(f"{UNKNOWN}/"):
            return False  # its package is reported already
        location = path if disk.exists(path) else self.resolver.installed(path)
        is_outside = location is not None and not self.resolver.admits(location)
        exists = location is not None and not is_outside
        self.files.append(FileUse(path, exists, span, purpose, is_outside))
        return exists

    def start(self, node: StartedProgram) -> None:
        """Record a node that is started, and the file that its command line names."""
        self.started.append(node)
        config = config_file(node.words)
        if config and config.text and os.path.isabs(config.text):
            self.file(config.text, config.span, BRIDGE)
        for word in parameter_files(node):
            if word.text and os.path.isabs(word.text):
                purpose = PARAMETERS if disk.exists(word.text) else SPAWNED
                self.file(word.text, word.span, purpose)

    def include(self, file: IncludedFile) -> None:
        """Record an included launch file; if it is missing but known, the nodes that it starts."""
        self.includes.append(file)
        if disk.exists(file.path):
            return
        nodes = list(shipped_nodes(file))
        self.started_by_included += (*nodes, *self._forwarded(file))
        passed = {word.text: word.span for word in (file.arguments or {}).values()}
        for path in dict.fromkeys(path for node in nodes for path in node.parameters.files):
            self.file(path, passed[path], PARAMETERS)
        map = (file.arguments or {}).get("map") if "/nav2_bringup/" in file.path else None
        if map and map.text and os.path.isabs(map.text):
            self.file(map.text, map.span, MAP)

    def _forwarded(self, file: IncludedFile) -> Iterator[StartedProgram]:
        """The nodes to which an included launch file passes its arguments."""
        for node in forwarded_nodes(file):
            path = node.parameters.values.get("config_file")
            if path and os.path.isabs(path):
                self.file(path, node.parameters.at["config_file"], BRIDGE)
            yield node

    def action(
        self,
        name: str,
        arguments: Mapping[str, Word] | None,
        span: Span,
        frame: CallFrame | None,
        *,
        is_sure: bool,
    ) -> None:
        """Record an action that includes a launch file of ros_gz, by its class or its tag."""
        path = file_of_action(name)
        self.package(path.partition("/")[0], span.source, span)
        self.include(IncludedFile(f"{UNKNOWN}/{path}", arguments, span, frame, is_sure))

    def not_read(self, path: str) -> None:
        """Note an included launch file whose contents are unknown."""
        if not is_forwarding(path):
            self.unread.append(path)

    def mention(self, path: str, span: Span) -> None:
        """Record a path in a package whose use is unknown, if it exists or is misspelt.

        A path that leaves its package leads elsewhere when the package is installed.
        """
        package = self.resolver.packages.enclosing(path.partition(f"{os.sep}{os.pardir}")[0])
        path, written_path = os.path.normpath(path), path
        if package is None or _leaves(written_path, package[1]):
            return
        exists = disk.exists(path)
        if exists or _is_misspelt(path):
            self.files.append(FileUse(path, exists, span, MENTIONED))

    def command(self, text: str, span: Span, frame: CallFrame, *, is_yaml: bool = False) -> None:
        """Read a shell command whose output is the robot description, or its YAML.

        Args:
            text: with ``UNKNOWN_PART`` for each part that is known only at run time.
        """
        self.expand(command_words(text), span, frame, is_yaml=is_yaml)

    def expand(
        self, words: list[str], span: Span, frame: CallFrame, *, is_yaml: bool = False
    ) -> None:
        """Read the words of such a command."""
        while words and os.path.basename(words[0]) in ("ros2", "run", "rosrun", "exec"):
            words = words[1:]
        if len(words) > 1 and words[0] == words[1] == "xacro":
            words = words[1:]  # rosrun xacro xacro
        if not words or os.path.basename(words[0]) not in (*_XACRO, "cat"):
            return
        if os.path.basename(words[0]) == _FORMER and frame.outer is None:
            message = f"{_FORMER} was removed in ROS Noetic and does not exist in ROS 2"
            severity = Severity.WARNING if span.source.path.endswith(".py") else Severity.INFO
            self.problems.append(Problem("LAU003", span, message, "write xacro", severity=severity))
        files = [word for word in words[1:] if ":=" not in word and not word.startswith("-")]
        arguments: dict[str, str | None] = {}
        for name, is_argument, value in (word.partition(":=") for word in words[1:]):
            if is_argument:
                arguments[name] = None if UNKNOWN_PART in name + value else value
        if len(files) == 1 and UNKNOWN_PART not in files[0]:
            is_expanded = os.path.basename(words[0]) in _XACRO
            if not is_expanded:
                self.unexpanded(files[0], span, frame)
            self.description(
                files[0], arguments, span, frame, is_yaml=is_yaml, is_expanded=is_expanded
            )

    def description(
        self,
        path: str,
        arguments: Mapping[str, str | None],
        span: Span,
        frame: CallFrame,
        *,
        is_yaml: bool = False,
        is_expanded: bool = True,
    ) -> None:
        """Record a robot description with its arguments, which are None if unknown.

        A path in a package that was not found is unknown, too.
        """
        if self.file(path, span, "robot description"):
            if not disk.exists(path):
                path = self.resolver.installed(path) or path
            known = {
                name: value
                for name, value in arguments.items()
                if value is not None and f"{UNKNOWN}/" not in value
            }
            unknown = tuple(name for name in arguments if name not in known)
            description = LaunchedDescription(path, known, frame, unknown, is_yaml, is_expanded)
            self.descriptions.append(description)

    def unexpanded(self, path: str, span: Span, frame: CallFrame | None) -> None:
        """Record a file that is used unexpanded; reported if xacro must expand it."""
        if not disk.exists(path) or not self.resolver.admits(path):
            return
        source = self.resolver.readable(path)
        if source and b"<xacro:" in source.data and needs_xacro(source):
            message = f"'{os.path.basename(path)}' is a xacro file, but is used without expansion"
            self.problems.append(Problem("LAU015", span, message, _EXPAND, frame))

    def follow(
        self,
        path: str,
        source: Source,
        arguments: Mapping[str, str | None],
        frame: CallFrame,
        *,
        is_sure: bool = True,
        fixed: frozenset[str] = frozenset(),
    ) -> None:
        """Add the robots, parameters and programs of an included launch file.

        Other contents are reported when the file itself is checked.

        Args:
            arguments: passed arguments; None if known only at run time.
            is_sure: False if the include has a condition that is known only at run time.
            fixed: names of the arguments that are literals.
        """
        outer = (*self.outer, source.path)
        if path in outer or len(outer) > MAX_DEPTH or self.included >= MAX_INCLUDED:
            return
        included_source = self.resolver.readable(path)
        if included_source is None:
            return
        inner = Collector(self.resolver, self._reader, outer, self.included + 1)
        self._reader(inner, LaunchedFile(included_source, arguments, frame, fixed))
        self.included = inner.included
        self.unread += inner.unread
        self.has_scopes = self.has_scopes or inner.has_scopes
        self.sets_sim_time = self.sets_sim_time or inner.sets_sim_time
        self.started_by_included += (
            program._replace(is_sure=program.is_sure and is_sure)
            for program in (*inner.started, *inner.started_by_included)
        )
        self.includes += (
            file._replace(is_sure=file.is_sure and is_sure) for file in inner.includes
        )
        self.descriptions += inner.descriptions
        self.files += (file for file in inner.files if file.purpose == PARAMETERS and file.exists)
        self.names_parameters = self.names_parameters or inner.names_parameters
        self.environment += inner.environment

    def launch(self) -> Launch:
        self.problems += wrong_references(self.started, self.includes, self.resolver)
        for program in self.started:
            self.problems += wrong_options(program)
        return Launch(
            tuple(self.descriptions),
            tuple(file for file in self.files if file.exists or file.path not in self.optional),
            tuple(self.packages.values()),
            tuple(self.problems),
            tuple(self.started),
            tuple(self.started_by_included),
            tuple(self.unread),
            self.has_scopes,
            self.sets_sim_time,
            self.names_parameters,
            tuple(self.includes),
            tuple(self.configured),
            tuple(self.built),
            tuple(self.environment),
        )


def needs_xacro(source: Source) -> bool:
    """True for a robot that URDF parsers do not read unless xacro expands it."""
    return _NEEDS_XACRO(blank_comments(source.data)) is not None


def frame_at(source: Source, tag: Tag, outer: CallFrame | None) -> CallFrame:
    """The trace step from a launch file to its contents."""
    return CallFrame("launch", os.path.basename(source.path), tag, None, outer)


def path_from(source: Source, text: str) -> str:
    """A path as launch resolves it: absolute, or relative to the launch file."""
    directory = os.path.dirname(os.path.abspath(source.path))
    return os.path.normpath(os.path.join(directory, text))


def _is_misspelt(path: str) -> bool:
    """True for the path of a missing file that differs by a letter from another one."""
    directory, name = os.path.split(path)
    stem, kind = os.path.splitext(name)
    others = disk.names_or_empty(directory) if kind and len(stem) >= _MIN_STEM else ()
    return any(other.endswith(kind) and is_typo(name, other) for other in others)


def _leaves(path: str, directory: str) -> bool:
    """True if a part of a path leads out of a directory, even if the path returns to it."""
    parts = path.split(os.sep)
    ends = (end for end, part in enumerate(parts, 1) if part == os.pardir)
    return any(not is_within(os.path.normpath(os.sep.join(parts[:end])), directory) for end in ends)
