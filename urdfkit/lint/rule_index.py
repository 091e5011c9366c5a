"""Index of all rules by code, name and family.

The index is built from the file names in ``urdfkit/checks``: nothing else has to be edited for a
new rule, and a rule is imported only when it may apply.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from importlib import import_module
from importlib.machinery import ModuleSpec, SourceFileLoader
from types import ModuleType

from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import RuleError, UnknownRule
from urdfkit.lint.context import Context
from urdfkit.lint.rules import Rule, code_of, name_of

#: The rule about robots that cannot be checked: it runs whatever is selected, unless it is ignored.
NOT_CHECKED = "CFG003"

#: The rules that report why a robot does not expand, at any severity.
NOT_EXPANDED = frozenset(("XAC001", "XAC011"))

#: Families of urdfkit's own rules, with their subject; other packages use other prefixes.
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
    "SIM": "simulation in MuJoCo",
    "SRD": "SRDF",
    "TRE": "kinematic tree",
    "URD": "URDF elements and attributes",
    "WLD": "worlds of Gazebo",
    "XAC": "xacro",
    "XML": "XML",
}

#: The directory with a directory for each family of rules.
_CHECKS = os.path.join(os.path.dirname(os.path.dirname(__file__)), "checks")

#: The modules of all known rules, by code: urdfkit's own first.
_modules: dict[str, str] = {}
_external: set[str] = set()
_redirects: dict[str, str] = {}


def _known() -> dict[str, str]:
    """The modules of all rules, by code; read from the file names, without imports."""
    if not _modules:
        families = (name for name in os.listdir(_CHECKS) if name.isidentifier() and name[0] != "_")
        _modules.update(sorted(item for family in families for item in _in_family(family)))
    return _modules


def _in_family(family: str) -> Iterator[tuple[str, str]]:
    """The codes of the rules in a directory, with their modules."""
    for file in os.listdir(os.path.join(_CHECKS, family)):
        if file.endswith(".py") and (code := code_of(file[:-3])):
            yield code, f"urdfkit.checks.{family}.{file[:-3]}"


def codes() -> list[str]:
    return [code for code in _known() if code not in _external]


@cache
def family_of(code: str) -> str:
    """The family of a rule, a directory of ``urdfkit/checks``; empty for one of another package."""
    return "" if code in _external else _known()[code].split(".")[2]


@cache
def of_family(family: str) -> frozenset[str]:
    """The codes of the rules of a family."""
    return frozenset(code for code in codes() if family_of(code) == family)


def applicable(family: str, codes: list[str], context: Context) -> list[str]:
    """The rules of a family that may have something to report on a description."""
    if not family:
        return codes
    checks = import_module("urdfkit.checks")
    if not checks.APPLIES[family](context):
        return []
    of_context = checks.CODES[family](context) if family in checks.CODES else codes
    return [code for code in codes if code in of_context]


def register(modules: Mapping[str, str]) -> None:
    """Add the rules of another package: the full names of their modules by code.

    Raises:
        RuleError: a code belongs to urdfkit or to another package.
    """
    known = _known()
    for code, module in modules.items():
        if code[:3] in FAMILIES:
            raise RuleError(
                f"{module}: the prefix {code[:3]} is reserved by urdfkit; choose another"
            )
        if known.get(code, module) != module:
            raise RuleError(f"{module}: the code {code} is taken by {known[code]}")
    known.update(modules)
    _external.update(modules)


def external() -> dict[str, str]:
    """The modules of the rules of other packages, by code."""
    return {code: _modules[code] for code in _external}


def get(code: str) -> Rule:
    """The rule of a code.

    Raises:
        KeyError: the code is unknown.
        RuleError: the module of another package does not define the rule.
    """
    module = _known()[code]
    if code in _external:
        return _external_rule(code, module)
    rule = _module(module).check
    assert isinstance(rule, Rule)
    return rule


def _module(name: str) -> ModuleType:
    """The module of a rule of urdfkit, loaded from its known path, which is faster."""
    if name not in sys.modules:
        package, _, stem = name.rpartition(".")
        path = os.path.join(_CHECKS, *name.split(".")[2:]) + ".py"
        module, loader = ModuleType(name), SourceFileLoader(name, path)
        module.__spec__, module.__file__ = ModuleSpec(name, loader, origin=path), path
        loader.exec_module(module)
        setattr(import_module(package), stem, sys.modules.setdefault(name, module))
    return import_module(name)  # waits if another thread is importing it


def _external_rule(code: str, module: str) -> Rule:
    try:
        rule = getattr(import_module(module), "check", None)
    except Exception as error:
        raise RuleError(f"{module}: {type(error).__name__}: {error}") from error
    if not isinstance(rule, Rule) or rule.module != module:
        raise RuleError(f"{module}: it must define a function 'check' with @rule(...) for {code}")
    return rule


def find_rule(word: str) -> Rule:
    r"""The rule of a current or former code or name, ignoring case.

    >>> rule = find_rule("no-link")
    >>> rule.code, rule.severity.value, rule.explanation.partition("\n")[0]
    ('TRE001', 'error', 'The robot has no link.')

    Raises:
        UnknownRule: no rule matches, or two have that name; the message lists both, or suggests
            the nearest name.
    """
    codes = _exactly(word)
    if not codes:
        raise UnknownRule(word, _hint(word, [*_modules, *names()]))
    if len(codes) > 1:
        raise UnknownRule(word, f" alone: {' and '.join(codes)} have that name")
    return get(codes[0])


def matching(word: str) -> list[str]:
    """The codes with a prefix, or of the rules with a current or former code or name.

    Raises:
        UnknownRule: no rule matches, or it was removed; the message suggests the nearest name.
    """
    codes = codes_of(word)
    if not codes:
        families = {code[:3] for code in _modules}
        raise UnknownRule(word, _hint(word, [*families, *_modules, *names()]))
    return codes


def codes_of(word: str) -> list[str]:
    """The codes that ``matching`` returns; empty if no rule matches.

    Raises:
        UnknownRule: the rule was removed.
    """
    codes = [code for code in _known() if word and code.startswith(word.upper())]
    return codes or _exactly(word)


def named(words: Iterable[str]) -> frozenset[str]:
    """The codes that match a whole code or name among the words, not a prefix."""
    return frozenset(code for word in words for code in _exactly(word))


def _exactly(word: str) -> list[str]:
    """The codes of the rules with a current or former code or name; empty if there is none.

    Raises:
        UnknownRule: the rule was removed.
    """
    if word.upper() in _known():
        return [word.upper()]
    code = redirect(word)
    if code == "":
        raise UnknownRule(word, ": it was removed")
    return names().get(word.lower(), [code] if code else [])


def redirect(word: str) -> str | None:
    """The current code for a former code or name; None for any other word.

    Empty for a rule that was removed.
    """
    if word.upper() in _known():
        return None
    current = redirects()
    return current.get(word.upper(), current.get(word.lower()))


def redirects() -> dict[str, str]:
    """The current codes by former codes and names; empty strings for removed rules."""
    if not _redirects:
        from json import load  # former codes are rare

        with open(os.path.join(_CHECKS, "redirects.json"), encoding="utf-8") as file:
            former = load(file)
        _redirects.update((word, code) for code, words in former.items() for word in words)
    return _redirects


def note(word: str) -> str:
    """A message for a former code or name; empty for other words."""
    code = redirect(word)
    return f"{word} is now {code}" if code else ""


def ignore_note(word: str) -> str:
    """A message for a former code or name that is ignored; empty for other words."""
    message = note(word)
    return f"{message}, whose errors it does not ignore" if message else ""


class Ignored(Record):
    """The rules to ignore."""

    codes: frozenset[str]  # codes of the rules whose findings are all ignored
    #: Codes that replace former codes and names. These rules were merged with others, whose errors
    #: are still reported.
    but_errors: frozenset[str]
    unknown: tuple[UnknownRule, ...]  # errors for the words that match no rule


def ignored(words: Iterable[str]) -> Ignored:
    """The rules to ignore.

    Unknown rules, such as those of another version or of a package that is not installed, do not
    affect the check.
    """
    codes: set[str] = set()
    but_errors: set[str] = set()
    unknown: list[UnknownRule] = []
    for word in words:
        try:
            (codes if redirect(word) is None else but_errors).update(matching(word))
        except UnknownRule as error:
            unknown.append(error)
    return Ignored(frozenset(codes), frozenset(but_errors), tuple(unknown))


def _hint(word: str, known: list[str]) -> str:
    return did_you_mean(word, known) or "; 'urdfkit rules' lists them"


def names() -> dict[str, list[str]]:
    """The codes of all rules by name; read from the file names, without imports.

    Rules of two families may have the same name: a package can be missing for xacro and for a mesh.
    """
    return by_key((name_of(module), code) for code, module in _known().items())


def all_rules() -> list[Rule]:
    """All known rules, sorted by code; those of other packages are last."""
    return [get(code) for code in _known()]
