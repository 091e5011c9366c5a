"""Checks in several processes."""

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
