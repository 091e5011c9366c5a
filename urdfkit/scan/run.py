"""scan(): the models of some sources make a directory of results."""

from collections.abc import Iterable, Iterator
from threading import Thread
from typing import Any

from urdfkit.core.progress import Progress
from urdfkit.errors import UrdfkitError
from urdfkit.scan.engines import dask, local
from urdfkit.scan.isolated import Settings
from urdfkit.scan.journal import Journal
from urdfkit.scan.models import Extraction, Model, models


def scan(
    sources: Iterable[str],
    directory: str,
    settings: Settings,
    *,
    engine: str = "local",
    address: str = "",
    jobs: int = 1,
    progress: Progress | None = None,
) -> int:
    """Check the models of some sources that a directory of results does not hold yet.

    Args:
        sources: descriptions, directories, globs, archives, and files that list these.
        directory: of the results; a run that was stopped goes on in it.
        engine: ``local`` or ``dask``.
        address: of a scheduler of Dask; a cluster on this machine if empty.
        progress: called with the number of models done in this run, and of all that it does; 0
            until these are counted.

    Returns:
        How many models were checked now.

    Raises:
        UrdfkitError: a source cannot be read, the results cannot be written, the options mean
            nothing, or Dask is not installed.
    """
    sources = tuple(sources)
    settings.options.resolved()  # a wrong option stops here
    with Journal(directory, _deciding(settings)) as journal, Extraction() as extraction:
        known = len(journal.done)
        total = _counted(sources)
        wanted = map(extraction.on_disk, _new(models(sources), journal.done))
        if engine == "dask":
            rows = dask(wanted, settings, jobs, address)
        else:
            rows = local(wanted, settings, jobs)
        count = 0
        for count, row in enumerate(rows, 1):
            journal.write(row)
            if progress is not None:
                progress(count, total[0] - known if total else 0)
    return count


def _new(found: Iterable[Model], done: set[str]) -> Iterator[Model]:
    """The models that are not done; each once, though several sources name it."""
    for model in found:
        if model.name not in done:
            done.add(model.name)
            yield model


def _counted(sources: tuple[str, ...]) -> list[int]:
    """A list that will hold the number of all models, once they are counted."""
    total: list[int] = []

    def count() -> None:
        try:
            total.append(sum(1 for _ in models(sources)))
        except UrdfkitError:
            pass  # the scan raises it

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
