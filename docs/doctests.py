"""An extension of griffe, which reads docstrings for the site: doctests become blocks of code."""

import re
from typing import Any

import griffe

#: Lines from a prompt to the next empty line.
_DOCTEST = re.compile(r"^>>> .*(?:\n(?!\n).+)*", re.MULTILINE)


class Doctests(griffe.Extension):
    """Fences the doctests of every docstring."""

    def on_object(self, *, obj: griffe.Object, **_: Any) -> None:
        """A module, class or function was read."""
        if obj.docstring is not None:
            fenced = _DOCTEST.sub(lambda test: f"```pycon\n{test[0]}\n```", obj.docstring.value)
            obj.docstring.value = fenced
