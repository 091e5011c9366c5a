"""``scan``: checks the models of sources and writes a results directory."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from threading import Thread
from typing import Any

from urdfkit.core.progress import Progress
from urdfkit.errors import UnreadableFile
from urdfkit.scan.engines import dask, local
from urdfkit.scan.isolated import Settings
from urdfkit.scan.journal import Journal
from urdfkit.scan.models import Extraction, Model, models, require_sources


def scan(
    sources: Iterable[str],
    directory: str,
    settings: Settings,
    *,
    engine: str = "local",
    address: str = "",
    jobs: int = 1,
    progress: Progress | None = None,
) -> tuple[int, dict[str, str]]:
    """Check the models of sources that are not yet in a results directory.

    Args:
        sources: descriptions, directories, globs, archives, and files that list these.
        directory: of the results; a stopped run is resumed.
        engine: ``local`` or ``dask``.
        address: of a Dask scheduler; empty for a cluster on this machine.
        progress: called with the number of models finished in this run and the total number; 0
            until the models are counted.

    Returns:
        The number of models that were checked in this run, and the unreadable sources with the
        reasons; these have a row in the results, too.

    Raises:
        UrdfkitError: a source does not exist, no source contains a model, the results cannot be
            written, the options are invalid, or Dask is not installed.
    """
    sources = tuple(sources)
    settings.options.resolved()  # rejects invalid options now
    require_sources(sources)
    unreadable: dict[str, str] = {}
    with Journal(directory, _effective_options(settings)) as journal, Extraction() as extraction:
        finished = len(journal.done)
        total = _counted(sources)
        pending = _pending(models(sources), journal.done, extraction, unreadable)
        if engine == "dask":
            rows = dask(pending, settings, jobs, address)
        else:
            rows = local(pending, settings, jobs)
        checked = 0
        for count, row in enumerate(rows, 1):
            journal.write(row)
            checked += row.model not in unreadable
            if progress is not None:
                progress(count, total[0] - finished if total else 0)
        if not journal.done:
            raise UnreadableFile(f"there is no model in {', '.join(map(repr, sources))}")
    return checked, unreadable


def _pending(
    candidates: Iterable[Model], done: set[str], extraction: Extraction, unreadable: dict[str, str]
) -> Iterator[Model]:
    """The models that are not done, without repetitions.

    Args:
        unreadable: receives the unreadable sources with the reasons.
    """
    for model in candidates:
        is_new = model.name not in done
        done.add(model.name)
        ready = extraction.on_disk(model) if is_new else model
        if ready.problem:
            unreadable[ready.archive or ready.name] = ready.problem
        if is_new:
            yield ready


def _counted(sources: tuple[str, ...]) -> list[int]:
    """A list to which the number of all models is appended once they are counted."""
    total: list[int] = []

    def count() -> None:
        total.append(sum(1 for _ in models(sources)))

    Thread(target=count, daemon=True).start()
    return total


def _effective_options(settings: Settings) -> dict[str, Any]:
    """The options that affect the results, as JSON."""
    options = settings.options
    return {
        "select": sorted(options.select),
        "ignore": sorted(options.ignore),
        "targets": sorted(options.targets),
        "packages": dict(options.packages),
        "seconds": settings.seconds,
        "memory": settings.memory,
    }
