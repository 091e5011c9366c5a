"""Notes on files that were changed, and are generated from others."""

from collections.abc import Iterable

from urdfkit.cli import output
from urdfkit.text.editing.rewriting import Rewrite
from urdfkit.text.source import Source, shown
from urdfkit.workspace.ownership import is_generated


def note_generated(files: Iterable[Rewrite]) -> None:
    """Print a note for each file that a program will write again, without the changes."""
    for file in files:
        if is_generated(Source(file.path, file.before)):
            output.note(
                f"{shown(file.path)} is generated: change the file that it is generated from, too"
            )
