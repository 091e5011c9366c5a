"""Text in reports that are XML."""

from __future__ import annotations


def xml_text(text: str) -> str:
    """A text without the characters that XML cannot hold."""
    return "".join(
        char if char in "\t\n" or (char >= " " and not "\ud800" <= char <= "\udfff") else "?"
        for char in text
        if char not in "\ufffe\uffff"
    )
