"""Messages about files that xacro does not find."""

import os
from collections.abc import Iterable
from itertools import pairwise

from urdfkit.core import disk
from urdfkit.core.suggest import nearest_file_name
from urdfkit.text.diagnostic import NOT_BUILT, NOT_CREATED
from urdfkit.text.source import shown
from urdfkit.workspace.gitignore import GitIgnored
from urdfkit.workspace.install_rules import is_built, is_expanded
from urdfkit.workspace.manifest import nearest_manifest
from urdfkit.workspace.package_directories import package_name
from urdfkit.xacro.errors import ONLY_XACRODOC, MessageText

#: Most directories or files in a help text.
_MAX_NAMED = 10
#: Suffixes of files that stand for one another.
_KINDS = ((".xacro", ".urdf"), (".yaml", ".yml"))
#: Most directories in the path of a file in a macro.
_MAX_LEVELS = 5


def missing_file(path: str) -> MessageText:
    """The message for a file that is not found where xacro looks."""
    _, scheme, reference = path.partition("package:/")
    if scheme:
        package, _, rest = reference.strip("/").partition("/")
        message = f"xacro does not resolve package://{package}/{rest}"
        return MessageText(message, f"write $(find {package})/{rest}")
    if disk.is_file(f"{path}.in"):
        message = f"{NOT_BUILT}: {shown(path)}, from {os.path.basename(path)}.in"
        help = "build the workspace, or create the file with the values of CMake"
        return MessageText(message, help)
    if disk.is_file(f"{path}.xacro") and is_expanded(f"{path}.xacro"):
        message = f"{NOT_BUILT}: {shown(path)}, from {os.path.basename(path)}.xacro"
        return MessageText(message, "build the workspace, or include the xacro itself")
    if is_built(path):
        return MessageText(f"{NOT_BUILT}: {shown(path)}", "build the workspace")
    if _is_created_by_script(path):
        return MessageText(f"{NOT_CREATED}: {shown(path)}", "run the script that creates it")
    if found := _from_parent(path):
        directory, relative = found
        message = f"{ONLY_XACRODOC}: {shown(path)}; only xacrodoc finds it, in {shown(directory)}"
        return MessageText(message, f"write {relative}")
    help = _below_package(os.path.abspath(path)) or _nearest_file(path)
    return MessageText(f"file not found: {shown(path)}", help)


def _is_created_by_script(path: str) -> bool:
    """True if git ignores a missing file, and its directory has no file of its kind."""
    kind = os.path.splitext(path)[1]
    names = disk.names_or_empty(os.path.dirname(path))
    return not any(name.endswith(kind) for name in names) and path in GitIgnored()


def relative_to_caller(cause: BaseException, own: str) -> MessageText | None:
    """The message for a missing file that is found from the file ``own``, in whose macro it is."""
    if not isinstance(cause, FileNotFoundError) or not cause.filename:
        return None
    path, home = os.fspath(cause.filename), os.path.dirname(own)
    name, above = os.path.basename(path), os.path.dirname(path)
    for _ in range(_MAX_LEVELS):
        is_other = os.path.abspath(above) != os.path.abspath(home)
        if is_other and disk.is_file(os.path.join(home, name)):
            message = f"file not found: {shown(path)}, relative to the file that calls the macro"
            help = f"write $(find PACKAGE)/..., which finds {shown(home)}/{name} from everywhere"
            return MessageText(message, help)
        name, above = f"{os.path.basename(above)}/{name}", os.path.dirname(above)
    return None


def next_to(cause: BaseException, own: str) -> str:
    """The help for a missing file of which one with this name is next to the file ``own``."""
    if not isinstance(cause, FileNotFoundError) or not cause.filename:
        return ""
    path = os.fspath(cause.filename)
    home, name = os.path.dirname(own), os.path.basename(path)
    is_other = os.path.abspath(os.path.dirname(path)) != os.path.abspath(home)
    is_there = is_other and name and disk.is_file(os.path.join(home, name))
    return f"write {name}, which is next to this file" if is_there else ""


def _below_package(path: str) -> str:
    """The help for a path that is right from the directory of the package."""
    file = nearest_manifest(path)
    home = os.path.dirname(file) if file else ""
    name = package_name(home) if file else None
    parts = os.path.relpath(path, home).split(os.sep) if name else []
    for number in range(1, len(parts) - 1):
        if disk.is_file(os.path.join(home, *parts[number:])):
            return f"write $(find {name})/{'/'.join(parts[number:])}"
    return ""


def _from_parent(path: str) -> tuple[str, str] | None:
    """The directory from which a path is right, and the right path; None if there is none.

    Such a path begins with the name of the directory that it is in: ``xacro/xacro/leg.xacro``.
    """
    parts = path.split(os.sep)
    for number, (name, other) in enumerate(pairwise(parts)):
        relative = parts[number + 2 :]
        if name == other and disk.is_file(os.sep.join((*parts[: number + 1], *relative))):
            return os.sep.join(parts[:number]) or os.curdir, "/".join(relative)
    return None


def _other_file(name: str, siblings: Iterable[str]) -> str:
    """The help for a missing file whose directory exists: few files of its stem, or of its kind.

    Often the name depends on an argument, and these are its valid values.
    """
    kinds = next((kinds for kinds in _KINDS if name.endswith(kinds)), (os.path.splitext(name)[1],))
    stem = name.partition(".")[0]
    same = [sibling for sibling in siblings if sibling.partition(".")[0] == stem]
    files = sorted(same or (sibling for sibling in siblings if sibling.endswith(kinds)))
    if 0 < len(files) <= _MAX_NAMED:
        return f"create it, or correct the path; available: {', '.join(files)}"
    return "create it, or correct the path; a relative one begins at the directory of its file"


def _nearest_file(path: str) -> str:
    """The help for a missing file: the missing directory in its path, or a similar file."""
    directory, name = os.path.split(os.path.normpath(path))
    last = name
    while (
        directory and not disk.is_directory(directory) and directory != os.path.dirname(directory)
    ):
        directory, name = os.path.split(directory)
    if directory.startswith(os.sep) and directory.count(os.sep) == 1:  # /, /home or /tmp
        owner = "not of a package" if name == last else "of another computer"
        return f"the path is {owner}: write $(find PACKAGE)/..."
    try:
        siblings = disk.names(directory or os.curdir)
    except OSError:
        return ""
    suggested = nearest_file_name(name, siblings)
    hint = f"did you mean '{suggested}'?" if suggested else ""
    if name == last:
        return hint or _other_file(name, siblings)
    present = sorted(path for path in siblings if disk.is_directory(os.path.join(directory, path)))
    if not hint and 0 < len(present) <= _MAX_NAMED:  # often the valid values of an argument
        hint = f"available: {', '.join(present)}"
    return f"directory '{name}' not found in {shown(directory)}" + (f"; {hint}" if hint else "")
