"""One output per file: the listing of this directory is the catalogue, and one law holds.

A format is a module with
``render(report: Report, *, color: bool = False, width: int = 80) -> str``; the text ends with a
newline. ``color`` allows escape sequences, ``width`` is the number of columns of the reader's
screen; a format for programs takes no notice of either. Modules with a leading underscore are
parts that formats share. A format that can do so has ``stream``, too, which gives the same text in
parts: that of very many findings never is in memory as a whole. A format for people has
``findings``, which gives the parts without what stands below the findings.
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
    """The formats there are, sorted; nothing is imported."""
    files = sorted(os.listdir(os.path.dirname(__file__)))
    return [file[:-3] for file in files if file.endswith(".py") and not file.startswith("_")]


def get(name: str) -> Render:
    """The ``render`` of a format.

    Raises:
        KeyError: there is none of that name.
    """
    if name not in names():
        raise KeyError(name)
    render: Render = import_module(f"urdfkit.output.formats.{name}").render
    return render


def stream(
    name: str, report: Report, *, color: bool = False, width: int = 80, quiet: bool = False
) -> Iterator[str]:
    """A report in a format, in parts if the format has them.

    Args:
        color: as of ``render``.
        width: as of ``render``.
        quiet: leave out what stands below the findings, if the format has it.

    Raises:
        KeyError: there is none of that name.
    """
    render = get(name)
    module = import_module(render.__module__)
    parts = getattr(module, "findings", None) if quiet else None
    parts = parts or getattr(module, "stream", None)
    if parts is None:
        yield render(report, color=color, width=width)
    else:
        yield from parts(report, color=color, width=width)
