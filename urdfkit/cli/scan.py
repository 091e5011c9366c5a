"""``urdfkit scan``: check collections of models."""

import os
from importlib.util import find_spec
from typing import Any

import click

from urdfkit.cli import options, output
from urdfkit.cli.decorators import choice, described, no_stream, option
from urdfkit.cli.progress import progress_bar
from urdfkit.core import atomic, limits
from urdfkit.core.installation import install_command
from urdfkit.core.words import counted
from urdfkit.errors import UnreadableFile
from urdfkit.lint.options import Options
from urdfkit.scan import journal, page
from urdfkit.scan.isolated import Settings
from urdfkit.scan.run import scan
from urdfkit.scan.summary import summarise
from urdfkit.scan.tables import FINDINGS, MODELS, write_tables

#: The page that ``urdfkit scan summary`` writes.
PAGE = "summary.html"


class _Scan(click.Command):
    """The command, with the subcommand ``urdfkit scan summary``."""

    def make_context(
        self,
        info_name: str | None,
        args: list[str],
        parent: click.Context | None = None,
        **more: Any,
    ) -> click.Context:
        if args[:1] == ["summary"]:
            return summary.make_context(f"{info_name} summary", args[1:], parent, **more)
        return super().make_context(info_name, args, parent, **more)


@described("scan", cls=_Scan)
@click.argument("sources", nargs=-1, required=True, metavar="SOURCE...")
@option(
    "-o, --output DIR",
    "Directory of the results.",
    to="directory",
    required=True,
    callback=no_stream,
)
@option("--jobs N", "Processes. [default: one per processor]", type=click.IntRange(1))
@option("--timeout SECONDS", "Limit of time for a model.", type=click.FloatRange(0.01), default=60)
@option("--memory GIB", "Limit of memory for a model.", type=click.FloatRange(0.1), default=4)
@choice("--engine", of=["local", "dask"], help="Engine that runs the processes.")
@option("--address URL", "Address of the Dask scheduler.", default="", show_default=False)
@option("--select CODES", "Run only these rules.", multiple=True)
@option("--ignore CODES", "Do not run these rules.", multiple=True)
@option("--target NAMES", "Target program.", multiple=True)
@option("--package NAME=DIR", "Directory of a ROS package.", multiple=True)
def command(
    sources: tuple[str, ...],
    directory: str,
    jobs: int | None,
    timeout: float,
    memory: float,
    engine: str,
    address: str,
    **values: Any,
) -> int:
    """Check collections of models: a row for each model and finding.

    SOURCE is a directory (its .urdf and .urdf.xacro files), a description, a glob, a .zip or .tar
    archive, or a .txt file that lists these. Results are written to results.jsonl in DIR during the
    run and, if pyarrow is installed, to models.parquet and findings.parquet at the end. The same
    command resumes an interrupted run. 'urdfkit scan summary DIR' summarises DIR.

    A model that crashes, hangs or takes too much memory has a row with the reason, as does an
    archive or a list that cannot be read.

    Exit codes: 0 done, 2 usage error, or a source has no model or cannot be read, 130 stopped by
    Ctrl-C.

    Examples:
        urdfkit scan partnet-mobility/ -o results
        urdfkit scan 'zoo/**/*.urdf' more.zip list.txt -o results --jobs 8
        urdfkit scan models/ -o results --engine dask --address tcp://host:8786
        urdfkit scan summary results
    """
    settings = Options(
        packages=options.packages(values),
        select=options.selected(values),
        ignore=options.ignored(values),
        targets=options.words(values, "target"),
    )
    if address and engine != "dask":
        raise options.UsageError("--address needs --engine dask")
    with progress_bar("models", rated=True) as bar:
        checked, unreadable = scan(
            sources,
            directory,
            Settings(settings, timeout, int(memory * 2**30)),
            engine=engine,
            address=address,
            jobs=jobs or limits.processors(),
            progress=bar,
        )
    files = [journal.RESULTS]
    if find_spec("pyarrow"):
        write_tables(directory)
        files += [MODELS, FINDINGS]
    else:
        options.warn(f"no Parquet files without pyarrow: {install_command('scan')}")
    output.page(
        output.indented(
            f"{counted(checked, 'model')} checked; {directory} has {', '.join(files)}", ""
        )
    )
    if unreadable:
        raise UnreadableFile("; ".join(unreadable.values()))
    return 0


@described("summary")
@click.argument("directory", metavar="DIR")
def summary(directory: str) -> int:
    """Summarise the results of a scan: on standard output, and as DIR/summary.html.

    Rates per rule, models with the same content, outliers, and models that were not checked.

    Examples:
        urdfkit scan summary results
    """
    result = summarise(journal.rows(directory))
    page_text = page.html(result, f"Scan {os.path.basename(os.path.abspath(directory))}")
    atomic.write(os.path.join(directory, PAGE), output.encode(page_text))
    output.page(page.text(result))
    return 0
