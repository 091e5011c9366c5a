"""What a message states whatever its wording: names and values.

``found.message == naming("wheel", "42.9 kg")`` asserts all of them, in their order. A word counts
where it is listed: ``naming("j", "effort")``. The wording itself stands in ``tests/wording.txt``.
"""

import re
from typing import Any

_UNITS = r"%|°|(?:k?g|[mck]?m|m?s|N|W|V|rad|deg|k?Hz|[kM]B|bytes?|triangles?)(?:[·²³/^]\S*)?\b"
_NUMBER = r"[-+]?(?:\d{1,3}(?:,\d{3})+|\d+)(?:\.\d+)?(?:e[-+]?\d+)?"
_NUMBERS = rf"[(\[]{_NUMBER}(?:,[ ]{_NUMBER})+[)\]] | {_NUMBER}(?:(?:[ ]x|,)?[ ]{_NUMBER})*"
# What a path, a parameter or a type has and an English word has not.
_IDENTIFIER = r"[\w$*/]?[_/:=.·²] | [a-z][A-Z] | [A-Za-z]-?(?=\d) | (?<!\w)\* | (?<![\w-])-"
_VALUE = rf"""
    (?<!\w)'(?P<quoted>[^']*)'(?!\w)
  | [\w:]+="[^"]*"
  | <(?P<tag>[\w:]+)>[^<>\s]+</(?P=tag)> | </?[A-Za-z][^<>]*>
  | \$\([^)]*\) | \$?\{{[^}}]*\}}
  | (?:ROS|RViz)[ ][12]\b
  | (?:(?<!\w)[<>]=?[ ])? (?<![\w.]) (?:{_NUMBERS}) (?![\w.]*[\w/]) (?:[ ]?(?:{_UNITS}))?
  | [\w$./:~*-]* (?:{_IDENTIFIER}) [\w$./:=*-]*\w
  | \w+(?:-\w+){{2,}} | \w+\(\) | \w+(?:[ ]->[ ]\w+)+
"""


def values(text: str, *words: str) -> list[str]:
    """What is quoted, tags, numbers with units, paths, identifiers; and the given words."""
    more = "".join(rf" | \b{re.escape(word)}\b" for word in words)
    found = re.finditer(_VALUE + more, text, re.VERBOSE)
    return [each[0] if each["quoted"] is None else each["quoted"] for each in found]


def naming(*expected: object) -> Any:
    """A text with just these names and values, in this order."""
    return _Naming(list(map(str, expected)))


class _Naming:
    def __init__(self, expected: list[str]) -> None:
        self.expected = expected

    def __eq__(self, text: object) -> bool:
        if not isinstance(text, str):
            return NotImplemented
        found = values(text)
        # A short one, such as "a", is the name of a link rather than a word.
        words = [each for each in self.expected if each not in found and len(each) > 2]
        return (values(text, *words) if words else found) == self.expected

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"naming({', '.join(map(repr, self.expected))})"
