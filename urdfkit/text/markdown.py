"""Markdown that several outputs need: plain text, tables, and a text that fits a comment.

The words of a robot's file come from anybody: whatever would be markup, a mention or a link is
shown as the characters it is made of.
"""

import re
from collections.abc import Iterable, Sequence

from urdfkit.text.terminal import printable

#: Characters that a comment on GitHub may have; GitLab and Gitea allow more.
MAX_CHARACTERS = 65_536
_MORE = f"\n_Cut to {MAX_CHARACTERS} characters; the JSON has everything._\n"
#: Characters of a message, a path or a help text.
MAX_TEXT = 600

#: What Markdown, HTML and formulas are made of, and the colon of an address.
_SIGN = re.compile(r"[&<>|\\`*_{}\[\]~$]|:(?=//)")
#: Mentions, issues and bare addresses are found in the text after markup: they are broken up.
_FOUND_LATER = re.compile(r"(?<=[@#])(?=\w)|(?<=\bwww)(?=\.)")


def escape(text: str) -> str:
    """A text on one line that Markdown shows as it is."""
    text = printable(text)
    if len(text) > MAX_TEXT:
        text = text[:MAX_TEXT] + " ..."
    return _FOUND_LATER.sub("&#8203;", _SIGN.sub(r"\\\g<0>", text))


def code(text: str) -> str:
    """A name or a path, as code."""
    return f"<code>{escape(text)}</code>"


def table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table; its cells are escaped already."""
    lines = [header, ["---"] * len(header), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def fitted(sections: Iterable[str]) -> str:
    """Sections with an empty line between them, cut at a line after MAX_CHARACTERS."""
    text = "\n".join(sections)
    if len(text) <= MAX_CHARACTERS:
        return text
    return text[: text.rfind("\n", 0, MAX_CHARACTERS - len(_MORE)) + 1] + _MORE
