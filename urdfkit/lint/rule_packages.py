"""Search for packages of rules.

A package of rules is named by its entry point in the group ``urdfkit.lint.rules``, or by a module.
Only named packages are loaded: reading the entry points takes as long as checking a robot, and a
report should not depend on unrelated installed packages.
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
    """Register the rules of packages in this process.

    Args:
        names: names of entry points; or of modules, each a rule or a package of rules.
        modules: True if modules are allowed. Importing a module runs its code.

    Returns:
        The codes of the rules.

    Raises:
        RuleError: a package does not exist or contains no rule; or a module is not allowed.
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
        modules_by_code = _rules_of(module)
        rule_index.register(modules_by_code)
        codes += modules_by_code
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
    except Exception as error:  # the import of a parent package may fail in any way
        raise RuleError(f"rule package '{name}': {type(error).__name__}: {error}") from error
    if spec is None:
        hint = did_you_mean(name, installed())
        raise RuleError(f"no rule package '{name}', neither installed nor as a module{hint}")
    paths = spec.submodule_search_locations
    names = [name] if paths is None else [f"{name}.{info.name}" for info in iter_modules(paths)]
    by_code = {code: module for module in sorted(names) if (code := rules.code_of(module))}
    if not by_code:
        raise RuleError(f"rule package '{name}': no module named abc123_some_defect in it")
    return by_code
