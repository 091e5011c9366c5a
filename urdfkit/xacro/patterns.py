"""Guards for regular expressions of xacro that take exponential time for hostile texts."""

import re
from collections.abc import Callable

from urdfkit.core.static_typing import Any
from urdfkit.xacro.bounds import TooLarge, UnsafeExpression

#: Most characters of all parameters of a macro; real macros have 1 000.
_MAX_PARAMETERS = 10_000
#: Most characters of a default for which xacro's pattern may backtrack.
_MAX_TRIED = 24
_WITH_DEFAULT = r"\s*[^\s:=]+?\s*:?=\s*"
#: xacro's pattern of a default, without backtracking.
_DEFAULT = r"""(?:\^\|?)?(?:\$\{.*?\}|\$\(.*?\)|(?:'[^'\n]*'|"[^"\n]*"|[^\s'"])+|)(?:\s|$)"""


def macro_arg(stock: Callable[[str], Any]) -> Callable[[str], Any]:
    """xacro's ``parse_macro_arg`` in bounded time.

    Its pattern matches ``a:=xxxxx'``, a default with an unmatched quote, in 2^5 ways.
    """

    def parse_macro_arg(text: str) -> Any:
        if len(text) > _MAX_PARAMETERS:
            raise TooLarge(f"parameters of {len(text)} characters")
        start = len(text) > _MAX_TRIED and re.match(_WITH_DEFAULT, text)
        default = text[start.end() :] if start else ""
        if len(default) > _MAX_TRIED and not re.match(_DEFAULT, default):
            raise TooLarge("a long default with an unmatched quote")
        return stock(text)

    return parse_macro_arg


def tokenize(stock: Callable[..., Any]) -> Callable[..., Any]:
    """xacro's ``tokenize``, whose separators must not contain ``]``, which ends their pattern."""

    def tokenize(s: str, sep: str = ",; ", skip_empty: bool = True) -> Any:
        if "]" in sep[1:]:
            raise UnsafeExpression("']' among separators is not allowed in expressions")
        return stock(s, sep, skip_empty)

    return tokenize
