"""scan(): the models of some sources make a directory of results."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from threading import Thread
from typing import Any

from urdfkit.core.progress import Progress
from urdfkit.core.record import Record
from urdfkit.errors import UnreadableFile
from urdfkit.scan.engines import dask, local
from urdfkit.scan.isolated import Settings
from urdfkit.scan.journal import Journal
from urdfkit.scan.models import Extraction, Model, models, require_sources


class Scanned(Record):
    """The outcome of a run."""

    models: int  # how many were checked in this run
    #: Sources that cannot be read, each with the reason; they have a row in the results, too.
    unreadable: dict[str, str]


def scan(
    sources: Iterable[str],
    directory: str,
    settings: Settings,
    *,
    engine: str = "local",
    address: str = "",
    jobs: int = 1,
    progress: Progress | None = None,
) -> Scanned:
    """Check the models of some sources that a directory of results does not hold yet.

    Args:
        sources: descriptions, directories, globs, archives, and files that list these.
        directory: of the results; a run that was stopped goes on in it.
        engine: ``local`` or ``dask``.
        address: of a scheduler of Dask; a cluster on this machine if empty.
        progress: called with the number of models done in this run, and of all that it does; 0
            until these are counted.

    Raises:
        UrdfkitError: a source does not exist, there is no model in any, the results cannot be
            written, the options mean nothing, or Dask is not installed.
    """
    sources = tuple(sources)
    settings.options.resolved()  # a wrong option stops here
    require_sources(sources)
    unreadable: dict[str, str] = {}
    with Journal(directory, _deciding(settings)) as journal, Extraction() as extraction:
        known = len(journal.done)
        total = _counted(sources)
        wanted = _wanted(models(sources), journal.done, extraction, unreadable)
        if engine == "dask":
            rows = dask(wanted, settings, jobs, address)
        else:
            rows = local(wanted, settings, jobs)
        checked = 0
        for count, row in enumerate(rows, 1):
            journal.write(row)
            checked += row.model not in unreadable
            if progress is not None:
                progress(count, total[0] - known if total else 0)
        if not journal.done:
            raise UnreadableFile(f"there is no model in {', '.join(map(repr, sources))}")
    return Scanned(checked, unreadable)


def _wanted(
    found: Iterable[Model], done: set[str], extraction: Extraction, unreadable: dict[str, str]
) -> Iterator[Model]:
    """The models that are not done; each once, though several sources name it.

    Args:
        unreadable: gets the sources that cannot be read.
    """
    for model in found:
        is_new = model.name not in done
        done.add(model.name)
        ready = extraction.on_disk(model) if is_new else model
        if ready.problem:
            unreadable[ready.archive or ready.name] = ready.problem
        if is_new:
            yield ready


def _counted(sources: tuple[str, ...]) -> list[int]:
    """A list that will hold the number of all models, once they are counted."""
    total: list[int] = []

    def count() -> None:
        total.append(sum(1 for _ in models(sources)))

    Thread(target=count, daemon=True).start()
    return total


def _deciding(settings: Settings) -> dict[str, Any]:
    """What decides the results, as JSON."""
    options = settings.options
    return {
        "select": sorted(options.select),
        "ignore": sorted(options.ignore),
        "targets": sorted(options.targets),
        "packages": dict(options.packages),
        "seconds": settings.seconds,
        "memory": settings.memory,
    }
