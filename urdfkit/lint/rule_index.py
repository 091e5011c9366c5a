"""Which rules there are, by code, name and family.

The names of the files in ``urdfkit/checks`` are the index: nothing else has to be edited for a new
rule, and a rule is imported only when it may have something to report.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from importlib import import_module
from importlib.machinery import ModuleSpec, SourceFileLoader
from types import ModuleType

from urdfkit.core.record import Record
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import RuleError, UnknownRule
from urdfkit.lint.context import Context
from urdfkit.lint.rules import Rule, code_of, name_of

#: The rule about robots that are found and cannot be checked: it runs whatever is selected, unless
#: it is ignored by name.
NOT_CHECKED = "CFG003"

#: The rules that say why a robot does not expand, whatever their severity.
NOT_EXPANDED = frozenset(("XAC001", "XAC011"))

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
    "WLD": "worlds of Gazebo",
    "XAC": "xacro",
    "XML": "XML",
}

#: The directory with a directory for each family of rules.
_CHECKS = os.path.join(os.path.dirname(os.path.dirname(__file__)), "checks")

#: The module of every rule that is known, by code: urdfkit's own first.
_modules: dict[str, str] = {}
_external: set[str] = set()
_redirects: dict[str, str] = {}


def _known() -> dict[str, str]:
    """The module of every rule, by code; read from the file names, nothing is imported."""
    if not _modules:
        families = (name for name in os.listdir(_CHECKS) if name.isidentifier() and name[0] != "_")
        _modules.update(sorted(found for family in families for found in _in_family(family)))
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
    """Those rules of a family that may have something to report of a description.

    The ``__init__.py`` of the family has ``applies(context)``, and where something names the rules
    that report it, ``codes(context)``: those that have something to report.
    """
    if not family:
        return codes
    module = import_module(f"urdfkit.checks.{family}")
    if not module.applies(context):
        return []
    found = module.codes(context) if hasattr(module, "codes") else codes
    return [code for code in codes if code in found]


def register(modules: Mapping[str, str]) -> None:
    """Make rules of another package known: the full names of their modules by code.

    Raises:
        RuleError: a code belongs to urdfkit, or to a rule of a third package.
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
        KeyError: there is none.
        RuleError: the module of another package holds no such rule.
    """
    module = _known()[code]
    if code in _external:
        return _external_rule(code, module)
    found = _module(module).check
    assert isinstance(found, Rule)
    return found


def _module(name: str) -> ModuleType:
    """The module of a rule of urdfkit; its file is known, which spares Python the search."""
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
        found = getattr(import_module(module), "check", None)
    except Exception as error:
        raise RuleError(f"{module}: {type(error).__name__}: {error}") from error
    if not isinstance(found, Rule) or found.module != module:
        raise RuleError(f"{module}: it must hold a function 'check' with @rule(...) for {code}")
    return found


def find_rule(word: str) -> Rule:
    r"""The rule of a code or a name, now or formerly, in small or capital letters.

    >>> rule = find_rule("no-link")
    >>> rule.code, rule.severity.value, rule.explanation.partition("\n")[0]
    ('TRE001', 'error', 'The robot has no link.')

    Raises:
        UnknownRule: there is none, or two have that name; the message says which, or the nearest.
    """
    found = _exactly(word)
    if not found:
        raise UnknownRule(word, _hint(word, [*_modules, *names()]))
    if len(found) > 1:
        raise UnknownRule(word, f" alone: {' and '.join(found)} have that name")
    return get(found[0])


def matching(word: str) -> list[str]:
    """The codes that begin with a word, or those of the rules with that name, now or formerly.

    Raises:
        UnknownRule: there is none, or no longer; the message has the nearest.
    """
    found = codes_of(word)
    if not found:
        families = {code[:3] for code in _modules}
        raise UnknownRule(word, _hint(word, [*families, *_modules, *names()]))
    return found


def codes_of(word: str) -> list[str]:
    """The same without a suggestion; empty if there is none.

    Raises:
        UnknownRule: there is none any more.
    """
    found = [code for code in _known() if word and code.startswith(word.upper())]
    return found or _exactly(word)


def named(words: Iterable[str]) -> frozenset[str]:
    """The codes that some words mean by a whole code or name, not by the beginning of a code."""
    return frozenset(code for word in words for code in _exactly(word))


def _exactly(word: str) -> list[str]:
    """The codes of the rules with a code or name, now or formerly; empty if there is none.

    Raises:
        UnknownRule: there is none any more.
    """
    if word.upper() in _known():
        return [word.upper()]
    code = redirect(word)
    if code == "":
        raise UnknownRule(word, ": it was removed")
    return names().get(word.lower(), [code] if code else [])


def redirect(word: str) -> str | None:
    """The code of the rule that a former code or name stands for; None for any other word.

    Empty for a rule that was removed.
    """
    if word.upper() in _known():
        return None
    found = redirects()
    return found.get(word.upper(), found.get(word.lower()))


def redirects() -> dict[str, str]:
    """The codes that former codes and names stand for; empty for rules that were removed."""
    if not _redirects:
        from json import load  # configurations name few rules that are no more

        with open(os.path.join(_CHECKS, "redirects.json"), encoding="utf-8") as file:
            former = load(file)
        _redirects.update((word, code) for code, words in former.items() for word in words)
    return _redirects


def note(word: str) -> str:
    """That a rule has another code or name now; empty if it has not."""
    code = redirect(word)
    return f"{word} is now {code}" if code else ""


def ignore_note(word: str) -> str:
    """The same of a word that leaves a rule out."""
    found = note(word)
    return f"{found}, whose errors it does not ignore" if found else ""


class Ignored(Record):
    """The rules that some words leave out."""

    codes: frozenset[str]  # of the rules whose findings are all left out
    #: Of those that former codes and names stand for. They were merged with other rules, which
    #: nobody wanted to ignore: their errors stay.
    but_errors: frozenset[str]
    unknown: tuple[UnknownRule, ...]  # why the other words mean no rule


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
    found: dict[str, list[str]] = {}
    for code, module in _known().items():
        found.setdefault(name_of(module), []).append(code)
    return found


def all_rules() -> list[Rule]:
    """Every rule that is known, by code; those of other packages come last."""
    return [get(code) for code in _known()]
