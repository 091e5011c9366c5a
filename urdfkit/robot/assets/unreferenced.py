"""Mesh files of a package that no file of its workspace mentions."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable

from urdfkit.mesh.io.facts import BY_SUFFIX
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.folders import Folders

#: Files in which meshes are named.
_TEXTS = frozenset(
    ".urdf .xacro .xml .sdf .srdf .world .launch .yaml .yml .py .rviz .config .json .toml".split()
)

#: What follows an expression in the name of a mesh: of xacro, or of a string in Python.
_MADE = re.compile(
    rb"(?:[})]|%s|\+ ?[\"'])([\w.-]*\.("
    + b"|".join(suffix[1:].encode() for suffix in BY_SUFFIX)
    + rb"))\b"
)

#: More is not read; a workspace of more text is not judged.
MAX_FOLDERS = 2000
MAX_BYTES = 8 * 1024 * 1024


def unreferenced(used: Iterable[str], package: str, workspace: str, folders: Folders) -> list[str]:
    """The mesh files beside those that a robot uses whose names no text of the workspace holds.

    Where a text makes names of meshes by expressions, the files that may be meant are left out:
    those that end as ``${variant}_base.stl`` does, and all of them if the whole name is made.

    Args:
        used: the mesh files of the robot.
        package: the folder of the robot's package; meshes of others are their own affair.
        workspace: the folder of all packages that may use the meshes.
        folders: lists folders.
    """
    known = {os.path.realpath(path) for path in used}
    inside = os.path.join(os.path.realpath(package), "")
    beside = [
        os.path.join(folder, name)
        for folder in dict.fromkeys(map(os.path.dirname, sorted(known)))
        if os.path.join(folder, "").startswith(inside)
        for name, is_folder in sorted((folders.entries(folder) or {}).items())
        if not is_folder and os.path.splitext(name)[1].lower() in BY_SUFFIX
    ]
    left = [path for path in beside if os.path.realpath(path) not in known]
    text = _text(workspace, folders) if left else None
    ends = tuple({end for end, _ in _MADE.findall(text or b"")})
    if text is None or not all(map(_stem, ends)):
        return []
    return [
        path
        for path in left
        if _stem(path) not in text and not os.fsencode(path).lower().endswith(ends)
    ]


def _stem(path: str | bytes) -> bytes:
    name = os.path.basename(os.fsencode(path)).lower()
    return name.rpartition(b".")[0]


def _text(workspace: str, folders: Folders) -> bytes | None:
    """All texts of a workspace in small letters; None if they are too many."""
    found: list[bytes] = []
    left = MAX_BYTES
    for path in folders.files_below(workspace, MAX_FOLDERS):
        if os.path.splitext(path)[1].lower() not in _TEXTS:
            continue
        data = read_head(path, left + 1)
        left -= len(data)
        if left < 0:
            return None
        found.append(data.lower())
    return b"\n".join(found)
