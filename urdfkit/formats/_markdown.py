"""Markdown that several outputs need: tables, and a text that fits a comment."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

#: Characters that a comment on GitHub may have; GitLab and Gitea allow more.
MAX_CHARACTERS = 65_536
_MORE = "\n_Cut to {} characters; the JSON has everything._\n"


def table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table; its cells are escaped already."""
    lines = [header, ["---"] * len(header), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def fitted(sections: Iterable[str], limit: int = MAX_CHARACTERS) -> str:
    """Sections with an empty line between them, cut at a line if they pass the limit."""
    text = "\n".join(sections)
    if len(text) <= limit:
        return text
    more = _MORE.format(limit)
    return text[: text.rfind("\n", 0, limit - len(more)) + 1] + more
