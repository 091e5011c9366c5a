"""Declaration of rules, and their findings.

A rule is one file in ``urdfkit/checks``, named ``<code>_<name>.py``. Its docstring is the
explanation that users read, with the sources of its facts, and its ``check`` yields Findings. The
file name registers the rule: nothing else has to be edited. A rule is imported only when it may
apply to a description.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from enum import Enum

from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.errors import RuleError
from urdfkit.lint.context import Context
from urdfkit.text.diagnostic import Confidence, Fix, Related, Severity
from urdfkit.text.document import Attribute, Element, Location
from urdfkit.text.source import Span

if TYPE_CHECKING:
    from urdfkit.robot.placed import Placed
    from urdfkit.xacro.origin import DataPlaces

#: Imported by the file of a rule, next to the modules of its subject.
__all__ = [
    "FIRST_VERSION", "NAMES", "Check", "Confidence", "Context", "Finding", "Findings", "Fix",
    "Location", "Need", "Related", "Rule", "Severity", "code_of", "name_of", "reported", "rule",
]  # fmt: skip

#: The version of urdfkit that introduced all rules without a ``since``.
FIRST_VERSION = "0.1"


class Need(Enum):
    """Parts of a Context that a rule needs in addition to the source text."""

    XACRO = "xacro"  # the expansion: macros, properties, arguments
    MODEL = "model"  # the expanded document and the robot in it
    FILES = "files"  # the files that the model references
    MESHES = "meshes"  # measures of their triangles
    GAZEBO = "gazebo"  # the model after conversion to SDF
    LAUNCH = "launch"  # the launch file
    SRDF = "srdf"  # the SRDF of the model, for MoveIt
    DYNAMICS = "dynamics"  # the robot in Pinocchio, or results of Pinocchio
    COLLISIONS = "collisions"  # the links that overlap, computed by coal
    SIMULATION = "simulation"  # simulations of the robot in MuJoCo


class Finding(Record):
    """A finding of a rule. The engine adds code, severity and the macro calls."""

    #: The element, attribute, value or place to edit.
    at: Element | Attribute | Placed[object] | Location | Span
    message: str  # who (``link 'arm'``), the measured value with its unit, the bound
    help: str = ""  # what to do; the rule's own help if empty
    fix: Fix | None = None  # as text edits
    related: tuple[Related, ...] = ()  # other places that explain it
    confidence: Confidence | None = None  # that of the rule if None
    weight: float = 0.0  # larger is worse; orders the calls of one macro
    #: Equal for findings with the same cause; more than a few of them are shown as one. If empty,
    #: those whose messages differ in names and numbers alone are.
    group_key: str = ""
    severity: Severity | None = None  # overrides the severity of the rule, for all targets
    #: Targets for which the finding has this severity; empty if it does not depend on them.
    targets: tuple[str, ...] = ()
    #: True if the name of an attribute is wrong, whatever its value, which a YAML file may hold.
    is_about_name: bool = False
    #: Places in data files of the values that expressions yield; set by the runner.
    data: DataPlaces | None = None

    @property
    def span(self) -> Span:
        return self.at if isinstance(self.at, Span) else self.at.span

    @property
    def node(self) -> Element | Attribute | None:
        """The element or attribute of the finding; None for any other place."""
        if isinstance(self.at, (Location, Span)):
            return None
        return self.at if isinstance(self.at, (Element, Attribute)) else self.at.at


Findings = Iterator[Finding]


def reported(context: Context, code: str) -> Findings:
    """The findings of a rule that only reports problems with reading the description."""
    for problem in context.problems(code):
        yield Finding(
            Location(problem.span, problem.frame),
            problem.message,
            problem.help,
            problem.fix,
            problem.related,
            severity=problem.severity,
        )


Check = Callable[[Context], Findings]

#: Attributes whose value is the name of a link or joint.
NAMES = ("name", "link", "joint", "reference")

#: Size in bytes up to which a page shows a whole file.
_MAX_SHOWN_BYTES = 500

#: Separates the explanation in the docstring of a rule from its sources, one per line.
_SOURCES = "\n\nSources:\n"


class Rule(Record):
    """A rule.

    Attributes:
        code: three letters of the family and three digits.
        name: name of the defect, in kebab case.
        severity: default severity.
        needs: parts of a Context that the rule needs.
        check: yields the findings.
        help: instruction for findings without a help of their own.
        fixable: True if findings may have a fix.
        module: module of the rule; its docstring explains the rule and lists its sources.
        by_target: severities for single targets, where they differ.
        preview: True for a rule that may still change; it runs only if it is selected.
        since: the version of urdfkit that introduced the rule.
        options: numbers that a configuration may change, with their defaults.
        hides_parts: attributes; a finding at one of them means that links or joints are missing.
            An empty name stands for all findings.
        reports_missing: True for a rule that reports missing parts. If a rule that hides parts
            reports the cause, its findings are consequences. Its fixes are applied last.
        depends_on_arguments: True for a rule about the parts and files that xacro arguments choose.
            Its findings are less severe if the values are known at run time only.
        computes_fix: True for fixes that are computed from other values of the robot; they are
            applied after the fixes of those values.
        migrates: True for a rule that reports features that another Gazebo generation lacks.
        about_files: True for a rule about mesh files, whose findings a generated mesh resolves.
        confidence: of findings without a confidence of their own.
    """

    code: str
    name: str
    severity: Severity
    needs: frozenset[Need]
    check: Check
    help: str
    fixable: bool
    module: str
    by_target: Mapping[str, Severity]
    preview: bool = False
    since: str = FIRST_VERSION
    options: Mapping[str, float] = {}
    hides_parts: tuple[str, ...] = ()
    reports_missing: bool = False
    depends_on_arguments: bool = False
    computes_fix: bool = False
    migrates: bool = False
    about_files: bool = False
    confidence: Confidence = Confidence.MEASURED

    def option(self, context: Context, name: str) -> float:
        """The configured value of an option, otherwise its default."""
        return context.run.rule_options.get(self.code, self.options).get(name, self.options[name])

    def may_report_errors(self, configured: Severity | None) -> bool:
        """True if a finding may be an error.

        Args:
            configured: severity of the rule in the configuration; None if it has none.
        """
        severities = (configured,) if configured else (self.severity, *self.by_target.values())
        return Severity.ERROR in severities

    def severity_for(self, targets: Iterable[str]) -> tuple[Severity, tuple[str, ...]]:
        """The worst severity for some targets, and the targets that have it.

        If none of the targets has a severity of its own: the default severity, and no targets.
        """
        affected = {name: self.by_target[name] for name in targets if name in self.by_target}
        if not affected:
            return self.severity, ()
        worst = min(affected.values(), key=lambda severity: severity.rank)
        return worst, tuple(name for name, severity in affected.items() if severity is worst)

    @property
    def severities(self) -> dict[str, Severity]:
        """Severities for single targets, where they differ; declared or from the target's facts."""
        from urdfkit.ros.targets import TARGETS, facts_of  # reads a file for each target

        stated = {name: facts_of(name).severities.get(self.code) for name in TARGETS}
        return {
            **self.by_target,
            **{name: Severity(severity) for name, severity in stated.items() if severity},
        }

    @property
    def explanation(self) -> str:
        """Explanation for users: what the rule finds, why it matters and what to do."""
        return self._documentation.partition(_SOURCES)[0]

    @property
    def sources(self) -> tuple[str, ...]:
        """Sources of its facts, as ``title: address``, or a description of a measurement."""
        return tuple(map(str.strip, self._documentation.partition(_SOURCES)[2].splitlines()))

    @property
    def _documentation(self) -> str:
        return (sys.modules[self.module].__doc__ or "").strip()

    def example(self, which: str) -> str | None:
        """The robot in ``BAD``, ``GOOD`` or ``FIXED`` of the rule's file.

        Bytes that are not valid text become surrogates, as in file names.
        """
        example: str | bytes | None = getattr(sys.modules[self.module], which, None)
        return example.decode("utf-8", "surrogateescape") if isinstance(example, bytes) else example

    @property
    def example_files(self) -> dict[str, str]:
        """The other files of the examples that are short enough to show, by relative path."""
        files: Mapping[str, bytes] = getattr(sys.modules[self.module], "FILES", {})
        return {
            name: data.decode()
            for name, data in files.items()
            if data.isascii()
            and b"\0" not in data
            and 0 < len(data) < _MAX_SHOWN_BYTES
            and ".git/" not in name
        }


def code_of(module: str) -> str | None:
    """The code of the rule in a module; None if the module's name is not that of a rule."""
    name = module.rpartition(".")[2]
    letters, digits, rest = name[:3], name[3:6], name[6:]
    is_rule = letters.isalpha() and digits.isdigit() and len(rest) > 1 and rest[0] == "_"
    return name[:6].upper() if is_rule and name.isascii() and name.islower() else None


def name_of(module: str) -> str:
    """The name of the rule in a module: the module's name after the code."""
    return module.rpartition(".")[2].partition("_")[2].replace("_", "-")


def rule(
    severity: Severity,
    *,
    confidence: Confidence = Confidence.MEASURED,
    needs: tuple[Need, ...] = (Need.MODEL,),
    help: str = "",
    by_target: Mapping[str, Severity] | None = None,
    preview: bool = False,
    since: str = FIRST_VERSION,
    options: Mapping[str, float] | None = None,
    hides_parts: tuple[str, ...] = (),
    reports_missing: bool = False,
    depends_on_arguments: bool = False,
    computes_fix: bool = False,
    migrates: bool = False,
    about_files: bool = False,
) -> Callable[[Check], Rule]:
    """Declare a rule; the decorated function becomes its Rule.

    Code and name are taken from the file name. The rule has fixes if the file defines FIXED or
    FIXED_FILES.

    Raises:
        RuleError: the file name does not have the form ``abc123_some_defect.py``.
    """

    def declare(check: Check) -> Rule:
        module = check.__module__
        code = code_of(module)
        if code is None:
            raise RuleError(f"{module}: name the module of a rule like abc123_some_defect")
        examples = check.__globals__
        return Rule(
            code,
            name_of(module),
            severity,
            frozenset(needs),
            check,
            help,
            "FIXED" in examples or "FIXED_FILES" in examples,
            module,
            by_target or {},
            preview,
            since,
            options or {},
            hides_parts,
            reports_missing,
            depends_on_arguments,
            computes_fix,
            migrates,
            about_files,
            confidence,
        )

    return declare
