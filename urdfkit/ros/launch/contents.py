"""What is found in a launch file."""

from __future__ import annotations

from collections.abc import Mapping

from urdfkit.core.record import Record
from urdfkit.text.diagnostic import Problem
from urdfkit.text.document import CallFrame
from urdfkit.text.source import Source, Span

#: What a file of parameters is called in messages.
PARAMETERS = "parameter file"
#: And the description of a map of Nav2.
MAP = "map"
#: And the file of the topics of ros_gz_bridge.
BRIDGE = "configuration of the bridge"

#: Launch files that include one another.
MAX_DEPTH = 8
#: Includes that are followed from one launch file.
MAX_INCLUDED = 200


class LaunchedFile(Record):
    """A launch file with the arguments that it is given."""

    source: Source
    arguments: Mapping[str, str | None]  # None for those that are known at run time only
    frame: CallFrame | None = None  # the launch files that led here


class LaunchedDescription(Record):
    """A robot description that a launch file makes."""

    path: str  # of the URDF or xacro
    arguments: dict[str, str]  # for xacro
    frame: CallFrame  # the launch file's place, for the chain of calls
    is_whole: bool = True  # False if it is given arguments that are known at run time only
    #: True if launch reads it as YAML, as it does with parameters without a type.
    is_yaml: bool = False
    is_expanded: bool = True  # False if its text is taken as it is, without xacro


class FileUse(Record):
    """A file that a launch file names."""

    text: str  # as written
    path: str  # with its expressions resolved; absolute
    exists: bool  # False if nothing is there, or nothing that may be read
    span: Span  # where it is named
    purpose: str  # such as ``RViz configuration``
    is_outside: bool = False  # True if it is there and may not be read


class PackageUse(Record):
    """A package that a launch file names, and the directories searched if it was not found."""

    name: str
    span: Span
    searched: tuple[str, ...] | None


class Word(Record):
    """A word of a command line; its text is None where it is known at run time only."""

    text: str | None
    span: Span


class GivenParameters(Record):
    """The parameters that a node is given."""

    values: Mapping[str, str | None]  # by name; None where a value is known at run time only
    files: tuple[str, ...] = ()  # the parameter files that hold others
    is_whole: bool = True  # False if there are more, whose names are known at run time only
    lists: Mapping[str, tuple[str | None, ...]] = {}  # those that are lists; None as above

    @property
    def every(self) -> Mapping[str, str | None] | None:
        """All of them by name; None if files or others give some."""
        return self.values if self.is_whole and not self.files else None


class StartedProgram(Record):
    """A program that a launch file starts."""

    package: str  # empty for a program that is no node
    executable: str  # in the package; empty if it is not known, or for a program
    words: tuple[Word, ...]  # of its command line; those of a program begin with its name
    span: Span  # where it is started
    frame: CallFrame | None  # the launch files that led there
    is_sure: bool = True  # False if a condition decides that is known at run time only
    #: The names that it gives to topics, by their own names; None where those are not known.
    remappings: Mapping[str, str] | None = {}
    parameters: GivenParameters = GivenParameters({})  # that it is given
    namespace: str | None = ""  # without slashes around it; None where it is known at run time only
    name: str = ""  # of the node; empty where none is given, or only at run time

    @property
    def is_remapped(self) -> bool:
        """True if it gives topics other names."""
        return self.remappings is None or bool(self.remappings)


class IncludedFile(Record):
    """A launch file that another one includes, at hand or not."""

    path: str  # with its expressions resolved; absolute
    arguments: Mapping[str, Word] | None  # that it sees; None if not even their names are known
    span: Span  # where it is included
    frame: CallFrame | None  # the launch files that led there
    is_sure: bool = True  # False if a condition decides that is known at run time only


class Launch(Record):
    """What a launch file needs."""

    descriptions: tuple[LaunchedDescription, ...]  # the robots it describes
    #: files and packages: that it names, found or not.
    files: tuple[FileUse, ...]
    packages: tuple[PackageUse, ...]
    #: What is wrong with its text, under the codes of the rules that explain it.
    problems: tuple[Problem, ...]
    started: tuple[StartedProgram, ...]  # the programs that it starts
    included: tuple[StartedProgram, ...]  # those that the files start which it includes
    #: Paths of the files that it includes and that were not read; empty if not known.
    unread: tuple[str, ...]
    has_scopes: bool  # True if it sets namespaces, parameters or remappings for several nodes
    #: True if it gives parameters names that are in no file, by a namespace for what is in a file,
    #: or in its own text.
    names_parameters: bool
    includes: tuple[IncludedFile, ...] = ()  # the files that it and those which it includes include

    @property
    def parameters(self) -> tuple[FileUse, ...]:
        return tuple(file for file in self.files if file.purpose == PARAMETERS)
