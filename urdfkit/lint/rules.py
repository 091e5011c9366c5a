"""Rules: how one is declared, and what it finds.

A rule is one file in ``urdfkit/checks``, named ``<code>_<name>.py``. Its docstring is the
explanation that users read, with the sources of its facts, and its ``check`` yields Findings. The
file name is the catalogue: nothing else has to be edited, and a rule is imported only when it may
have something to say.
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
from urdfkit.text.document import Attribute, CallFrame, Element
from urdfkit.text.source import Span

if TYPE_CHECKING:
    from urdfkit.robot.model import Placed

#: All that the file of a rule needs, but what its subject matter is.
__all__ = [
    "FIRST_VERSION", "NAMES", "Check", "Confidence", "Context", "Finding", "Findings", "Fix",
    "Location", "Need", "Related", "Rule", "Severity", "code_of", "name_of", "reported", "rule",
]  # fmt: skip

#: The version of urdfkit that brought every rule that names no other.
FIRST_VERSION = "0.1"


class Need(Enum):
    """What a rule needs of a Context besides the source text."""

    XACRO = "xacro"  # the expansion: macros, properties, arguments
    MODEL = "model"  # the expanded document and the robot in it
    FILES = "files"  # the files that the model names
    MESHES = "meshes"  # the triangles in them, measured
    GAZEBO = "gazebo"  # what Gazebo makes of the model
    LAUNCH = "launch"  # the launch file
    SRDF = "srdf"  # MoveIt's file of the model
    DYNAMICS = "dynamics"  # the robot in Pinocchio, or what Pinocchio says of it
    COLLISIONS = "collisions"  # which links overlap, by coal


class Location(Record):
    """A place that is no element of the expanded document, with the calls that led there."""

    span: Span
    frame: CallFrame | None = None


class Finding(Record):
    """What a rule says. The engine adds code, severity and the way through the macros."""

    #: The element, attribute, value or place that a person must edit.
    at: Element | Attribute | Placed[object] | Location
    message: str  # who (``link 'arm'``), the measured value with its unit, the bound
    help: str = ""  # what to do; the rule's own help if empty
    fix: Fix | None = None  # as text edits
    related: tuple[Related, ...] = ()  # other places that explain it
    confidence: Confidence = Confidence.MEASURED  # how sure it is
    weight: float = 0.0  # the larger, the worse; orders the calls of one macro
    #: The same for findings of one cause that robots have in numbers: more than a few of them are
    #: shown as one.
    group_key: str = ""
    severity: Severity | None = None  # where it is not that of the rule, whatever the targets
    #: Those for which it has this severity; empty if it does not depend on them.
    targets: tuple[str, ...] = ()
    #: Where the numbers stand that expressions took out of data files; the judge finds it.
    data: tuple[Related, ...] = ()

    @property
    def node(self) -> Element | Attribute | None:
        """The element or attribute that it is at; None for a place that is none."""
        if isinstance(self.at, Location):
            return None
        return self.at if isinstance(self.at, (Element, Attribute)) else self.at.at


#: What a rule yields.
Findings = Iterator[Finding]


def reported(context: Context, code: str) -> Findings:
    """The findings of a rule that only reports problems of reading."""
    for problem in context.problems(code):
        at = Location(problem.span, problem.frame)
        yield Finding(
            at,
            problem.message,
            problem.help,
            problem.fix,
            problem.related,
            severity=problem.severity,
        )


Check = Callable[[Context], Findings]

#: The attributes that name links and joints.
NAMES = ("name", "link", "joint", "reference")

#: Bytes of a file that a page shows whole.
_SHORT = 500

#: Ends the explanation in the docstring of a rule; a line for each source follows.
_SOURCES = "\n\nSources:\n"


class Rule(Record):
    """A rule.

    Attributes:
        code: three letters of the family and three digits.
        name: of the defect, in kebab case.
        severity: unless configured otherwise.
        needs: of a Context.
        check: yields the findings.
        help: what to do, where a finding does not say it.
        fixable: True if findings may carry a fix.
        module: that holds it; its docstring explains the rule and lists its sources.
        by_target: severities for single targets, where they differ.
        preview: True for a rule that may still change; it runs only where it is asked for.
        since: the version of urdfkit that brought it.
        options: numbers that a configuration may change, with their defaults.
        hides_parts: attributes of which a finding means that links or joints are missing; an
            empty name for all findings.
        reports_missing: True for a rule that reports what is missing. Where a rule that hides
            parts has found the cause, its findings are consequences. Its fixes wait, too.
        depends_on_arguments: True for a rule about the parts and files that xacro arguments choose.
            It is less severe where their values are known at run time only.
        computes_fix: True for fixes that compute from other values of the robot; they wait until
            those are fixed.
        migrates: True for a rule that reports what another generation of Gazebo does not have.
        about_files: True for a rule about mesh files, which a generated mesh answers.
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

    def option(self, context: Context, name: str) -> float:
        """The value of an option: as configured, else its default."""
        return context.run.rule_options.get(self.code, self.options).get(name, self.options[name])

    def may_report_errors(self, configured: Severity | None) -> bool:
        """True if a finding may be an error, with the severity that the configuration gives it."""
        severities = (configured,) if configured else (self.severity, *self.by_target.values())
        return Severity.ERROR in severities

    def severity_for(self, targets: Iterable[str]) -> tuple[Severity, tuple[str, ...]]:
        """The severity for some targets, and those of them that suffer most.

        A rule without a severity of its own for any of them keeps its general one.
        """
        affected = {name: self.by_target[name] for name in targets if name in self.by_target}
        if not affected:
            return self.severity, ()
        worst = min(affected.values(), key=lambda severity: severity.rank)
        return worst, tuple(name for name, severity in affected.items() if severity is worst)

    @property
    def severities(self) -> dict[str, Severity]:
        """For single targets, where they differ: as declared, and as the facts about them say."""
        from urdfkit.ros.targets import TARGETS, facts_of  # reads a file for each

        stated = {name: facts_of(name).severities.get(self.code) for name in TARGETS}
        return {
            **self.by_target,
            **{name: Severity(severity) for name, severity in stated.items() if severity},
        }

    @property
    def explanation(self) -> str:
        """What the rule finds, why it matters and what to do, for people."""
        return self._documentation.partition(_SOURCES)[0]

    @property
    def sources(self) -> tuple[str, ...]:
        """Where its facts come from, as ``what it is: address``, or what was measured."""
        return tuple(map(str.strip, self._documentation.partition(_SOURCES)[2].splitlines()))

    @property
    def _documentation(self) -> str:
        return (sys.modules[self.module].__doc__ or "").strip()

    def example(self, which: str) -> str | None:
        """The robot in ``BAD``, ``GOOD`` or ``FIXED`` of the rule's file.

        Bytes that are no text become surrogates, as in file names.
        """
        example: str | bytes | None = getattr(sys.modules[self.module], which, None)
        return example.decode("utf-8", "surrogateescape") if isinstance(example, bytes) else example

    @property
    def example_files(self) -> dict[str, str]:
        """The other files of the examples that are short enough to be shown, by relative path."""
        files: Mapping[str, bytes] = getattr(sys.modules[self.module], "FILES", {})
        return {
            name: data.decode()
            for name, data in files.items()
            if data.isascii()
            and b"\0" not in data
            and 0 < len(data) < _SHORT
            and ".git/" not in name
        }


def code_of(module: str) -> str | None:
    """The code of the rule in a module, by the module's name; None if it names no rule."""
    name = module.rpartition(".")[2]
    letters, digits, rest = name[:3], name[3:6], name[6:]
    is_one = letters.isalpha() and digits.isdigit() and len(rest) > 1 and rest[0] == "_"
    return name[:6].upper() if is_one and name.isascii() and name.islower() else None


def name_of(module: str) -> str:
    """The name of the rule in a module: what follows the code in the module's name."""
    return module.rpartition(".")[2].partition("_")[2].replace("_", "-")


def rule(
    severity: Severity,
    *,
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

    Code and name are those of the file, and a file with FIXED or FIXED_FILES holds a rule with
    fixes.

    Raises:
        RuleError: the file is not named as ``abc123_some_defect.py``.
    """

    def declare(check: Check) -> Rule:
        module = check.__module__
        code = code_of(module)
        if code is None:
            raise RuleError(f"{module}: the module of a rule is named as abc123_some_defect")
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
        )

    return declare
