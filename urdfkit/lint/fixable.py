"""Number of findings of a report that can be fixed, and reasons for the others."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable

from urdfkit.lint import rule_index
from urdfkit.lint.fix_reasons import FixReasons, UnappliedFix
from urdfkit.lint.options import Options
from urdfkit.lint.report import Fixable, Report
from urdfkit.workspace.resolve import Resolver


def fixable(report: Report, options: Options, files: Iterable[str | os.PathLike[str]]) -> Fixable:
    """The number of findings that ``fix`` would fix, for a check with the same options.

    Safe fixes are tried like in ``fix``. Unsafe fixes are counted without a trial.

    Raises:
        UrdfkitError: see ``check``.
    """
    resolver = Resolver(options.with_config().packages, texts=options.texts)
    fix_reasons = FixReasons(report.files, resolver, rule_index.named(options.select))
    left = fix_reasons.of_report(report)
    if not any(unapplied.diagnostic.fix and not unapplied.reason for unapplied in left):
        return counted(left)
    from urdfkit.lint.fix import session  # most reports have no safe fix

    fixes = session(files, options, unsafe=False, force=False).run()
    reported = {diagnostic.code for diagnostic in report.diagnostics}
    # The fix of a file that cannot be read reveals others, which the report does not have.
    shown = [unapplied for unapplied in fixes.left if unapplied.diagnostic.code in reported]
    return counted(shown)._replace(safe=len(fixes.applied))


def counted(left: Iterable[UnappliedFix]) -> Fixable:
    """The counts of unapplied fixes by reason."""
    with_fix = [unapplied for unapplied in left if unapplied.diagnostic.fix]
    reasons = Counter(unapplied.reason for unapplied in with_fix)
    infos = {unapplied.diagnostic.code for unapplied in with_fix if unapplied.reason == "info"}
    return Fixable(
        reasons.pop("", 0),
        reasons.pop("unsafe", 0),
        tuple(sorted(infos)),
        tuple(sorted(item for item in reasons.items() if item[0] != "info")),
    )
