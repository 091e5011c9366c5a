"""What the programs of a launch file read, publish and expect of one another."""

from collections.abc import Collection

from urdfkit.lint import rule_index
from urdfkit.lint.context import Context
from urdfkit.text.file_kinds import is_parameter_file

#: The rules about parameters, which also hold for a file that no launch file loads.
_OF_PARAMETERS = frozenset(
    (
        "LAU023",
        "LAU024",
        "LAU025",
        "LAU026",
        "LAU032",
        "LAU039",
        "LAU040",
        "LAU044",
        "LAU045",
        "LAU046",
    )
)


def applies(context: Context) -> bool:
    """True for a launch file, and for a parameter file."""
    return context.is_bringup


def codes(context: Context) -> Collection[str]:
    """The rules that may have something to report."""
    is_loaded = not is_parameter_file(context.source)
    return rule_index.of_family("bringup") if is_loaded else _OF_PARAMETERS
