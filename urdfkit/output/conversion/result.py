"""The result of a conversion: files, and the result for each part of the robot."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from typing import Any

from urdfkit import __version__
from urdfkit.core import atomic
from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.conversion.losses import Entry, Result
from urdfkit.text.source import shown

#: Report file, with the result for each part; it marks a directory as a conversion.
REPORT = "conversion.json"
VERSION = 1


class Proof(Record):
    """Comparison of the converted robot with the original."""

    holds: bool  # True if all differences are within the bounds
    agreed: str  # summary of a proof that holds; a sentence
    disagreed: str  # summary of a proof that fails: a sentence with the differences
    #: The differences, and under ``part`` the link or joint that differs most, if it is known.
    differences: dict[str, Any]


def proven(proof: Proof, robot: Context) -> Proof:
    """The same proof, if it holds.

    Raises:
        UrdfkitError: the proof fails; located at the link or joint that differs most.
    """
    if not proof.holds:
        place = robot.model.place(proof.differences.get("part", ""))
        raise UrdfkitError(
            f"{place}: {proof.disagreed}; nothing is written: this is a "
            "bug in the conversion, not in the robot: please report it with the file"
        )
    return proof


class Conversion(Record):
    """The result of a conversion."""

    to: str  # the format
    file: str  # of the robot, in the directory
    root: str  # "free" or "fixed" to the world; empty for a format that does not define it
    counts: dict[str, int]  # of links, joints, geoms and devices, by the singular noun
    entries: tuple[Entry, ...]  # result for each part of the robot
    proof: Proof  # differences between the converted robot and the original

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
            "proof": {"holds": self.proof.holds, **self.proof.differences},
            "parts": [
                {
                    "part": entry.part,
                    "file": shown(entry.span.source.path),
                    "line": entry.span.line,
                    "result": entry.result.value,
                    "note": entry.note,
                }
                for entry in self.entries
            ],
        }

    def grouped(self, result: Result) -> Iterator[tuple[str, list[Entry]]]:
        """Parts with a result, grouped by note, in document order.

        Parts inside an element with the same result are omitted.
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
