"""Expanding on to the next error: what cannot go on without a tag starts again without it."""

from __future__ import annotations

import os

from urdfkit.xacro.budget import deadline
from urdfkit.xacro.engine import load_engine
from urdfkit.xacro.errors import is_of_process
from urdfkit.xacro.expansion import ExpansionRequest, ExpansionRun
from urdfkit.xacro.expansion_log import ExpansionLog
from urdfkit.xacro.file_reader import FileReader
from urdfkit.xacro.watchdog import watched

#: Expansions of one file.
MAX_RUNS = 50


def attempt(request: ExpansionRequest) -> ExpansionRun:
    """Expand a file as far as it goes.

    Returns:
        The last run; its log has the problems of all.
    """
    log = ExpansionLog()
    near = os.path.join(request.root_dir, request.source.path)
    reader = FileReader(request.source, request.resolver, near=near, trust=request.trust)
    until = deadline()
    for _ in range(MAX_RUNS):
        log.begin()
        run = ExpansionRun(request, log, reader, until)
        error = _once(run)
        if error is None or not _takes_out(run, error):
            break
    return run


def _takes_out(run: ExpansionRun, error: BaseException) -> bool:
    from urdfkit.xacro import failures  # which a run without errors does without

    return failures.take_out(run, error)


def _once(run: ExpansionRun) -> BaseException | None:
    """Expand once; the error that stopped it, or None."""
    try:
        with watched(run.budget):
            run.document = load_engine().expand(run)
    except (Exception, RecursionError, MemoryError) as error:
        if is_of_process(error):
            return run.budget.out_of_memory().with_traceback(error.__traceback__)
        return error
    return None
