"""Checks in several processes."""

import subprocess
import sys

import pytest

from urdfkit.lint import processes
from urdfkit.lint.options import Options
from urdfkit.workspace.resolve import Resolver


def test_the_batches_of_a_check_share_a_resolver(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its caches hold the launch files of a workspace, which each batch read again.

    The next check has another one: files may have changed.
    """
    used: list[Resolver] = []
    monkeypatch.setattr(processes, "_own", Resolver(environment={}), raising=False)
    monkeypatch.setattr(processes, "_current", None)
    monkeypatch.setattr(
        processes, "check_one_of_many", lambda job, options, resolver: used.append(resolver)
    )
    for check in (1, 1, 2):
        processes._check_batch([None], Options(), check)  # type: ignore[list-item]
    first, second, third = used
    assert first is second
    assert first is not third


@pytest.mark.skipif(sys.platform == "win32", reason="forks")
def test_no_process_outlives_a_main_one_that_is_killed() -> None:
    """An editor kills its language server, a build job its check."""
    code = (
        "import os, time\n"
        "from urdfkit.lint import processes\n"
        "from urdfkit.lint.options import Options\n"
        "pool = processes.Workers().pool(2, ({}, Options(), False, ()))\n"
        "for _ in range(2):\n"
        "    pool.submit(time.sleep, 60)\n"
        "pool.submit(os.getpid)\n"
        "print('started', flush=True)\n"
        "time.sleep(60)\n"
    )
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == b"started\n"
        process.kill()
        assert process.stdout.read() == b"", "ends when no process has the pipe any more"
