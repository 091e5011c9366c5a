"""Arguments of a robot that are empty by default, such as the prefixes of its arms."""

from urdfkit.core.grouping import repeated
from urdfkit.lint.context import Context
from urdfkit.text.document import Element

#: Most empty arguments that are tried as a prefix.
_MAX_ARGUMENTS = 4


def empty_arguments(context: Context) -> list[str]:
    """The arguments with an empty value; those whose name contains prefix come first."""
    defaults = context.reading.defaults
    empty = [name for name in defaults if not context.arguments.get(name, defaults[name]).strip()]
    return sorted(empty, key=lambda name: "prefix" not in name)[:_MAX_ARGUMENTS]


def prefixes_to_pass(context: Context) -> str:
    """How to tell the links of the arms of a robot apart; empty if they have different names.

    Where two arms get their prefixes from arguments, the robot is not meant for their defaults.
    """
    prefixes = [name for name in empty_arguments(context) if "prefix" in name]
    if len(prefixes) < 2 or not _has_duplicates(context.document.root):
        return ""
    other = context.expanded_with({**context.arguments, **{name: f"{name}_" for name in prefixes}})
    if other is None or _has_duplicates(other.root):
        return ""
    listed = " and ".join(f"'{name}'" for name in prefixes)
    return f"pass another value for each of {listed}, which are empty by default"


def _has_duplicates(root: Element) -> bool:
    names = ((element.get("name"), element) for element in root.all("link"))
    return any(repeated(names))
