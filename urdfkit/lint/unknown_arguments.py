"""Arguments that a user passes, and a description does not use."""

from __future__ import annotations

from collections.abc import Iterable

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.core.suggest import nearest

if TYPE_CHECKING:
    from urdfkit.lint.context import Context


def unknown_arguments(context: Context, passed: Iterable[str]) -> dict[str, str]:
    """The passed arguments that a description does not use, each with the suggested name.

    xacro accepts any argument, so that a typo has no effect and is not reported. Empty for launch
    files, which may pass arguments on, and for unreadable descriptions.
    """
    names = tuple(passed)
    if not names or context.reading.document is None:
        return {}
    xacro, declared = context.reading.xacro, set(context.reading.defaults)
    mentioned = declared | (xacro.usage.names if xacro else frozenset())
    return {name: nearest(name, declared) or "" for name in names if name not in mentioned}
