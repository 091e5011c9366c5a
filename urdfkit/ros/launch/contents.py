"""What is found in a launch file."""

from __future__ import annotations

from collections.abc import Mapping

from urdfkit.core.record import Record
from urdfkit.text.diagnostic import Problem
from urdfkit.text.document import CallFrame
from urdfkit.text.source import Span

#: What a file of parameters is called in messages.
PARAMETERS = "parameter file"

#: Launch files that include one another.
MAX_DEPTH = 8
#: Includes that are followed from one launch file.
MAX_INCLUDED = 200


class LaunchedDescription(Record):
    """A robot description that a launch file makes.

    Attributes:
        path: of the URDF or xacro.
        arguments: for xacro.
        frame: the launch file's place, for the chain of calls.
        is_whole: False if it is given arguments that are known at run time only.
        is_yaml: True if launch reads it as YAML, as it does with parameters without a type.
    """

    path: str
    arguments: dict[str, str]
    frame: CallFrame
    is_whole: bool = True
    is_yaml: bool = False


class FileUse(Record):
    """A file that a launch file names.

    Attributes:
        text: as written.
        path: with its expressions resolved; absolute.
        exists: False if nothing is there, or nothing that may be read.
        span: where it is named.
        purpose: such as ``RViz configuration``.
        is_outside: True if it is there and may not be read.
    """

    text: str
    path: str
    exists: bool
    span: Span
    purpose: str
    is_outside: bool = False


class PackageUse(Record):
    """A package that a launch file names, and the directories searched if it was not found."""

    name: str
    span: Span
    searched: tuple[str, ...] | None


class Word(Record):
    """A word of a command line; its text is None where it is known at run time only."""

    text: str | None
    span: Span


class Parameters(Record):
    """The parameters that a node is given.

    Attributes:
        values: by name; None where a value is known at run time only.
        files: the parameter files that hold others.
        is_whole: False if there are more, whose names are known at run time only.
    """

    values: Mapping[str, str | None]
    files: tuple[str, ...] = ()
    is_whole: bool = True

    @property
    def every(self) -> Mapping[str, str | None] | None:
        """All of them by name; None if files or others give some."""
        return self.values if self.is_whole and not self.files else None


class StartedProgram(Record):
    """A program that a launch file starts.

    Attributes:
        package: empty for a program that is no node.
        executable: in the package; empty if it is not known, or for a program.
        words: of its command line; those of a program begin with its name.
        span: where it is started.
        frame: the launch files that led there.
        is_sure: False if a condition decides that is known at run time only.
        is_remapped: True if it gives topics other names.
        parameters: that it is given.
        name: of the node; empty where none is given, or only at run time.
        namespace: without slashes around it; None where it is known at run time only.
    """

    package: str
    executable: str
    words: tuple[Word, ...]
    span: Span
    frame: CallFrame | None
    is_sure: bool = True
    is_remapped: bool = False
    parameters: Parameters = Parameters({})
    namespace: str | None = ""
    name: str = ""


class IncludedFile(Record):
    """A launch file that another one includes, at hand or not.

    Attributes:
        path: with its expressions resolved; absolute.
        arguments: that it sees; None if not even their names are known.
        span: where it is included.
        frame: the launch files that led there.
        is_sure: False if a condition decides that is known at run time only.
    """

    path: str
    arguments: Mapping[str, Word] | None
    span: Span
    frame: CallFrame | None
    is_sure: bool = True


class Launch(Record):
    """What a launch file needs.

    Attributes:
        descriptions: the robots it describes.
        files, packages: that it names, found or not.
        problems: what is wrong with its text, under the codes of the rules that explain it.
        started: the programs that it starts.
        included: those that the files start which it includes.
        unread: paths of the files that it includes and that were not read; empty if not known.
        has_scopes: True if it sets namespaces, parameters or remappings for several nodes.
        names_parameters: True if it gives parameters names that are in no file, by a namespace for
            what is in a file, or in its own text.
        includes: the files that it and those which it includes include.
    """

    descriptions: tuple[LaunchedDescription, ...]
    files: tuple[FileUse, ...]
    packages: tuple[PackageUse, ...]
    problems: tuple[Problem, ...]
    started: tuple[StartedProgram, ...]
    included: tuple[StartedProgram, ...]
    unread: tuple[str, ...]
    has_scopes: bool
    names_parameters: bool
    includes: tuple[IncludedFile, ...] = ()

    @property
    def parameters(self) -> tuple[FileUse, ...]:
        """The files of parameters that it loads."""
        return tuple(file for file in self.files if file.purpose == PARAMETERS)
