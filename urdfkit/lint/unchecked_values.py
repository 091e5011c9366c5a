"""Values of arguments in launch files that no description is checked with."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint.plan import Job
from urdfkit.lint.report import UncheckedValues

if TYPE_CHECKING:
    from urdfkit.lint.context import Context

#: Most additional sets of arguments that a robot is checked with; the UR arms have nine.
MAX_SETS = 16


def unchecked_values(
    candidates: list[dict[str, str]],
    checked: Iterable[tuple[Job, Context]],
    failed: Mapping[tuple[str, ...], Context],
) -> tuple[UncheckedValues, ...]:
    """The values of arguments that no description is checked with.

    Args:
        failed: descriptions that do not expand, by their values in the order of the names.
    """
    known = {item for job, _ in checked for item in job.arguments.items()}
    left: dict[tuple[str, str], dict[str, None]] = {}
    for values in candidates:
        context = failed.get(tuple(values.values()))
        why = f"only {MAX_SETS} sets of arguments are tried"
        if context is not None:
            from urdfkit.lint.unchecked import why_unchecked

            why, _ = why_unchecked(context.reading, context.source, context.resolver)
        for name, value in values.items():
            if (name, value) not in known:
                left.setdefault((name, why), {})[value] = None
    pairs = {*known, *(pair for values in candidates for pair in values.items())}
    totals = Counter(name for name, _ in pairs)
    return tuple(
        UncheckedValues(name, tuple(unchecked), totals[name], why)
        for (name, why), unchecked in left.items()
    )
