"""The text of files of CMake."""

import re

from urdfkit.workspace.file_head import head_text


def cmake_text(path: str) -> str:
    """A file of CMake without its comments; empty if it is unreadable."""
    return re.sub(r"#.*", "", head_text(path))


def blank_cmake_comments(data: bytes) -> bytes:
    """A file of CMake with comments replaced by spaces, so that offsets stay valid."""
    return re.sub(rb"#[^\n]*", lambda comment: b" " * len(comment[0]), data)
