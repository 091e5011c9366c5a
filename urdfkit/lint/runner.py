"""The rules over one Subject."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, TypeVar

from urdfkit.core import libraries
from urdfkit.core.record import Record
from urdfkit.lint import glance, rules
from urdfkit.lint.context import WITHOUT_COAL, Outcome, Subject, Unavailable
from urdfkit.lint.rules import Finding, Rule, Written
from urdfkit.text.diagnostic import Call, Crashed, Diagnostic, Related, Severity, Skipped
from urdfkit.text.document import Attribute, Element, Step
from urdfkit.text.source import Span, shown_text
from urdfkit.text.xml_reader import is_launch
from urdfkit.workspace.siblings import other_srdf_files, srdf_files

if TYPE_CHECKING:
    from urdfkit.lint.config import Config
    from urdfkit.lint.suppress import Ignore
    from urdfkit.robot.model import Body
    from urdfkit.ros.targets import Targets
    from urdfkit.text.source import Source
    from urdfkit.xacro import Xacro

    Guard = Callable[[Callable[[], set[str]], set[str]], set[str]]

T = TypeVar("T")

#: A macro that is not called makes no link: what then says that something is missing is the same
#: defect again.
_HIDES_PARTS = "XAC002"
_OF_HIDDEN_PARTS = frozenset(
    "COL005 GAZ001 GAZ020 GAZ021 GAZ022 GAZ023 GAZ058 GEO008 INE004 INE019 RCT001 RCT013 RCT029 "
    "REF001 REF003 REF004 SRD001 SRD003 SRD012 SRD014 SRD025 TRE001 TRE002 XAC005".split()
)

#: Families of rules that look at the document or the robot in it.
_OF_THE_DOCUMENT = frozenset("COL URD REF NAM TRE JNT INE GEO MSH DYN GAZ RCT SRD PKG".split())

#: Rules about a package as such, whether a robot or a launch file lies in it.
_OF_PACKAGES = frozenset(("PKG005", "PKG006"))

#: Findings of one rule in one file; more help nobody.
MAX_FINDINGS = 1000
#: Characters of a message: names in it may be as long as a file.
MAX_MESSAGE = 2000
#: Places in data files that a finding lists.
MAX_DATA = 10


class Verdict(Record):
    """What the rules say about one description.

    Attributes:
        diagnostics: in the order of the rules.
        skipped, crashed: rules that did not run, or failed.
        ran: codes of the rules that ran.
        targets: the consumers that severities were weighed for; None if it did not matter.
        suppressed: how many findings the model's comments or the configuration suppress.
        unknown_arguments: those given that the description never mentions, with the one meant.
    """

    diagnostics: tuple[Diagnostic, ...]
    skipped: tuple[Skipped, ...]
    crashed: tuple[Crashed, ...]
    ran: frozenset[str]
    targets: Targets | None
    suppressed: int
    unknown_arguments: Mapping[str, str] = {}


def judge(subject: Subject, chosen: Sequence[str], config: Config | None = None) -> Verdict:
    """Run rules over a description.

    Args:
        subject: the description.
        chosen: codes of the rules.
        config: changes severities and leaves rules out for single files.
    """
    run = _Run(subject, config)
    run.skipped += unread(subject, chosen)
    run.skipped += run.guarded(lambda: unmeasured(subject, chosen), [])
    run.skipped += run.guarded(lambda: without_library(subject, chosen), [])
    # The rules about the checking itself look at what the others found.
    own = [code for code in chosen if code.startswith("CFG")]
    run.rules(applicable(subject, [code for code in chosen if code not in own], run.guarded))
    subject.outcome = Outcome(tuple(run.diagnostics), frozenset(chosen))
    run.ignores = run.guarded(lambda: subject.ignores, ())
    if rules.NOT_CHECKED in own:
        own.remove(rules.NOT_CHECKED)
        if unread(subject, chosen) and not run.has_errors():
            run.rules([rules.get(rules.NOT_CHECKED)])
            subject.outcome = subject.outcome._replace(diagnostics=tuple(run.diagnostics))
    if run.ignores:
        run.rules([rules.get(code) for code in own])
    return run.verdict()


def is_readable(subject: Subject) -> bool:
    """False for a description that cannot be read, on which hardly any rule can run."""
    return is_launch(subject.source.path) or subject.reading.document is not None


class _Run:
    """Gathers what the rules say about one subject."""

    def __init__(self, subject: Subject, config: Config | None) -> None:
        self.subject = subject
        self.config = config
        self.diagnostics: list[Diagnostic] = []
        self.skipped: list[Skipped] = []
        self.crashed: list[Crashed] = []
        self.ran: set[str] = set()
        self.ignores: tuple[Ignore, ...] = ()

    def guarded(self, look: Callable[[], T], otherwise: T) -> T:
        """What a look at the robot tells, or what stands in for it if the look fails."""
        try:
            return look()
        except Exception as error:  # a bug of urdfkit must not hide what the rules find
            self.crashed.append(crash("", self.subject.source.path, error))
            return otherwise

    def rules(self, chosen: Iterable[Rule]) -> None:
        for rule in chosen:
            findings = self._findings(rule)
            try:
                findings = self._undisputed(findings)
                targets = _targets(rule, findings, self.subject)
                self.diagnostics += map(self._configured, diagnose(rule, findings, targets))
            except Exception as error:
                self.ran.discard(rule.code)
                self.crashed.append(crash(rule.code, self.subject.source.path, error))

    def _findings(self, rule: Rule) -> list[Finding]:
        path = self.subject.source.path
        findings: list[Finding] = []
        try:
            for finding in rule.check(self.subject):
                findings.append(self._with_data(_bounded(finding)))
                if len(findings) >= MAX_FINDINGS:
                    break
            self.ran.add(rule.code)
        except Unavailable as reason:
            self.skipped.append(Skipped(rule.code, path, str(reason)))
        except Exception as error:  # a bug in a rule must not hide the other rules
            self.crashed.append(crash(rule.code, path, error))
        return findings

    def _with_data(self, finding: Finding) -> Finding:
        """A finding with the places of its numbers in data files."""
        at = finding.at
        if isinstance(at, Written) or is_launch(self.subject.source.path):
            return finding
        at = at if isinstance(at, (Element, Attribute)) else at.at
        places = self.subject.data_places(at)
        return finding._replace(data=places) if places else finding

    def _undisputed(self, findings: list[Finding]) -> list[Finding]:
        """Findings with the fixes on which all uses of a macro agree."""
        if not any(finding.fix for finding in findings) or is_launch(self.subject.source.path):
            return findings
        reading = self.subject.reading
        if reading.xacro is None or reading.document is None:
            return findings
        from urdfkit.lint.fix_consistency import without_disputed_fixes

        return without_disputed_fixes(findings, self.subject.uses)

    def _configured(self, diagnostic: Diagnostic) -> Diagnostic:
        severity = self.config.severities.get(diagnostic.code) if self.config else None
        return diagnostic if severity is None else diagnostic._replace(severity=severity)

    def has_errors(self) -> bool:
        """True if there is an error that nothing suppresses."""
        return any(found.severity is Severity.ERROR for found in self._kept())

    def _kept(self) -> tuple[Diagnostic, ...]:
        """The findings that neither the configuration nor a comment suppresses."""
        diagnostics = tuple(d for d in self.diagnostics if not self._left_out(d))
        if not self.ignores:
            return diagnostics
        from urdfkit.lint.suppress import sift

        return sift(diagnostics, self.ignores).kept

    def verdict(self) -> Verdict:
        diagnostics = self._kept()
        left_out = len(self.diagnostics) - len(diagnostics)
        if any(diagnostic.code == _HIDES_PARTS for diagnostic in diagnostics):
            diagnostics = tuple(d for d in diagnostics if d.code not in _OF_HIDDEN_PARTS)
        targets = self.subject.targets if "targets" in vars(self.subject) else None
        return Verdict(
            diagnostics,
            tuple(self.skipped),
            tuple(self._distinct_crashes()),
            frozenset(self.ran),
            targets,
            left_out,
        )

    def _distinct_crashes(self) -> Iterator[Crashed]:
        """Without the failed looks at the robot that rules have failed with, too."""
        of_rules = {crashed.error for crashed in self.crashed if crashed.code}
        told: set[str] = set()
        for crashed in self.crashed:
            if crashed.code or crashed.error not in of_rules | told:
                told.add(crashed.error)
                yield crashed

    def _left_out(self, diagnostic: Diagnostic) -> bool:
        config = self.config
        return config is not None and config.ignores(diagnostic.code, diagnostic.span.source.path)


def _unguarded(look: Callable[[], set[str]], otherwise: set[str]) -> set[str]:
    return look()


def applicable(subject: Subject, chosen: Collection[str], guard: Guard = _unguarded) -> list[Rule]:
    """The rules that may have something to say; the others need not even be imported.

    Args:
        subject: the description.
        chosen: codes of the rules.
        guard: calls what looks at the robot; the rules that it would decide on run if it fails.
    """
    if is_launch(subject.source.path):
        return [rules.get(code) for code in chosen if code[:3] == "LAU" or code in _OF_PACKAGES]
    reading = subject.reading
    told = {problem.code for problem in reading.problems}
    silent = {"LAU"}
    waiting = {
        *rules.TOLD_BY_READING,
        *rules.TOLD_BY_GRAMMAR,
        *rules.TOLD_BY_FILES,
        *rules.TOLD_BY_MESHES,
        *rules.TOLD_BY_MASSES,
        *rules.TOLD_BY_LIKENESSES,
    }
    if reading.xacro is None:
        silent.add("XAC")
        told.add("XAC003")  # the one among them that is about plain files
    else:
        waiting |= _silent_about_xacro(reading.xacro)
    if reading.document is None:
        silent |= {"XAC", *_OF_THE_DOCUMENT}
    else:
        told |= guard(lambda: _told_of_robot(subject, chosen), set(waiting))
        waiting |= guard(lambda: _silent_about_robot(subject, chosen), set())
        silent |= guard(lambda: _silent_families(subject), set())
        if "SRD" not in silent and guard(
            lambda: {"SRD025"} if subject.other_variant else set(), set()
        ):
            silent.add("SRD")  # what else it names is not of this robot either
            told.add("SRD025")
    return [
        rules.get(code)
        for code in chosen
        if code in told or not (code[:3] in silent or code in waiting)
    ]


def _told_of_robot(subject: Subject, chosen: Collection[str]) -> set[str]:
    """The rules that tell what the parts of the Subject have found, where they have something."""
    told = set(subject.deviations)
    model = subject.model
    if not model.joints and any(link.at.children for link in model.links):
        told.add("JNT011")  # which is about the shapes and inertias of links, too
    if any(shape.filename for shape in model.shapes):
        told |= _told_by_meshes(subject, chosen)
    if not rules.TOLD_BY_MASSES.isdisjoint(chosen):
        told |= subject.masses.told
    if not rules.TOLD_BY_LIKENESSES.isdisjoint(chosen) and _may_be_unlike(subject):
        told.update(subject.likenesses.claims)
    return told


def _may_be_unlike(subject: Subject) -> bool:
    """True if a link may be both seen and touched, as far as its mesh files are there."""

    def may_be_solid(bodies: Iterable[Body]) -> bool:
        return any(body.shape and not (is_lost and body.shape.filename) for body in bodies)

    links = [link for link in subject.model.links if link.visuals and link.collisions]
    is_lost = bool(links) and not any(mesh.facts for mesh in subject.files.meshes)
    return any(may_be_solid(link.visuals) and may_be_solid(link.collisions) for link in links)


def _silent_about_robot(subject: Subject, chosen: Collection[str]) -> set[str]:
    """The rules that a look at the robot and its package makes superfluous."""
    model = subject.model
    codes = glance.silent(model, subject.tree)
    if model.gazebo and any(code.startswith("GAZ") for code in chosen):
        codes |= _silent_about_gazebo(subject, codes)
    if not subject.parameters and not glance.names_parameters(model):
        codes |= glance.ABOUT_PARAMETERS
    if "PKG004" in chosen and not _may_lose_meshes(subject):
        codes.add("PKG004")
    codes |= _silent_about_packages(subject, subject.document.sources)
    if "DYN004" not in codes and _may_stand_on_what_is_missing(subject):
        codes.add("DYN004")
    if "GEO018" not in codes and not _may_be_enclosed(subject):
        codes.add("GEO018")
    if "pinocchio" not in subject.given_targets:
        codes |= {"DYN001", "DYN002"}
    if not rules.TOLD_BY_COAL.isdisjoint(chosen) and not _can_collide(subject):
        codes |= rules.TOLD_BY_COAL
    return codes


def _told_by_meshes(subject: Subject, chosen: Iterable[str]) -> set[str]:
    """The rules that have something to say about the mesh files or what is in them."""
    told: set[str] = set()
    if not rules.TOLD_BY_FILES.isdisjoint(chosen):
        told |= subject.files.told
    if not rules.TOLD_BY_MESHES.isdisjoint(chosen):
        try:
            told |= subject.measured.told
        except Unavailable:
            pass  # which `unmeasured` tells
    return told


def _silent_families(subject: Subject) -> set[str]:
    """The families that speak of something that the model does not have."""
    model = subject.model
    there = {
        "JNT": model.joints,
        "MSH": any(shape.filename for shape in model.shapes),
        "RCT": subject.parameters or glance.is_controlled(model),
        "GAZ": model.gazebo,
        "SRD": srdf_files(subject.source.path, subject.resolver)
        or other_srdf_files(subject.source.path, model.name, subject.resolver),
    }
    return {family for family, things in there.items() if not things}


def _silent_about_gazebo(subject: Subject, silent: set[str]) -> set[str]:
    """The rules about ``<gazebo>``; of those that are silent anyway nothing need be known."""
    from urdfkit.ros.gazebo.silence import about_blocks, about_plugins, about_sensors, about_tags

    codes = about_blocks(subject.model)
    if not silent >= glance.ABOUT_SENSORS:
        codes |= about_sensors(subject.model, subject.targets)
    if not silent >= glance.ABOUT_PLUGINS:
        codes |= about_plugins(subject.plugins, subject.targets, subject.gazebo)
        codes |= about_tags([found for _, found in subject.unread])
    return codes


def _silent_about_xacro(xacro: Xacro) -> set[str]:
    about = {"XAC004": xacro.properties, "XAC005": xacro.macros, "XAC006": xacro.arguments}
    codes = {"XAC003", *(code for code, things in about.items() if not things)}
    if all(source.data.count(b"{") == source.data.count(b"${") for source in xacro.sources):
        codes.add("XAC021")
    # Behind a sign of equality it forwards a value of the caller.
    if all(source.data.count(b"^") == source.data.count(b"=^") for source in xacro.sources):
        codes.add("XAC022")
    return codes


def _silent_about_packages(subject: Subject, sources: tuple[Source, ...]) -> set[str]:
    if not any(b"package://" in source.data or b"$(find" in source.data for source in sources):
        return {"PKG001", "PKG002", "PKG003", "PKG004", *_OF_PACKAGES}
    from urdfkit.workspace.package_references import silent  # it compiles a regular expression

    return silent(sources, subject.resolver.packages)


def unread(subject: Subject, chosen: Iterable[str]) -> list[Skipped]:
    """The rules that cannot look at a description, because it cannot be read."""
    path = subject.source.path
    if is_launch(path) or subject.reading.document is not None:
        return []
    reading = subject.reading
    families, reason = _OF_THE_DOCUMENT, "the description cannot be read"
    if reading.xacro is not None:
        families, reason = families | {"XAC"}, "the xacro does not expand"
    return [
        Skipped(code, path, reason)
        for code in chosen
        if code[:3] in families and code not in rules.TOLD_BY_READING
    ]


def _may_stand_on_what_is_missing(subject: Subject) -> bool:
    """True if the file of a mesh that may touch the ground is not there."""
    shapes = (
        body.shape for link in subject.model.links for body in link.collisions or link.visuals
    )
    return any(s and s.filename and subject.files.path(s) is None for s in shapes)


def _may_be_enclosed(subject: Subject) -> bool:
    """True if a link sees, and the shapes that may hide it are not all meshes that are missing."""
    from urdfkit.ros.gazebo.optical_sensors import eyes

    found = list(eyes(subject.model))
    bodies = [body for link in subject.model.links for body in link.visuals if found]
    if any(eye.type == "ray" for eye in found):
        bodies += [body for link in subject.model.links for body in link.collisions]
    shapes = (body.shape for body in bodies if body.shape)
    return any(not shape.filename or subject.files.path(shape) for shape in shapes)


def _may_lose_meshes(subject: Subject) -> bool:
    """True if the robot may be for Gazebo and has meshes that it names by a package."""
    if not (subject.model.gazebo or subject.given_targets):
        return False
    places = (mesh.located for mesh in subject.files.meshes)
    return any(located.path and located.scheme == "package" for located in places)


def unmeasured(subject: Subject, chosen: Iterable[str]) -> list[Skipped]:
    """The rules that cannot look into the meshes, for want of a library."""
    path = subject.source.path
    wanted = [code for code in chosen if code in rules.TOLD_BY_MESHES]
    if is_launch(path) or subject.reading.document is None or not wanted:
        return []
    if not any(shape.filename for shape in subject.model.shapes):
        return []
    try:
        _ = subject.measured
    except Unavailable as reason:
        return [Skipped(code, path, str(reason)) for code in wanted]
    return []


def _can_collide(subject: Subject) -> bool:
    """True if bodies may overlap, and what measures them is installed."""
    return glance.may_collide(subject.model) and _has_coal() and subject.is_crowded


def _has_coal() -> bool:
    return libraries.find("coal") is not None


def without_library(subject: Subject, chosen: Iterable[str]) -> list[Skipped]:
    """The rules that would look at the robot with a library that is not installed.

    Known without importing them, and asked only where they may have something to say.
    """
    path = subject.source.path
    wanted = [code for code in chosen if code in rules.TOLD_BY_COAL]
    if not wanted or is_launch(path) or subject.reading.document is None:
        return []
    if not glance.may_collide(subject.model) or _has_coal():
        return []
    return [Skipped(code, path, WITHOUT_COAL) for code in wanted]


def _bounded(finding: Finding) -> Finding:
    """A finding with a message of some length, that names files as they are shown."""
    message, remedy = shown_text(finding.message), shown_text(finding.help)
    if len(message) > MAX_MESSAGE:
        message = f"{message[:MAX_MESSAGE]}..."
    if (message, remedy) == (finding.message, finding.help):
        return finding
    return finding._replace(message=message, help=remedy)


def crash(code: str, path: str, error: Exception) -> Crashed:
    """What a failure that is being handled says; the code is empty where it is no rule's."""
    from traceback import format_exc  # 9 ms

    return Crashed(code, path, f"{type(error).__name__}: {error}", format_exc())


def _targets(rule: Rule, findings: list[Finding], subject: Subject) -> tuple[str, ...]:
    """The targets that a rule's findings are weighed for; inferred only where it matters."""
    return subject.targets.names if findings and rule.by_target else ()


def diagnose(
    rule: Rule, findings: Iterable[Finding], targets: tuple[str, ...] = ()
) -> list[Diagnostic]:
    """Stamp findings with their rule; what one macro body caused N times becomes one."""
    groups: dict[tuple[object, ...], list[Finding]] = {}
    for number, finding in enumerate(findings):
        span, via = place(finding)
        key: tuple[object, ...] = (span.source.path, span.start, span.end)
        # Only different calls of one macro are one cause; a plain place can have two defects.
        is_copied = any(step.kind != "launch" for step in via)
        groups.setdefault(key if is_copied else (*key, number), []).append(finding)
    return [_fold(rule, group, targets) for group in groups.values()]


def _fold(rule: Rule, group: list[Finding], targets: tuple[str, ...]) -> Diagnostic:
    severity, suffering = rule.weigh(targets)
    group.sort(key=lambda finding: ((finding.severity or severity).rank, -finding.weight))
    worst = group[0]
    if worst.severity is not None:
        severity, suffering = worst.severity, ()
    calls = tuple(Call(f.message, place(f)[1], _path(f)) for f in group)
    return Diagnostic(
        rule.code,
        rule.name,
        severity,
        worst.confidence,
        worst.message,
        place(worst)[0],
        calls,
        (*worst.related, *_in_data_files(group)),
        worst.help or rule.help,
        worst.fix,
        suffering,
        worst.alike,
    )


def _in_data_files(group: list[Finding]) -> list[Related]:
    """Where the numbers stand of what one macro body caused several times."""
    return list(dict.fromkeys(one for finding in group for one in finding.data))[:MAX_DATA]


def place(finding: Finding) -> tuple[Span, tuple[Step, ...]]:
    """Where a finding is, and the calls that led there."""
    at = finding.at
    if isinstance(at, Written):
        return at.span, at.frame.steps() if at.frame else ()
    return at.span, at.via


def _path(finding: Finding) -> str:
    at = finding.at
    if isinstance(at, Written):
        return ""
    return (at if isinstance(at, (Element, Attribute)) else at.at).path
