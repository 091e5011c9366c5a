"""Output formats of ``urdfkit check``: each module of this directory is one format.

A format is a module with
``render(report: Report, *, color: bool = False, width: int = 80) -> str``; the text ends with a
newline. ``color`` allows escape sequences, ``width`` is the number of columns of the terminal;
machine-readable formats ignore both. Modules with a leading underscore contain code that formats
share. A format may also have ``stream``, which yields the same text in parts, so that a report
with very many findings is never in memory as a whole. A format for people has ``findings``, which
yields the parts without the text below the findings.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from importlib import import_module

from urdfkit.core.static_typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from urdfkit.lint.report import Report


class Render(Protocol):
    """The signature of an output format."""

    def __call__(self, report: Report, *, color: bool = False, width: int = 80) -> str: ...


def names() -> list[str]:
    """Names of all formats, sorted; no format is imported."""
    files = sorted(os.listdir(os.path.dirname(__file__)))
    return [file[:-3] for file in files if file.endswith(".py") and not file.startswith("_")]


def get(name: str) -> Render:
    """The ``render`` function of a format.

    Raises:
        KeyError: the format is unknown.
    """
    if name not in names():
        raise KeyError(name)
    render: Render = import_module(f"urdfkit.output.formats.{name}").render
    return render


def stream(
    name: str, report: Report, *, color: bool = False, width: int = 80, quiet: bool = False
) -> Iterator[str]:
    """A report in a format, in parts if the format has ``stream``.

    Args:
        color: see ``render``.
        width: see ``render``.
        quiet: omit the text below the findings, if the format has ``findings``.

    Raises:
        KeyError: the format is unknown.
    """
    render = get(name)
    module = import_module(render.__module__)
    parts = getattr(module, "findings", None) if quiet else None
    parts = parts or getattr(module, "stream", None)
    if parts is None:
        yield render(report, color=color, width=width)
    else:
        yield from parts(report, color=color, width=width)
