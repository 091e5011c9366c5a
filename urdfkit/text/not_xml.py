"""Files that are no XML at all: empty, binary, web pages, or with a merge conflict."""

import re
from itertools import islice

from urdfkit.text.tag_matching import MAX_ERRORS, SyntaxMistake
from urdfkit.text.xml_characters import control_characters

#: Most control characters in a text file; a file with more is binary.
MAX_CONTROLS = 20
#: The first line of the two sides of a merge conflict.
_CONFLICT = re.compile(rb"^<{7}(?: .*)?$", re.MULTILINE)
_NOT_ROBOT_HELP = "name the URDF or xacro of the robot"


def other_than_xml(data: bytes) -> list[SyntaxMistake]:
    """Why a text cannot be read as XML at all; empty if it may be XML with mistakes."""
    if file_kind := _other_kind(data):
        message, help = file_kind
        return [SyntaxMistake(0, 0, message, help=help)]
    if is_binary(data):
        controls = control_characters(data)
        count = sum(end - start for start, end in controls)
        message = f"not a text file: it contains {count} control characters"
        return [SyntaxMistake(*controls[0], message, help=_NOT_ROBOT_HELP)]
    return _conflicts(data) if b"\n>>>>>>>" in data else []


def _other_kind(data: bytes) -> tuple[str, str] | None:
    """Message and help if the file is not XML, or is a web page."""
    start = data[:1000].lstrip().lower()
    if not data.strip():
        return "the file is empty", "add a <robot>, or name another file"
    if start.startswith((b"<!doctype html", b"<html")):
        return "the file is a web page, not a robot", "download the raw file"
    if start.startswith(b"version https://git-lfs"):
        return "the file is a Git LFS pointer, not the robot itself", "run: git lfs pull"
    if b"<" not in data:
        return "not an XML file: it contains no tag", _NOT_ROBOT_HELP
    return None


def is_binary(data: bytes) -> bool:
    """True for data that is not text in any encoding."""
    return sum(end - start for start, end in control_characters(data)) > MAX_CONTROLS


def _conflicts(data: bytes) -> list[SyntaxMistake]:
    """The merge conflicts that were left in a file."""
    message = "the file contains the markers of a merge conflict"
    help = "keep one side, and remove the lines of <<<<<<<, ======= and >>>>>>>"
    found = islice(_CONFLICT.finditer(data), MAX_ERRORS)
    return [SyntaxMistake(*match.span(), message, help=help) for match in found]
