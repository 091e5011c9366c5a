"""What is found in a launch file."""

from __future__ import annotations

from urdfkit.document import Frame
from urdfkit.reading import Problem
from urdfkit.record import Record
from urdfkit.source import Span

#: What a file of parameters is called in messages.
PARAMETERS = "the parameter file"

#: Launch files that include one another.
MAX_DEPTH = 8


class Description(Record):
    """A robot description that a launch file makes.

    Attributes:
        path: of the URDF or xacro.
        arguments: for xacro.
        frame: the launch file's place, for the chain of calls.
    """

    path: str
    arguments: dict[str, str]
    frame: Frame


class FileUse(Record):
    """A file that a launch file names.

    Attributes:
        text: as written.
        path: with its expressions resolved; absolute.
        exists: False if nothing is there.
        span: where it is named.
        purpose: such as ``the RViz configuration``.
    """

    text: str
    path: str
    exists: bool
    span: Span
    purpose: str


class PackageUse(Record):
    """A package that a launch file names, and the folders searched if it was not found."""

    name: str
    span: Span
    searched: tuple[str, ...] | None


class Launch(Record):
    """What a launch file needs.

    Attributes:
        descriptions: the robots it describes.
        files, packages: that it names, found or not.
        problems: why it cannot be read.
    """

    descriptions: tuple[Description, ...]
    files: tuple[FileUse, ...]
    packages: tuple[PackageUse, ...]
    problems: tuple[Problem, ...]

    @property
    def parameters(self) -> tuple[FileUse, ...]:
        """The files of parameters that it loads."""
        return tuple(file for file in self.files if file.purpose == PARAMETERS)
