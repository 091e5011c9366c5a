"""The rules over one Context."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING, TypeVar
from urdfkit.errors import Cancelled, NotApplicable, Unavailable
from urdfkit.lint import rule_index
from urdfkit.lint.context import Context, RunState
from urdfkit.lint.findings import bounded, diagnose
from urdfkit.lint.options import Options
from urdfkit.lint.report import Crashed, Skipped, Superseded, crash
from urdfkit.lint.rules import Finding, Rule
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.document import Attribute, Element
from urdfkit.text.file_kinds import is_launch

if TYPE_CHECKING:
    from urdfkit.lint.ignore_comments import Ignore
    from urdfkit.ros.targets import Targets

T = TypeVar("T")

#: The family of the rules about the checking itself.
OWN_FAMILY = "checking"

#: Families of rules that apply to launch files.
LAUNCH_FAMILIES = frozenset(("checking", "launch", "package", "worlds"))

#: Findings of one rule in one file; more help nobody.
MAX_FINDINGS = 1000


class FileResult(Record):
    """What the rules say about one description."""

    diagnostics: tuple[Diagnostic, ...]  # in the order of the rules
    #: skipped and crashed: rules that did not run, or failed.
    skipped: tuple[Skipped, ...]
    crashed: tuple[Crashed, ...]
    ran: frozenset[str]  # codes of the rules that ran
    targets: Targets | None  # the programs that severities depend on; None if none does
    suppressed: int  # how many findings the model's comments or the configuration suppress
    #: Those given that the description never mentions, with the one meant; those of the
    #: configuration by the words that say which robot has none, those given to all by none.
    unknown_arguments: Mapping[str, Mapping[str, str]] = {}
    #: Findings that follow from others, which are reported in their place.
    superseded: Superseded = Superseded((), ())


def run_rules(
    context: Context, chosen: Sequence[str], options: Options = Options(preview=True)
) -> FileResult:
    """Run rules over a description.

    Args:
        options: whose configuration changes severities and options of rules, and leaves findings
            out; resolved.
    """
    context.run = RunState(options.config.options)
    run = _RuleRun(context, options)
    # The rules about the checking itself look at what the others found.
    own = [code for code in chosen if code in rule_index.of_family(OWN_FAMILY)]
    others = [code for code in chosen if code not in own]
    run.rules(others)
    context.run = RunState(options.config.options, tuple(run.diagnostics), frozenset(chosen))
    run.ignores = run.guarded(lambda: context.ignores, ())
    if rule_index.NOT_CHECKED in own:
        own.remove(rule_index.NOT_CHECKED)
        lacking = context.reading.missing_argument_codes
        wants_arguments = bool(lacking) and lacking.isdisjoint(chosen)
        is_unexplained = wants_arguments or not run.explains_failure()
        looks_elsewhere = others and {*map(rule_index.family_of, others)} <= LAUNCH_FAMILIES
        is_unchecked = is_unexplained and not (context.is_readable or looks_elsewhere)
        if is_unchecked or context.unchecked:
            run.rules([rule_index.NOT_CHECKED])
            context.run = context.run._replace(diagnostics=tuple(run.diagnostics))
    if run.ignores:
        run.rules(own)
    return run.result()


class _RuleRun:
    """Gathers what the rules say about one context."""

    def __init__(self, context: Context, options: Options) -> None:
        self.context = context
        self.options = options
        self.config = options.config
        self.diagnostics: list[Diagnostic] = []
        self.skipped: list[Skipped] = []
        self.crashed: list[Crashed] = []
        self.ran: set[str] = set()
        self._asked: dict[str, Rule] = {}
        self.ignores: tuple[Ignore, ...] = ()

    def guarded(self, look: Callable[[], T], otherwise: T) -> T:
        """The value of a function, or another value if it fails."""
        try:
            return look()
        except Exception as error:  # a bug in urdfkit must not hide what the rules find
            self.crashed.append(crash("", self.context.source.path, error))
            return otherwise

    def rules(self, chosen: Iterable[str]) -> None:
        """Run those of some rules whose family applies to the context.

        Raises:
            Cancelled: the result is not wanted any more.
        """
        families: dict[str, list[str]] = {}
        for code in chosen:
            families.setdefault(rule_index.family_of(code), []).append(code)
        for family, codes in families.items():
            applicable = self._applicable(family, codes)
            for rule in filter(self._is_chosen, map(rule_index.get, applicable)):
                if self.options.is_cancelled and self.options.is_cancelled():
                    raise Cancelled("the check was cancelled")
                self._rule(rule)

    def _is_chosen(self, rule: Rule) -> bool:
        """False for a preview rule that is not selected, and for one that takes too long."""
        if rule.preview and not self.options.previews(rule.code):
            return False
        configured = self.config.severities.get(rule.code)
        is_skipped = bool(rule.needs & self.options.only_errors)
        return not is_skipped or rule.may_report_errors(configured)

    def _rule(self, rule: Rule) -> None:
        self._asked[rule.code] = rule
        findings = self._findings(rule)
        if not findings:
            return
        try:
            findings = self._with_consistent_fixes(findings)
            # Detected only where severities depend on them.
            targets = self.context.targets.names if findings and rule.by_target else ()
            findings = [self._of_what_is_loaded(rule, finding, targets) for finding in findings]
            if self.context.given_targets:
                findings = [self._as_target_says(rule, finding, targets) for finding in findings]
            self.diagnostics += map(self._configured, diagnose(rule, findings, targets))
        except Exception as error:
            self.ran.discard(rule.code)
            self.crashed.append(crash(rule.code, self.context.source.path, error))

    def _applicable(self, family: str, codes: list[str]) -> list[str]:
        """Those rules of a family that may have something to report."""
        path = self.context.source.path
        if is_launch(path) and family not in LAUNCH_FAMILIES:
            return []
        if self.context.given_targets and self.context.targets.passes_over(family):
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
        """A finding with the places of its numbers in data files."""
        if finding.node is None:
            return finding
        places = self.context.data_places(finding.node)
        return finding._replace(data=places) if places else finding

    def _with_consistent_fixes(self, findings: list[Finding]) -> list[Finding]:
        """Findings with the fixes on which all uses of a macro agree."""
        if not any(finding.fix for finding in findings):
            return findings
        reading = self.context.reading
        if reading.xacro is None or reading.document is None:
            return findings
        from urdfkit.lint.fix_consistency import without_inconsistent_fixes

        return without_inconsistent_fixes(findings, self.context.uses)

    def _of_what_is_loaded(self, rule: Rule, finding: Finding, targets: Iterable[str]) -> Finding:
        """A finding, which is no error in a visual that no target loads."""
        severity = finding.severity or rule.severity_for(targets)[0]
        if severity is not Severity.ERROR or self.context.loads_visuals:
            return finding
        if not _is_of_visual(finding.node):
            return finding
        return finding._replace(severity=Severity.WARNING, targets=())

    def _as_target_says(self, rule: Rule, finding: Finding, targets: Iterable[str]) -> Finding:
        """A finding as severe as the facts about the given targets say.

        What one of them has no severity for stays as it is, and so does a finding that the rule
        gives a severity of its own, unless all of them take what it is about.
        """
        given = self.context.given_facts
        stated = {one.name: one.severities.get(rule.code) for one in given}
        severity = finding.severity or rule.severity_for(targets)[0]
        each = {name: Severity(one) if one else severity for name, one in stated.items()}
        worst = min(each.values(), key=lambda one: one.rank)
        if worst is severity or (finding.severity and worst.rank < severity.rank):
            return finding
        return finding._replace(
            severity=worst, targets=tuple(name for name, one in each.items() if one is worst)
        )

    def _configured(self, diagnostic: Diagnostic) -> Diagnostic:
        severity = self.config.severities.get(diagnostic.code)
        return diagnostic if severity is None else diagnostic._replace(severity=severity)

    def explains_failure(self) -> bool:
        """True if an error that nothing suppresses says why the robot is not read."""
        return any(
            found.severity is Severity.ERROR or found.code in rule_index.NOT_EXPANDED
            for found in self._kept()
        )

    def _kept(self) -> tuple[Diagnostic, ...]:
        """The findings that neither the configuration nor a comment suppresses."""
        diagnostics = tuple(d for d in self.diagnostics if not self._left_out(d))
        if not self.ignores:
            return diagnostics
        from urdfkit.lint.suppress import apply_suppressions

        return apply_suppressions(diagnostics, self.ignores).kept

    def result(self) -> FileResult:
        diagnostics = self._kept()
        left_out = len(self.diagnostics) - len(diagnostics)
        diagnostics, superseded = _without_consequences(diagnostics, self._asked)
        targets = self.context.targets if "targets" in vars(self.context) else None
        return FileResult(
            diagnostics,
            tuple(self.skipped),
            tuple(self._distinct_crashes()),
            frozenset(self.ran),
            targets,
            left_out,
            superseded=superseded,
        )

    def _distinct_crashes(self) -> Iterator[Crashed]:
        """Without the failed looks at the robot that rules have failed with, too."""
        of_rules = {crashed.error for crashed in self.crashed if crashed.code}
        reported: set[str] = set()
        for crashed in self.crashed:
            if crashed.code or crashed.error not in of_rules | reported:
                reported.add(crashed.error)
                yield crashed

    def _left_out(self, diagnostic: Diagnostic) -> bool:
        config = self.config
        is_unsure = diagnostic.confidence.rank > config.min_confidence.rank
        path = diagnostic.span.source.path
        return is_unsure or config.ignores(diagnostic.code, path, diagnostic.severity)


def _is_of_visual(node: Element | Attribute | None) -> bool:
    """True for what is in a visual; its material is read even where visuals are not loaded."""
    element = node.element if isinstance(node, Attribute) else node
    while element is not None and element.tag not in ("visual", "material"):
        element = element.parent
    return element is not None and element.tag == "visual"


def _without_consequences(
    diagnostics: tuple[Diagnostic, ...], rules: Mapping[str, Rule]
) -> tuple[tuple[Diagnostic, ...], Superseded]:
    """Findings without what follows from others, which are then as severe as that; and that."""
    causes = [one for one in diagnostics if _hides_parts(one, rules[one.code])]
    if not causes:
        return diagnostics, Superseded((), ())
    kept: list[Diagnostic] = []
    hidden: list[Diagnostic] = []
    for one in diagnostics:
        (hidden if rules[one.code].reports_missing else kept).append(one)
    for place, found in enumerate(kept):
        if found in causes:
            worst = min((found, *hidden), key=lambda one: one.severity.rank)
            kept[place] = found._replace(severity=worst.severity)
    return tuple(kept), Superseded(tuple(causes), tuple(hidden))


def _hides_parts(diagnostic: Diagnostic, rule: Rule) -> bool:
    """True if the robot lacks parts for a tag or a name that xacro did not expand.

    A macro that is not called makes no link, and a name that is not expanded is none: what then
    says that something is missing is the same defect again.
    """
    if not rule.hides_parts or "" in rule.hides_parts:
        return bool(rule.hides_parts)
    places = [call.element for call in diagnostic.calls]
    return any(not place or place.rpartition("@")[2] in rule.hides_parts for place in places)
