"""Repeated expansion without the tags that failed, to find all errors."""

from __future__ import annotations

import os

from urdfkit.xacro.budget import deadline
from urdfkit.xacro.engine import load_engine
from urdfkit.xacro.errors import is_out_of_memory
from urdfkit.xacro.expansion import ExpansionRequest, ExpansionRun
from urdfkit.xacro.expansion_log import ExpansionLog
from urdfkit.xacro.file_reader import FileReader
from urdfkit.xacro.watchdog import watched

#: Most expansions of one file.
MAX_RUNS = 50


def expand_repeatedly(request: ExpansionRequest) -> ExpansionRun:
    """Expand a file; repeat it without the failed tag after an error.

    Returns:
        The last run; its log contains the problems of all runs.
    """
    log = ExpansionLog()
    near = os.path.join(request.root_dir, request.source.path)
    reader = FileReader(request.source, request.resolver, near=near, trust=request.trust)
    end = deadline()
    for _ in range(MAX_RUNS):
        log.begin_run()
        run = ExpansionRun(request, log, reader, end)
        error = _expand_once(run)
        if error is None:
            break
        from urdfkit.xacro import failures  # not needed without errors

        if not failures.remove_failed_tag(run, error):
            break
    return run


def _expand_once(run: ExpansionRun) -> BaseException | None:
    """Expand once; returns the error that stopped it, or None.

    Raises:
        Unavailable: there is no xacro of a supported version, which is no fault of the robot.
    """
    engine = load_engine()
    try:
        with watched(run.budget):
            run.document = engine.expand(run)
    except (Exception, RecursionError, MemoryError) as error:
        if is_out_of_memory(error):
            return run.budget.out_of_memory().with_traceback(error.__traceback__)
        return error
    return None
