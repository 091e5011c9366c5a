"""The result of a conversion: the files, and what happened to each part of the robot."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from typing import Any, Protocol

from urdfkit import __version__
from urdfkit.core import atomic
from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.conversion.losses import Entry, Result
from urdfkit.text.source import shown

#: The file that lists what became of each part; a directory with it is a conversion.
REPORT = "conversion.json"
VERSION = 1


class Proof(Protocol):
    """How far what was written is from the robot."""

    @property
    def part(self) -> str:
        """The name of the link or joint that differs most; empty if it is not known."""
        ...

    @property
    def holds(self) -> bool:
        """True if all differences are within the bounds."""
        ...

    @property
    def agreed(self) -> str:
        """What the proof shows, if it holds; a sentence."""
        ...

    @property
    def disagreed(self) -> str:
        """What it shows, if it does not hold: a sentence with the differences."""
        ...

    def _asdict(self) -> dict[str, Any]: ...


def proven(proof: Proof, robot: Context) -> Proof:
    """A proof that holds.

    Raises:
        UrdfkitError: it does not: at the link or joint that differs most.
    """
    if not proof.holds:
        raise UrdfkitError(
            f"{robot.model.place(proof.part)}: {proof.disagreed}; nothing is written: it is a bug "
            "in the conversion, not in the robot: please report it with the file"
        )
    return proof


class Conversion(Record):
    """The result of a conversion."""

    to: str  # the format
    file: str  # of the robot, in the directory
    root: str  # "free" or "fixed" to the world; empty for a format that does not say it
    counts: dict[str, int]  # of links, joints, geoms and devices, by what one of them is called
    entries: tuple[Entry, ...]  # what became of each part of the robot
    proof: Proof  # how far what was written is from the robot

    @property
    def facts(self) -> dict[str, Any]:
        """The result for JSON; lengths in m, masses in kg."""
        return {
            "version": VERSION,
            "urdfkit": __version__,
            "to": self.to,
            "file": self.file,
            "base": self.root,
            "counts": {f"{thing}s": number for thing, number in self.counts.items()},
            "proof": {"holds": self.proof.holds, **self.proof._asdict()},
            "parts": [
                {
                    "part": one.part,
                    "file": shown(one.span.source.path),
                    "line": one.span.line,
                    "result": one.result.value,
                    "note": one.note,
                }
                for one in self.entries
            ],
        }

    def alike(self, result: Result) -> Iterator[tuple[str, list[Entry]]]:
        """The parts with a result, those with one note together, in the order of the document.

        What is in an element with the same result goes without saying.
        """
        parts: dict[str, list[Entry]] = {}
        last = ""
        for entry in self.entries:
            if entry.result is result and not (
                last and entry.part.startswith((f"{last}/", f"{last}@"))
            ):
                parts.setdefault(entry.note, []).append(entry)
                last = entry.part
        yield from parts.items()

    def write_report(self, directory: str) -> None:
        """Write the facts into the directory of the conversion."""
        text = json.dumps(self.facts, indent=1, ensure_ascii=False)
        atomic.write(os.path.join(directory, REPORT), text.encode(), durable=False)
