"""How many findings of a report can be fixed, and why the others cannot."""

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
    """What ``fix`` would do about the findings of a check with the same options.

    Safe fixes are tried, as ``fix`` does; how many of the others hold is known only then.

    Raises:
        UrdfkitError: as of ``check``.
    """
    resolver = Resolver(options.with_config().packages, texts=options.texts)
    fix_reasons = FixReasons(report.files, resolver, rule_index.named(options.select))
    left = fix_reasons.of_report(report)
    if not any(one.diagnostic.fix and not one.reason for one in left):
        return counted(left)
    from urdfkit.lint.fix import session  # most reports have no safe fix

    fixes = session(files, options, unsafe=False, force=False).run()
    return counted(fixes.left)._replace(safe=len(fixes.applied))


def counted(left: Iterable[UnappliedFix]) -> Fixable:
    """What could be done about findings that are left."""
    with_fix = [one for one in left if one.diagnostic.fix]
    reasons = Counter(one.reason for one in with_fix)
    return Fixable(
        reasons.pop("", 0),
        reasons.pop("unsafe", 0),
        tuple(sorted({one.diagnostic.code for one in with_fix if one.reason == "info"})),
        tuple(sorted(item for item in reasons.items() if item[0] != "info")),
    )
