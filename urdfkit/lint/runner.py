"""Runs rules on one Context."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.core.suggest import is_typo
from urdfkit.errors import Cancelled, NotApplicable, Unavailable
from urdfkit.lint import rule_index
from urdfkit.lint.context import Context
from urdfkit.lint.findings import bounded, diagnose, without_inconsistent_fixes
from urdfkit.lint.options import Options
from urdfkit.lint.report import Crashed, Skipped, Superseded, crash
from urdfkit.lint.rules import Finding, Rule
from urdfkit.lint.run_state import RunState
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.document import Attribute, Element

if TYPE_CHECKING:
    from urdfkit.lint.ignore_comments import Ignore
    from urdfkit.ros.targets import Targets

#: The family of the rules about the checking itself.
OWN_FAMILY = "checking"

#: Families of rules that apply to launch files.
LAUNCH_FAMILIES = frozenset(("bringup", "checking", "launch", "package", "worlds"))

#: The rules that report missing links or joints by a name, or that a link is not connected.
_OF_LINKS = frozenset(
    ("GAZ001", "GAZ021", "GAZ058", "JNT015", "RCT001", "REF001", "SRD001", "SRD026", "TRE002")
)

#: Most findings of one rule in one file.
MAX_FINDINGS = 1000


class FileResult(Record):
    """The results of the rules for one description."""

    diagnostics: tuple[Diagnostic, ...]  # in the order of the rules
    skipped: tuple[Skipped, ...]  # rules that did not run
    crashed: tuple[Crashed, ...]  # rules that failed
    ran: frozenset[str]  # codes of the rules that ran
    targets: Targets | None  # the targets that severities depend on; None if none does
    suppressed: int  # number of findings that comments or the configuration suppress
    #: Arguments that the description does not declare, with the suggested name. The outer key is
    #: the origin in the configuration, or empty for arguments of the command line.
    unknown_arguments: Mapping[str, Mapping[str, str]] = {}
    #: Findings that are consequences of others, which are reported instead.
    superseded: Superseded = Superseded((), ())
    srdf: str = ""  # path of the SRDF that was read; empty if there was none


def run_rules(
    context: Context, chosen: Sequence[str], options: Options = Options(preview=True)
) -> FileResult:
    """Run rules on a description.

    Args:
        options: resolved; its configuration changes severities and options of rules, and
            suppresses findings.
    """
    context.is_checked = True
    context.run = RunState(options.config.options)
    run = _RuleRun(context, options)
    # The rules about the checking itself read the findings of the others.
    own = [code for code in chosen if code in rule_index.of_family(OWN_FAMILY)]
    others = [code for code in chosen if code not in own]
    run.rules(others)
    context.run = RunState(options.config.options, tuple(run.diagnostics), frozenset(chosen))
    run.read_ignores()
    if rule_index.NOT_CHECKED in own:
        own.remove(rule_index.NOT_CHECKED)
        missing = context.reading.missing_argument_codes
        needs_arguments = bool(missing) and missing.isdisjoint(chosen)
        is_unexplained = needs_arguments or not run.explains_failure()
        is_for_launch = others and {*map(rule_index.family_of, others)} <= LAUNCH_FAMILIES
        is_unchecked = is_unexplained and not (context.is_readable or is_for_launch)
        simulating = rule_index.of_family("simulation")
        may_not_simulate = context.is_readable and not simulating.isdisjoint(others)
        if is_unchecked or context.unchecked or may_not_simulate:
            run.rules([rule_index.NOT_CHECKED])
            context.run = context.run._replace(diagnostics=tuple(run.diagnostics))
    if run.ignores:
        run.rules(own)
    return run.result()


class _RuleRun:
    """Collects the findings of rules for one context."""

    def __init__(self, context: Context, options: Options) -> None:
        self.context = context
        self.options = options
        self.config = options.config
        self.diagnostics: list[Diagnostic] = []
        self.skipped: list[Skipped] = []
        self.crashed: list[Crashed] = []
        self.ran: set[str] = set()
        self._rules: dict[str, Rule] = {}
        self.ignores: tuple[Ignore, ...] = ()

    def read_ignores(self) -> None:
        """Read the comments that suppress findings."""
        try:
            self.ignores = self.context.ignores
        except Exception as error:  # a bug in urdfkit must not hide the findings of the rules
            self.crashed.append(crash("", self.context.source.path, error))

    def rules(self, chosen: Iterable[str]) -> None:
        """Run the rules whose family applies to the context.

        Raises:
            Cancelled: the result is no longer needed.
        """
        families = by_key((rule_index.family_of(code), code) for code in chosen)
        for family, codes in families.items():
            applicable = self._applicable(family, codes)
            for rule in filter(self._is_chosen, map(rule_index.get, applicable)):
                if self.options.is_cancelled and self.options.is_cancelled():
                    raise Cancelled("the check was cancelled")
                self._rule(rule)

    def _is_chosen(self, rule: Rule) -> bool:
        """False for preview rules that are not selected, and for slow rules without errors."""
        if rule.preview and not self.options.previews(rule.code):
            return False
        configured = self.config.severities.get(rule.code)
        is_skipped = bool(rule.needs & self.options.only_errors)
        return not is_skipped or rule.may_report_errors(configured)

    def _rule(self, rule: Rule) -> None:
        self._rules[rule.code] = rule
        findings = self._findings(rule)
        if not findings:
            return
        try:
            findings = self._with_consistent_fixes(findings)
            # Targets are detected only if severities depend on them.
            targets = self.context.targets.names if findings and rule.by_target else ()
            findings = [self._lowered_in_visual(rule, finding, targets) for finding in findings]
            if self.context.given_targets:
                findings = [self._with_target_facts(rule, finding, targets) for finding in findings]
            self.diagnostics += map(self._configured, diagnose(rule, findings, targets))
        except Exception as error:
            self.ran.discard(rule.code)
            self.crashed.append(crash(rule.code, self.context.source.path, error))

    def _applicable(self, family: str, codes: list[str]) -> list[str]:
        """The rules of a family that may apply to the context."""
        path = self.context.source.path
        if self.context.is_bringup and family not in LAUNCH_FAMILIES:
            return []
        if self.context.given_targets and self.context.targets.ignore(family):
            return []
        try:
            return rule_index.applicable(family, codes, self.context)
        except NotApplicable:
            pass
        except Unavailable as reason:
            self.skipped += [Skipped(code, path, str(reason)) for code in codes]
        except Exception as error:
            self.crashed += [crash(code, path, error) for code in codes]
        return []

    def _findings(self, rule: Rule) -> list[Finding]:
        path = self.context.source.path
        findings: list[Finding] = []
        try:
            for finding in rule.check(self.context):
                findings.append(self._with_data(bounded(finding)))
                if len(findings) >= MAX_FINDINGS:
                    break
            self.ran.add(rule.code)
        except NotApplicable:
            pass
        except Unavailable as reason:
            self.skipped.append(Skipped(rule.code, path, str(reason)))
        except Exception as error:  # a bug in a rule must not hide the other rules
            self.crashed.append(crash(rule.code, path, error))
        return findings

    def _with_data(self, finding: Finding) -> Finding:
        """A finding with the places in data files of its values."""
        if finding.node is None or finding.is_about_name:
            return finding
        return finding._replace(data=self.context.data_places(finding.node))

    def _with_consistent_fixes(self, findings: list[Finding]) -> list[Finding]:
        """Findings without the fixes that not all uses of a macro propose."""
        if not any(finding.fix for finding in findings):
            return findings
        reading = self.context.reading
        if reading.xacro is None or reading.document is None:
            return findings
        return without_inconsistent_fixes(findings, self.context.uses)

    def _lowered_in_visual(self, rule: Rule, finding: Finding, targets: Iterable[str]) -> Finding:
        """A finding; an error in a visual that no target loads is lowered to a warning."""
        severity = finding.severity or rule.severity_for(targets)[0]
        if severity is not Severity.ERROR or self.context.loads_visuals:
            return finding
        if not _is_of_visual(finding.node):
            return finding
        return finding._replace(severity=Severity.WARNING, targets=())

    def _with_target_facts(self, rule: Rule, finding: Finding, targets: Iterable[str]) -> Finding:
        """A finding with the worst severity that the facts about the given targets state.

        A target whose facts state none keeps the severity of the finding. A finding with a severity
        of its own is only lowered.
        """
        severity = finding.severity or rule.severity_for(targets)[0]
        by_target = {
            facts.name: Severity(facts.severities.get(rule.code) or severity)
            for facts in self.context.given_facts
        }
        worst = min(by_target.values(), key=lambda severity: severity.rank)
        if worst is severity or (finding.severity and worst.rank < severity.rank):
            return finding
        affected = tuple(name for name, severity in by_target.items() if severity is worst)
        return finding._replace(severity=worst, targets=affected)

    def _configured(self, diagnostic: Diagnostic) -> Diagnostic:
        severity = self.config.severities.get(diagnostic.code)
        return diagnostic if severity is None else diagnostic._replace(severity=severity)

    def explains_failure(self) -> bool:
        """True if a finding that is not suppressed states why the robot cannot be read."""
        return any(
            diagnostic.severity is Severity.ERROR or diagnostic.code in rule_index.NOT_EXPANDED
            for diagnostic in self._unsuppressed()
        )

    def _unsuppressed(self) -> tuple[Diagnostic, ...]:
        """The findings that neither the configuration nor a comment suppresses."""
        diagnostics = tuple(d for d in self.diagnostics if not self._is_ignored(d))
        if not self.ignores:
            return diagnostics
        from urdfkit.lint.suppress import apply_suppressions

        return apply_suppressions(diagnostics, self.ignores).kept

    def result(self) -> FileResult:
        diagnostics = self._unsuppressed()
        suppressed = len(self.diagnostics) - len(diagnostics)
        if self.context.part is not None:  # what is missing may be in a package that is not found
            diagnostics = tuple(
                d
                for d in diagnostics
                if not self._rules[d.code].reports_missing
                or _corrects_typo(d)
                or (d.code in _OF_LINKS and self.context.xacro.has_all_links)
            )
        diagnostics, superseded = _without_consequences(diagnostics, self._rules)
        targets = self.context.targets if "targets" in vars(self.context) else None
        return FileResult(
            diagnostics,
            tuple(self.skipped),
            tuple(self._distinct_crashes()),
            frozenset(self.ran),
            targets,
            suppressed,
            superseded=superseded,
        )

    def _distinct_crashes(self) -> Iterator[Crashed]:
        """Crashes, without those outside of rules that repeat the error of a rule."""
        of_rules = {crashed.error for crashed in self.crashed if crashed.code}
        reported: set[str] = set()
        for crashed in self.crashed:
            if crashed.code or crashed.error not in of_rules | reported:
                reported.add(crashed.error)
                yield crashed

    def _is_ignored(self, diagnostic: Diagnostic) -> bool:
        config = self.config
        is_unsure = diagnostic.confidence.rank > config.min_confidence.rank
        path = diagnostic.span.source.path
        return is_unsure or config.ignores(diagnostic.code, path, diagnostic.severity)


def _is_of_visual(node: Element | Attribute | None) -> bool:
    """True inside a visual, except in its material, which is read even if visuals are not."""
    element = node.element if isinstance(node, Attribute) else node
    while element is not None and element.tag not in ("visual", "material"):
        element = element.parent
    return element is not None and element.tag == "visual"


def _corrects_typo(diagnostic: Diagnostic) -> bool:
    """True if the fix changes one letter of a name: that is no name in a missing package."""
    edits = diagnostic.fix.edits if diagnostic.fix else ()
    return any(edit.span.text and is_typo(edit.span.text, edit.text) for edit in edits)


def _without_consequences(
    diagnostics: tuple[Diagnostic, ...], rules: Mapping[str, Rule]
) -> tuple[tuple[Diagnostic, ...], Superseded]:
    """Findings without the consequences of others, and the superseded findings.

    A cause is as severe as the worst of its consequences.
    """
    causes = [finding for finding in diagnostics if _hides_parts(finding, rules[finding.code])]
    if not causes:
        return diagnostics, Superseded((), ())
    reported: list[Diagnostic] = []
    hidden: list[Diagnostic] = []
    for finding in diagnostics:
        (hidden if rules[finding.code].reports_missing else reported).append(finding)
    for index, finding in enumerate(reported):
        if finding in causes:
            worst = min((finding, *hidden), key=lambda each: each.severity.rank)
            reported[index] = finding._replace(severity=worst.severity)
    return tuple(reported), Superseded(tuple(causes), tuple(hidden))


def _hides_parts(diagnostic: Diagnostic, rule: Rule) -> bool:
    """True if the robot lacks parts because xacro did not expand a tag or a name.

    A macro that is not called creates no link, and a name that is not expanded does not exist.
    Findings about missing parts then repeat the same defect.
    """
    if not rule.hides_parts or "" in rule.hides_parts:
        return bool(rule.hides_parts)
    places = [call.element for call in diagnostic.calls]
    return any(not place or place.rpartition("@")[2] in rule.hides_parts for place in places)
