"""What stops urdfkit itself. A defect of a robot is never an exception: it is a Diagnostic."""


class UrdfkitError(Exception):
    """The job cannot be done: the command line prints the message and exits with 2."""


class NotEnoughMemory(UrdfkitError):
    """The process has no memory left, or may take no more."""


class Cancelled(UrdfkitError):
    """Nobody waits for the result any more."""


class UnreadableFile(UrdfkitError):
    """A file named by the user does not exist, is a directory, or may not be opened."""


class UnwritableFile(UrdfkitError):
    """An output cannot be written."""


class UnknownRule(UrdfkitError):
    """No rule has that code, beginning of a code, or name."""

    def __init__(self, word: str, hint: str = "") -> None:
        super().__init__(f"no rule '{word}'{hint}")
        self.word = word  # what was asked for


class RuleError(UrdfkitError):
    """A rule of another package cannot be used; the message names its module and the reason."""


class UnreadableRobot(UrdfkitError):
    """A file is not XML, or a xacro that does not expand.

    Attributes:
        problems: every reason, each with its place (``urdfkit.text.diagnostic.Problem``).
    """

    def __init__(self, message: str, problems: tuple[object, ...] = ()) -> None:
        super().__init__(message)
        self.problems = problems


class PackageNotFound(UrdfkitError):
    """No directory is known for a ROS package."""

    def __init__(self, name: str, searched: tuple[str, ...]) -> None:
        super().__init__(f"package '{name}' not found; searched: {', '.join(searched)}")
        self.name = name  # the package that was asked for
        self.searched = searched  # what was looked through, in order, in words a user can check


class MissingLibrary(UrdfkitError, ImportError):
    """A library that this needs is not installed; the message says how to install it."""
