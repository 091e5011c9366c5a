"""Exceptions of urdfkit. A defect of a robot is never an exception, but a Diagnostic."""


class UrdfkitError(Exception):
    """Usage or input error: the command line prints the message and exits with 2."""


class NotEnoughMemory(UrdfkitError):
    """The process has reached its memory limit, or the machine has no memory left."""


class Cancelled(UrdfkitError):
    """The result is no longer needed."""


class UnreadableFile(UrdfkitError):
    """A file that the user named does not exist, is a directory, or cannot be opened."""


class UnwritableFile(UrdfkitError):
    """An output cannot be written."""


class FileChanged(UnwritableFile):
    """A file has changed since it was read."""

    def __init__(self, path: str) -> None:
        super().__init__(f"{path}: the file changed meanwhile; run the command again")


class Unavailable(UrdfkitError):
    """A result that a rule or command needs cannot be computed for this robot."""


class NotApplicable(Unavailable):
    """A rule does not apply to descriptions of this kind; nothing is missing."""


class UnknownRule(UrdfkitError):
    """No rule has this code, prefix of a code, or name."""

    def __init__(self, word: str, hint: str = "") -> None:
        super().__init__(f"no rule '{word}'{hint}")
        self.word = word  # as given by the user


class RuleError(UrdfkitError):
    """A rule of another package cannot be used; the message names its module and the reason."""


class UnreadableRobot(UrdfkitError):
    """A file is not XML, or its xacro cannot be expanded.

    Attributes:
        problems: the reasons, with their places (``urdfkit.text.diagnostic.Problem``).
    """

    def __init__(self, message: str, problems: tuple[object, ...] = ()) -> None:
        super().__init__(message)
        self.problems = problems


class PackageNotFound(UrdfkitError):
    """A ROS package cannot be found."""

    def __init__(self, name: str, searched: tuple[str, ...]) -> None:
        super().__init__(f"package '{name}' not found; searched: {', '.join(searched)}")
        self.name = name  # of the package
        self.searched = searched  # descriptions of the places searched, in order


class MissingLibrary(UrdfkitError, ImportError):
    """A required library is not installed; the message contains the command to install it."""
