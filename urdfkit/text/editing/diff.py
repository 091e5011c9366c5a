"""Unified diffs."""

from __future__ import annotations

import difflib
import io
from array import array

from urdfkit.text.source import shown

#: Most deletions and insertions for which the smallest diff is searched.
_MAX_EDITS = 2000


def diff(path: str, before: bytes, after: bytes) -> str:
    """The changes of a file in UTF-8, as a unified diff for ``patch -p0``.

    Args:
        path: of the file. The diff contains it relative to the current directory if the file is in
            it: ``patch`` rejects absolute paths.
    """
    old, new = _lines(before), _lines(after)
    matcher = difflib.SequenceMatcher(None, old, new)
    if common := _common(old, new):
        vars(matcher)["matching_blocks"] = common  # replaces difflib's own search
    name = shown(path)
    if " " in name:
        name += "\t"  # otherwise ``patch`` and ``git apply`` take the first word alone
    lines = [f"--- {name}\n", f"+++ {name}\n"] if before != after else []
    for group in matcher.get_grouped_opcodes():
        lines.append(f"@@ -{_range(group, 1)} +{_range(group, 3)} @@\n")
        for tag, start, end, at, to in group:
            if tag == "equal":
                lines += (f" {line}" for line in old[start:end])
            else:
                lines += (f"-{line}" for line in old[start:end])
                lines += (f"+{line}" for line in new[at:to])
    return "".join(
        line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines
    )


def _range(group: list[tuple[str, int, int, int, int]], column: int) -> str:
    """First line and number of lines of a hunk, in one of the texts."""
    start, end = int(group[0][column]), int(group[-1][column + 1])
    return f"{start + (end > start)},{end - start}" if end - start != 1 else f"{start + 1}"


def _common(old: list[str], new: list[str]) -> list[difflib.Match]:
    """The longest common subsequence of two texts, as runs of lines; empty if they differ too much.

    difflib ignores frequent lines, such as </inertial>, and then reports more changes than
    necessary. Myers 1986, https://doi.org/10.1007/BF01840446.
    """
    ends: list[array[int]] = []  # after n edits: the furthest point on each diagonal of the grid
    reached = {1: 0}
    for edits in range(_MAX_EDITS):
        for k in range(-edits, edits + 1, 2):
            left, above = reached.get(k - 1, -1), reached.get(k + 1, -1)
            x = above if k == -edits or (k != edits and left < above) else left + 1
            while x < len(old) and x - k < len(new) and old[x] == new[x - k]:
                x += 1
            reached[k] = x
            if x >= len(old) and x - k >= len(new):
                return _backtrack(ends, x, x - k)
        ends.append(array("l", (reached[k] for k in range(-edits, edits + 1, 2))))
    return []


def _backtrack(ends: list[array[int]], x: int, y: int) -> list[difflib.Match]:
    """The runs of equal lines on the path through the grid to an end point."""
    blocks = [difflib.Match(x, y, 0)]
    for edits in range(len(ends), 0, -1):
        before, k = ends[edits - 1], x - y
        index = (k - 1 + edits - 1) // 2  # of the diagonal below, among every second one
        left = before[index] if 0 <= index < len(before) else -1
        above = before[index + 1] if index + 1 < len(before) else -1
        is_insertion = k == -edits or (k != edits and left < above)
        start = above if is_insertion else left + 1
        if x > start:
            blocks.append(difflib.Match(start, start - k, x - start))
        x, y = (start, start - k - 1) if is_insertion else (start - 1, start - k)
    if x:
        blocks.append(difflib.Match(0, 0, x))
    return blocks[::-1]


def _lines(text: bytes) -> list[str]:
    """Lines with their ends, as in ``patch``: only a line feed ends a line."""
    return [*io.StringIO(text.decode("utf-8", "replace"), newline="\n")]
