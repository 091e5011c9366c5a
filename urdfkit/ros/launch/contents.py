"""The contents of a launch file."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import lru_cache
from itertools import pairwise

from urdfkit.core.record import Record
from urdfkit.text.diagnostic import Problem
from urdfkit.text.document import CallFrame, Location
from urdfkit.text.source import Source, Span

#: Name of a parameter file in messages.
PARAMETERS = "parameter file"
#: Name of a parameter file that a spawner gets, in messages.
SPAWNED = "parameter file of the spawner"
#: Name of a map description of Nav2 in messages.
MAP = "map"
#: Name of a file of MoveIt in messages.
MOVEIT = "MoveIt configuration"
#: Name of the topic file of ros_gz_bridge in messages.
BRIDGE = "bridge configuration"
#: Name of a map of slam_toolbox in messages.
POSE_GRAPH = "pose graph"
#: Name of a configuration of RViz in messages.
RVIZ = "RViz configuration"
#: Name of a launch file that another one includes, in messages.
INCLUDED = "included launch file"
#: Name of a path whose use is unknown, in messages.
MENTIONED = "path"
#: Parameters of nodes that name a file, and what the file is.
_FILE_PARAMETERS = {
    "yaml_filename": MAP,
    "config_file": BRIDGE,
    "map_file_name": POSE_GRAPH,
    "default_nav_to_pose_bt_xml": "behaviour tree",
    "default_nav_through_poses_bt_xml": "behaviour tree",
}

#: Packages whose programs read a bridge configuration; empty for an unknown one.
_BRIDGES = ("", "ros_gz_bridge", "ros_ign_bridge")

_COMMENT = re.compile(rb"<!--.*?(-->|\Z)", re.DOTALL)
#: The attribute and the tag of XML, and the key of YAML.
_EXEC = re.compile(rb"\bexec[\"']?\s*[=:]|<executable\b")

#: Greatest depth of nested includes.
MAX_DEPTH = 8
#: Most included files that are read from a launch file.
MAX_INCLUDED = 200


class LaunchedFile(Record):
    """A launch file with its arguments."""

    source: Source
    arguments: Mapping[str, str | None]  # None if known only at run time
    frame: CallFrame | None = None  # the launch files that include it
    #: Arguments that are given: by the user, or as literals by the including file.
    fixed: frozenset[str] = frozenset()


class LaunchedDescription(Record):
    """A robot description in a launch file."""

    path: str  # of the URDF or xacro
    arguments: dict[str, str]  # for xacro
    frame: CallFrame  # the launch file, for the expansion trace
    #: Names of the arguments that are known only at run time; "" stands for any name.
    unknown: tuple[str, ...] = ()
    #: True if launch parses it as YAML, as it does for parameters without a type.
    is_yaml: bool = False
    is_expanded: bool = True  # False if its text is used without xacro

    @property
    def is_whole(self) -> bool:
        """False if there are arguments that are known only at run time."""
        return not self.unknown


class FileUse(Record):
    """A file that a launch file references."""

    path: str  # with its expressions resolved; absolute
    exists: bool  # False if it is missing, or must not be read
    span: Span  # location of the reference
    purpose: str  # such as ``RViz configuration``
    is_outside: bool = False  # True if it exists, but must not be read

    @property
    def is_of_ros1(self) -> bool:
        """True for a ``<rosparam>``: in ROS 1 ``ros__parameters`` is a name like others."""
        return _is_in_rosparam(self.span)


class PackageUse(Record):
    """A package that a launch file references, and the searched directories if it is missing."""

    name: str
    span: Span
    searched: tuple[str, ...] | None
    is_only_started: bool = False  # True if the launch file starts its programs, and uses no file

    @property
    def has_parameters(self) -> bool:
        """True if a ``<rosparam>`` of ROS 1 loads a file of it."""
        return _is_in_rosparam(self.span)


def _is_in_rosparam(span: Span) -> bool:
    before = span.source.data[: span.start]
    return before[before.rfind(b"<") :].startswith(b"<rosparam")


class Word(Record):
    """A word of a command line; its text is None if known only at run time."""

    text: str | None
    span: Span

    @property
    def name(self) -> str:
        """The text as a name in ROS, without surrounding slashes; empty if unknown."""
        return (self.text or "").strip("/")


def file_of(parameter: str, package: str) -> str:
    """What the file is that a parameter of a program names, for messages; empty for no file."""
    purpose = _FILE_PARAMETERS.get(parameter, "")
    return "" if purpose == BRIDGE and package not in _BRIDGES else purpose


class GivenParameters(Record):
    """The parameters of a node."""

    values: Mapping[str, str | None]  # by name; None if known only at run time
    files: tuple[str, ...] = ()  # paths of parameter files
    is_whole: bool = True  # False if names of parameters are known only at run time
    lists: Mapping[str, tuple[str | None, ...]] = {}  # list parameters; None as above
    is_of_moveit: bool = False  # True if all unknown ones are from MoveItConfigsBuilder
    at: Mapping[str, Span] = {}  # of the values, by name

    @property
    def every(self) -> Mapping[str, str | None] | None:
        """All parameters by name; None if there are parameters in files or unknown ones."""
        return self.values if self.is_whole and not self.files else None


class StartedProgram(Record):
    """A program that a launch file starts."""

    package: str  # empty for a program that is not a node
    executable: str  # in the package; empty if unknown, or for a program
    words: tuple[Word, ...]  # of its command line; for a program, the first is its name
    span: Span  # location of the action
    frame: CallFrame | None  # the launch files that include it
    is_sure: bool = True  # False if it has a condition that is known only at run time
    #: Remapped names of topics, by original name; None if unknown.
    remappings: Mapping[str, str] | None = {}
    parameters: GivenParameters = GivenParameters({})  # passed to it
    namespace: str | None = ""  # without surrounding slashes; None if known only at run time
    name: str = ""  # of the node; empty if missing, or known only at run time
    is_component: bool = False  # True if a container loads it

    @property
    def key(self) -> str:
        """Its package and executable, as the catalogues name programs."""
        return f"{self.package}/{self.executable}"

    @property
    def title(self) -> str:
        """Its name for messages."""
        return self.name or self.executable

    @property
    def at(self) -> Location:
        """Location of the action."""
        return Location(self.span, self.frame)

    @property
    def is_ros_2(self) -> bool:
        """True if its launch file is in Python, or has ``exec``, which is ``type`` in ROS 1."""
        return _names_exec(self.span.source)

    @property
    def is_remapped(self) -> bool:
        """True if it remaps topics."""
        return self.remappings is None or bool(self.remappings)


def started_process(
    words: tuple[Word, ...], span: Span, frame: CallFrame | None, is_sure: bool
) -> StartedProgram:
    """The program of a command line, which is a node after ``ros2 run``."""
    texts = [word.text for word in words]
    package, executable = (*texts[2:4], None, None)[:2]
    if texts[:2] != ["ros2", "run"] or not package or not executable:
        return StartedProgram("", "", words, span, frame, is_sure)
    return StartedProgram(
        package,
        executable,
        words[4:],
        span,
        frame,
        is_sure,
        remappings=with_words({}, texts, is_ros_2=True),
        parameters=GivenParameters({}, is_whole=False),
    )


def with_words(
    remappings: Mapping[str, str] | None, words: Sequence[str | None], *, is_ros_2: bool
) -> Mapping[str, str] | None:
    """Remappings with those of a command line: ``--ros-args -r OLD:=NEW``, in ROS 1 ``OLD:=NEW``.

    None if some are unknown.
    """
    pairs = [word for word in words if word]
    if is_ros_2:
        options = words[words.index("--ros-args") :] if "--ros-args" in words else ()
        given = [pair for option, pair in pairwise(options) if option in ("-r", "--remap")]
        pairs = [pair for pair in given if pair]
        remappings = remappings if len(pairs) == len(given) else None
    if remappings is None:
        return None
    parts = (pair.partition(":=") for pair in pairs if ":=" in pair and pair[0] != "_")
    # The name of a topic may follow that of the node.
    return {**remappings, **{old.rpartition(":")[2]: new for old, _, new in parts}}


@lru_cache(1)
def _names_exec(source: Source) -> bool:
    """Cached for the thousands of programs of one file."""
    return source.path.endswith(".py") or bool(_EXEC.search(_COMMENT.sub(b"", source.data)))


class IncludedFile(Record):
    """An included launch file, whether it exists or not."""

    path: str  # with its expressions resolved; absolute
    arguments: Mapping[str, Word] | None  # visible to it; None if their names are unknown
    span: Span  # of the include
    frame: CallFrame | None  # the including launch files
    is_sure: bool = True  # False if its condition is known only at run time


class EnvironmentSetting(Record):
    """A variable of the environment that a launch file sets or extends."""

    name: str
    word: Word  # the value


class Launch(Record):
    """The contents of a launch file."""

    descriptions: tuple[LaunchedDescription, ...]
    #: files and packages: referenced ones, existing or not.
    files: tuple[FileUse, ...]
    packages: tuple[PackageUse, ...]
    problems: tuple[Problem, ...]  # of its text
    started: tuple[StartedProgram, ...]  # the programs that it starts
    included: tuple[StartedProgram, ...]  # the programs that its included files start
    unread: tuple[str, ...]  # paths of included files that were not read; "" if unknown
    #: True if it sets namespaces, remappings or parameters but ``use_sim_time`` for several nodes.
    has_scopes: bool
    sets_sim_time: bool  # True if it sets ``use_sim_time`` for several nodes
    #: True if it names parameters itself, in its text or by a namespace for a parameter file.
    names_parameters: bool
    includes: tuple[IncludedFile, ...] = ()  # its includes, and those of its included files
    #: Robots that MoveItConfigsBuilder reads, with arguments.
    configured: tuple[LaunchedDescription, ...] = ()
    #: Robots of MoveItConfigsBuilder that ros2_control gets, each with the file of its controllers;
    #: None stands for the parameter files of the launch file.
    built: tuple[tuple[LaunchedDescription, FileUse | None], ...] = ()
    environment: tuple[EnvironmentSetting, ...] = ()

    @property
    def programs(self) -> tuple[StartedProgram, ...]:
        """The programs that it starts, and those that its included files start."""
        return (*self.started, *self.included)

    @property
    def parameters(self) -> tuple[FileUse, ...]:
        return tuple(file for file in self.files if file.purpose == PARAMETERS)
