"""Markdown for several outputs: escaped text, tables, and a text that fits a comment.

The text of a robot's file is not trusted: markup, mentions and links in it are shown as plain
characters.
"""

import re
from collections.abc import Iterable, Sequence

from urdfkit.text.terminal import printable

#: Most characters of a comment on GitHub; GitLab and Gitea allow more.
MAX_CHARACTERS = 65_536
_CUT_NOTE = f"\n_Cut to {MAX_CHARACTERS} characters; the JSON has everything._\n"
#: Most characters of a message, a path or a help text.
MAX_TEXT = 600

#: Special characters of Markdown, HTML and formulas, and the colon of a URL.
_SPECIAL = re.compile(r"[&<>|\\`*_{}\[\]~$]|:(?=//)")
#: Mentions, issues and bare URLs, which are recognised after markup: they are broken up.
_AUTOLINK = re.compile(r"(?<=[@#])(?=\w)|(?<=\bwww)(?=\.)")


def escape(text: str) -> str:
    """A text on one line, escaped so that Markdown shows it unchanged."""
    text = printable(text)
    if len(text) > MAX_TEXT:
        text = text[:MAX_TEXT] + " ..."
    return _AUTOLINK.sub("&#8203;", _SPECIAL.sub(r"\\\g<0>", text))


def code(text: str) -> str:
    """A name or a path, as code."""
    return f"<code>{escape(text)}</code>"


def table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table of cells that are already escaped."""
    lines = [header, ["---"] * len(header), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def fitted(sections: Iterable[str]) -> str:
    """Sections separated by empty lines, cut at a line end to MAX_CHARACTERS."""
    text = "\n".join(sections)
    if len(text) <= MAX_CHARACTERS:
        return text
    return text[: text.rfind("\n", 0, MAX_CHARACTERS - len(_CUT_NOTE)) + 1] + _CUT_NOTE
