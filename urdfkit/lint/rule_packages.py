"""Rules of other packages, and where they are found.

A package of rules is named by the entry point of the group ``urdfkit.lint.rules`` under which it is
installed, or by a module. Nothing is looked up unless somebody names one: to ask Python for its
entry points costs as much as checking a robot, and a report should not depend on what else
happens to be installed.
"""

import os
import sys
from collections.abc import Iterable
from functools import cache
from importlib.util import find_spec

from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import RuleError
from urdfkit.lint import rule_index, rules

GROUP = "urdfkit.lint.rules"


@cache
def installed() -> dict[str, str]:
    """The modules of the installed packages of rules, by the names of their entry points."""
    from importlib.metadata import entry_points

    return {point.name: point.module for point in entry_points(group=GROUP)}


def add(names: Iterable[str], *, modules: bool, directory: str = "") -> list[str]:
    """Make the rules of some packages known to this process.

    Args:
        names: of entry points; or of modules, each a rule or a package that holds rules.
        modules: whether modules may be named. To import one runs its code.

    Returns:
        The codes of the rules.

    Raises:
        RuleError: there is no such package or it holds no rule; or a module is named and may
            not be.
    """
    codes: list[str] = []
    for name in names:
        module = installed().get(name)
        if module is None:
            if not modules:
                raise RuleError(f"no rule package is installed as '{name}'{_hint(name)}")
            if directory and os.path.abspath(directory) not in sys.path:
                sys.path.append(os.path.abspath(directory))
            module = name
        found = _rules_of(module)
        rule_index.register(found)
        codes += found
    return codes


def _hint(name: str) -> str:
    nearest = did_you_mean(name, installed())
    return f"{nearest}; importing a module runs its code: pass --trust or --config FILE"


@cache
def _rules_of(name: str) -> dict[str, str]:
    """The modules of the rules in a package, or the module itself, by code."""
    from pkgutil import iter_modules

    try:
        spec = find_spec(name)
    except Exception as error:  # a package above it may fail in any way
        raise RuleError(f"rule package '{name}': {type(error).__name__}: {error}") from error
    if spec is None:
        hint = did_you_mean(name, installed())
        raise RuleError(f"no rule package '{name}', neither installed nor as a module{hint}")
    inside = spec.submodule_search_locations
    names = [name] if inside is None else [f"{name}.{one.name}" for one in iter_modules(inside)]
    found = {code: module for module in sorted(names) if (code := rules.code_of(module))}
    if not found:
        raise RuleError(f"rule package '{name}': no module named abc123_some_defect in it")
    return found
