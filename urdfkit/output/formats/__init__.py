"""Output formats of ``urdfkit check``: each module of this directory is one format.

A format is a module with
``render(report: Report, *, color: bool = False, width: int = 80) -> str``; the text ends with a
newline. ``color`` allows escape sequences, ``width`` is the number of columns of the terminal;
machine-readable formats ignore both. Instead of ``render`` a format may have ``stream``, which
yields the text in parts, so that a report with very many findings is never in memory as a whole. A
format for people has ``findings``, too, which yields the parts without the text below the findings.
Modules with a leading underscore contain code that formats share.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from importlib import import_module

from urdfkit.core.static_typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from urdfkit.lint.report import Report


class Render(Protocol):
    """A report as text."""

    def __call__(self, report: Report, *, color: bool = False, width: int = 80) -> str: ...


def names() -> list[str]:
    """Names of all formats, sorted; no format is imported."""
    files = sorted(os.listdir(os.path.dirname(__file__)))
    return [file[:-3] for file in files if file.endswith(".py") and not file.startswith("_")]


def get(name: str) -> Render:
    """The function that renders a report in a format.

    Raises:
        KeyError: the format is unknown.
    """
    if name not in names():
        raise KeyError(name)

    def render(report: Report, *, color: bool = False, width: int = 80) -> str:
        return "".join(stream(name, report, color=color, width=width))

    return render


def stream(
    name: str, report: Report, *, color: bool = False, width: int = 80, quiet: bool = False
) -> Iterator[str]:
    """A report in a format, in parts if the format has ``stream``.

    Args:
        name: one of `names`.
        color, width: see above.
        quiet: omit the text below the findings, if the format has ``findings``.
    """
    module = import_module(f"urdfkit.output.formats.{name}")
    parts = getattr(module, "findings", None) if quiet else None
    parts = parts or getattr(module, "stream", None)
    if parts is None:
        yield module.render(report, color=color, width=width)
    else:
        yield from parts(report, color=color, width=width)
