"""Rules: how one is declared, and which there are.

A rule is one file in ``urdfkit/checks``, named ``<code>_<name>.py``. Its docstring is the
explanation that users read, with the sources of its facts, and its ``check`` yields Findings. The
file name is the catalogue: nothing else has to be edited, and a rule is imported only when it may
have something to say.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from enum import Enum
from typing import TYPE_CHECKING

from urdfkit.core.libraries import load
from urdfkit.core.record import Record
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import RuleError, UnknownRule
from urdfkit.text.diagnostic import Confidence, Fix, Related, Severity
from urdfkit.text.document import Attribute, CallFrame, Element
from urdfkit.text.source import Span

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Placed

#: The rule about robots that are found and cannot be checked: it runs whatever is selected, unless
#: it is ignored by name.
NOT_CHECKED = "CFG003"

#: The rules that say why a robot does not expand, whatever their severity.
NOT_EXPANDED = frozenset(("XAC001", "XAC011"))

#: The version of urdfkit that brought every rule that names no other.
FIRST_VERSION = "0.1"

#: Families of urdfkit's own rules, and what they are about; other packages take other letters.
FAMILIES = {
    "CFG": "urdfkit itself",
    "COL": "collisions",
    "DYN": "dynamics",
    "GAZ": "Gazebo",
    "GEO": "shapes and colours",
    "INE": "mass and inertia",
    "JNT": "joints",
    "LAU": "launch files",
    "MSH": "mesh files",
    "NAM": "names",
    "PKG": "the ROS package",
    "RCT": "transmissions and ros2_control",
    "REF": "references",
    "SRD": "SRDF",
    "TRE": "kinematic tree",
    "URD": "URDF elements and attributes",
    "XAC": "xacro",
    "XML": "XML",
}


class Need(Enum):
    """What a rule asks of a Subject besides the source text."""

    XACRO = "xacro"  # the expansion: macros, properties, arguments
    MODEL = "model"  # the expanded document and the robot in it
    FILES = "files"  # the files that the model names
    MESHES = "meshes"  # the triangles in them, measured
    GAZEBO = "gazebo"  # what Gazebo makes of the model
    LAUNCH = "launch"  # the launch file
    SRDF = "srdf"  # MoveIt's file beside the model
    DYNAMICS = "dynamics"  # the robot in Pinocchio, or what Pinocchio says of it
    COLLISIONS = "collisions"  # which links overlap, by coal


class Location(Record):
    """A place that is no element of the expanded document, with the calls that led there."""

    span: Span
    frame: CallFrame | None = None


class Finding(Record):
    """What a rule says. The engine adds code, severity and the way through the macros.

    Attributes:
        at: the element, attribute, value or place that a person must edit.
        message: who (``link 'arm'``), the measured value with its unit, the bound.
        help: what to do; the rule's own help if empty.
        fix: a remedy as text edits.
        related: other places that explain it.
        confidence: how sure it is.
        weight: the larger, the worse; orders the calls of one macro.
        alike: the same for findings that many robots have in numbers, and that one slip made:
            more than a few of them are told as one.
        severity: where it is not that of the rule, whatever the targets.
        targets: those for which it has this severity; empty if it does not depend on them.
        data: where the numbers stand that expressions took out of data files; the judge finds it.
    """

    at: Element | Attribute | Placed[object] | Location
    message: str
    help: str = ""
    fix: Fix | None = None
    related: tuple[Related, ...] = ()
    confidence: Confidence = Confidence.MEASURED
    weight: float = 0.0
    alike: str = ""
    severity: Severity | None = None
    targets: tuple[str, ...] = ()
    data: tuple[Related, ...] = ()


#: What a rule yields.
Findings = Iterator[Finding]


def reported(subject: Subject, code: str) -> Findings:
    """The findings of a rule that only tells what reading met."""
    for problem in subject.problems(code):
        at = Location(problem.span, problem.frame)
        yield Finding(
            at,
            problem.message,
            problem.help,
            problem.fix,
            problem.related,
            severity=problem.severity,
        )


Check = Callable[["Subject"], Findings]

#: The folder with a folder for each family of rules.
_CHECKS = os.path.join(os.path.dirname(os.path.dirname(__file__)), "checks")

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
        needs: what it asks of a Subject.
        check: yields the findings.
        help: what to do, where a finding does not say it.
        fixable: True if findings may carry a fix.
        module: that holds it; its docstring explains the rule and lists its sources.
        by_target: severities for single targets, where they differ.
        preview: True for a rule that may still change; it runs only where it is asked for.
        since: the version of urdfkit that brought it.
        options: numbers that a configuration may change, with their defaults.
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

    def option(self, subject: Subject, name: str) -> float:
        """The value of an option: as configured, else its default."""
        return subject.options.get(self.code, self.options).get(name, self.options[name])

    def severity_for(self, targets: Iterable[str]) -> tuple[Severity, tuple[str, ...]]:
        """The severity for some targets, and those of them that suffer most.

        A rule without a severity of its own for any of them keeps its general one.
        """
        suffering = {name: self.by_target[name] for name in targets if name in self.by_target}
        if not suffering:
            return self.severity, ()
        worst = min(suffering.values(), key=lambda severity: severity.rank)
        return worst, tuple(name for name, severity in suffering.items() if severity is worst)

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
    def beside(self) -> dict[str, str]:
        """What lies beside the examples and is short enough to be shown, by relative path."""
        files: Mapping[str, bytes] = getattr(sys.modules[self.module], "FILES", {})
        return {
            name: data.decode()
            for name, data in files.items()
            if data.isascii()
            and b"\0" not in data
            and 0 < len(data) < _SHORT
            and ".git/" not in name
        }


def rule(
    severity: Severity,
    *,
    needs: tuple[Need, ...] = (Need.MODEL,),
    help: str = "",
    by_target: Mapping[str, Severity] | None = None,
    preview: bool = False,
    since: str = FIRST_VERSION,
    options: Mapping[str, float] | None = None,
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
        examples = vars(sys.modules[module])
        return Rule(
            code,
            _name_of(module),
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
        )

    return declare


#: The module of every rule that is known, by code: urdfkit's own first.
_modules: dict[str, str] = {}
_foreign: set[str] = set()
_redirects: dict[str, str] = {}


def codes() -> list[str]:
    """The codes of urdfkit's rules, sorted; read from the file names, nothing is imported."""
    if not _modules:
        folder = _CHECKS
        found: dict[str, str] = {}
        for family in os.listdir(folder):
            if family.isidentifier() and not family.startswith("_"):
                for file in os.listdir(os.path.join(folder, family)):
                    if file.endswith(".py") and (code := code_of(file[:-3])):
                        found[code] = f"urdfkit.checks.{family}.{file[:-3]}"
        _modules.update(sorted(found.items()))
    return [code for code in _modules if code not in _foreign]


def family_of(code: str) -> str:
    """The family of a rule, a folder of ``urdfkit/checks``; empty for one of another package."""
    codes()
    return "" if code in _foreign else _modules[code].split(".")[2]


def of_family(family: str) -> frozenset[str]:
    """The codes of the rules of a family."""
    return frozenset(code for code in codes() if family_of(code) == family)


def applies(family: str, subject: Subject) -> bool:
    """True if the rules of a family may have something to report of a description."""
    return not family or bool(load(f"urdfkit.checks.{family}").applies(subject))


def code_of(module: str) -> str | None:
    """The code of the rule in a module, by the module's name; None if it names no rule."""
    name = module.rpartition(".")[2]
    letters, digits, rest = name[:3], name[3:6], name[6:]
    is_one = letters.isalpha() and digits.isdigit() and len(rest) > 1 and rest[0] == "_"
    return name[:6].upper() if is_one and name.isascii() and name.islower() else None


def _name_of(module: str) -> str:
    """The name of the rule in a module: what follows the code in the module's name."""
    return module.rpartition(".")[2].partition("_")[2].replace("_", "-")


def register(modules: Mapping[str, str]) -> None:
    """Make rules of another package known: the full names of their modules by code.

    Raises:
        RuleError: a code belongs to urdfkit, or to a rule of a third package.
    """
    codes()
    for code, module in modules.items():
        if code[:3] in FAMILIES:
            raise RuleError(
                f"{module}: the prefix {code[:3]} is reserved by urdfkit; choose another"
            )
        if _modules.get(code, module) != module:
            raise RuleError(f"{module}: the code {code} is taken by {_modules[code]}")
    _modules.update(modules)
    _foreign.update(modules)


def foreign() -> dict[str, str]:
    """The modules of the rules of other packages, by code."""
    return {code: _modules[code] for code in _foreign}


def get(code: str) -> Rule:
    """The rule of a code.

    Raises:
        KeyError: there is none.
        RuleError: the module of another package holds no such rule.
    """
    if not _modules:
        codes()
    module = _modules[code]
    if code in _foreign:
        return _foreign_rule(code, module)
    found = load(module).check
    assert isinstance(found, Rule)
    return found


def _foreign_rule(code: str, module: str) -> Rule:
    try:
        found = getattr(load(module), "check", None)
    except Exception as error:
        raise RuleError(f"{module}: {type(error).__name__}: {error}") from error
    if not isinstance(found, Rule) or found.module != module:
        raise RuleError(f"{module}: it must hold a function 'check' with @rule(...) for {code}")
    return found


def find_rule(word: str) -> Rule:
    r"""The rule of a code or a name, in small or capital letters.

    >>> rule = find_rule("no-link")
    >>> rule.code, rule.severity.value, rule.explanation.partition("\n")[0]
    ('TRE001', 'error', 'The robot has no link.')

    Raises:
        UnknownRule: there is none, or two have that name; the message says which, or the nearest.
    """
    by_name = names()
    found = by_name.get(word.lower(), [word.upper()])
    if found[0] not in _modules:
        found = [_redirected(word) or ""]
    if not found[0]:
        raise UnknownRule(word, _hint(word, [*_modules, *by_name]))
    if len(found) > 1:
        raise UnknownRule(word, f" alone: {' and '.join(found)} have that name")
    return get(found[0])


def matching(word: str) -> list[str]:
    """The codes that begin with a word, or those of the rules with that name, now or formerly.

    Raises:
        UnknownRule: there is none, or no longer; the message has the nearest.
    """
    codes()
    if word in _modules:
        return [word]
    by_name = names()
    if named := by_name.get(word.lower()):
        return named
    found = [code for code in _modules if word and code.startswith(word.upper())]
    if not found and (code := _redirected(word)):
        return [code]
    if not found:
        families = {code[:3] for code in _modules}
        raise UnknownRule(word, _hint(word, [*families, *_modules, *by_name]))
    return found


def redirect(word: str) -> str | None:
    """The code of the rule that a former code or name stands for; None for any other word.

    Empty for a rule that was removed.
    """
    codes()
    if word.upper() in _modules:
        return None
    found = redirects()
    return found.get(word.upper(), found.get(word.lower()))


def redirects() -> dict[str, str]:
    """The codes that former codes and names stand for; empty for rules that were removed."""
    if not _redirects:
        for family in sorted({family_of(code) for code in codes()}):
            _redirects.update(getattr(load(f"urdfkit.checks.{family}"), "REDIRECTS", {}))
    return _redirects


def note(word: str) -> str:
    """That a rule has another code or name now; empty if it has not."""
    code = redirect(word)
    return f"{word} is now {code}" if code else ""


def ignore_note(word: str) -> str:
    """The same of a word that leaves a rule out."""
    found = note(word)
    return f"{found}, whose errors it does not ignore" if found else ""


def _redirected(word: str) -> str | None:
    code = redirect(word)
    if code == "":
        raise UnknownRule(word, ": it was removed")
    return code


def named(words: Iterable[str]) -> frozenset[str]:
    """The codes that some words mean by a whole code or name, not by the beginning of a code."""
    found: set[str] = set()
    for word in words:
        some = matching(word)
        if word.upper() in some or word.lower() in names() or redirect(word):
            found.update(some)
    return frozenset(found)


class Ignored(Record):
    """The rules that some words leave out.

    Attributes:
        codes: of the rules whose findings are all left out.
        but_errors: of those that former codes and names stand for. They were merged with other
            rules, which nobody wanted to ignore: their errors stay.
        unknown: why the other words mean no rule.
    """

    codes: frozenset[str]
    but_errors: frozenset[str]
    unknown: tuple[UnknownRule, ...]


def ignored(words: Iterable[str]) -> Ignored:
    """The rules that some words leave out.

    A rule that is to be left out and does not exist, such as one of another version or of a
    package that is not installed, changes nothing about the check.
    """
    found: dict[bool, set[str]] = {True: set(), False: set()}
    unknown: list[UnknownRule] = []
    for word in words:
        try:
            found[redirect(word) is not None].update(matching(word))
        except UnknownRule as error:
            unknown.append(error)
    return Ignored(frozenset(found[False]), frozenset(found[True]), tuple(unknown))


def _hint(word: str, known: list[str]) -> str:
    return did_you_mean(word, known) or "; 'urdfkit rules' lists them"


def names() -> dict[str, list[str]]:
    """The codes of all rules by name; read from the file names, nothing is imported.

    A name may serve two families: a package can be missing for xacro and for a mesh.
    """
    codes()
    found: dict[str, list[str]] = {}
    for code, module in _modules.items():
        found.setdefault(_name_of(module), []).append(code)
    return found


def all_rules() -> list[Rule]:
    """Every rule that is known, by code; those of other packages come last."""
    codes()
    return [get(code) for code in _modules]
