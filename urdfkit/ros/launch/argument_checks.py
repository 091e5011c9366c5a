"""Arguments of launch files: what is used and not declared, passed and not taken, or missing."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Iterator

from urdfkit.core.suggest import Suggester, did_you_mean
from urdfkit.errors import UnreadableFile
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.signature import Signature
from urdfkit.text.document import CallFrame
from urdfkit.text.source import Source, Span
from urdfkit.text.xml_reader import Problem, is_launch
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.ros_packages import comes_with_ros

#: The end of the name of a launch file that begins with an expression, in XML or in Python.
_COMPUTED = re.compile(rb"""(?:[)}]|["'](?=[._-]))([\w.-]*\.launch[\w.]*)""")
#: Files that are looked into for one that includes another, and folders of them.
MAX_FILES, MAX_FOLDERS = 500, 2000


def is_typo(name: str, known: Iterable[str]) -> bool:
    """True if a name is nearly a known one, and not that of something else."""
    return bool(Suggester(frozenset(known)).suggested(name))


def undeclared(
    name: str, declared: Collection[str], span: Span, frame: CallFrame | None, *, is_lost: bool
) -> Problem:
    """That an argument is used and not declared.

    The command line may give it nevertheless, unless the file is included and gets nothing from
    there (``is_lost``); it will hardly give a slip.
    """
    hint = did_you_mean(name, declared)
    message = f"no argument '{name}' is declared{hint}"
    code = "LAU006" if is_lost or is_typo(name, declared) else "LAU012"
    return Problem(code, span, message, frame=frame)


def not_taken(
    passed: Iterable[tuple[str, Span]],
    taken: Signature,
    source: Source,
    frame: CallFrame | None,
    *,
    ros: int,
) -> Iterator[Problem]:
    """The arguments that an included file is given and does not have.

    In ROS 2 the file may use them without declaring them, and pass them on.
    """
    for name, span in passed:
        if name in taken.names:
            continue
        word = rf"(?<!\w){re.escape(name)}(?!\w)".encode()
        is_used = ros == 2 and re.search(word, source.data)
        if not is_used and (ros == 1 or taken.is_whole or is_typo(name, taken.names)):
            file = os.path.basename(source.path)
            message = f"'{file}' has no argument '{name}'{did_you_mean(name, taken.names)}"
            yield Problem("LAU007", span, message, frame=frame)


def not_given(
    known: Collection[str], taken: Signature, source: Source, span: Span, frame: CallFrame | None
) -> Iterator[Problem]:
    """The arguments without a default that an included file is not given."""
    for name in sorted(taken.required.difference(known)):
        message = f"'{os.path.basename(source.path)}' needs the argument '{name}'"
        yield Problem("LAU008", span, message, f"pass '{name}', or give it a default", frame)


def declares_others(path: str) -> bool:
    """True if a launch file that was not found may declare arguments that its user relies on.

    Those that come with ROS do not.
    """
    package = path[len(UNKNOWN) + 1 :].partition("/")[0] if path.startswith(UNKNOWN) else ""
    return not comes_with_ros(package)


def is_included(path: str, resolver: Resolver) -> bool:
    """True if another launch file of the package names this one: arguments may come from there."""
    home = resolver.packages.enclosing(path)
    folder = home[1] if home else os.path.dirname(os.path.abspath(path))
    name = os.path.basename(path)
    beside = filter(is_launch, resolver.folders.files_below(folder, MAX_FOLDERS))
    others = [file for file in beside if os.path.basename(file) != name]
    return len(others) > MAX_FILES or any(_names(name.encode(), one, resolver) for one in others)


def _names(name: bytes, other: str, resolver: Resolver) -> bool:
    """True if a launch file names another one, or the end of what it puts together is its name."""
    try:
        text = resolver.read(other).data
    except UnreadableFile:
        return False
    return name in text or any(map(name.endswith, _COMPUTED.findall(text)))
