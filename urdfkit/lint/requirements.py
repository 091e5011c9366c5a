"""Libraries without which a rule is skipped."""

from __future__ import annotations

from importlib import import_module

from urdfkit.core import libraries
from urdfkit.lint.description_file import Unavailable

WITHOUT_PINOCCHIO = "Pinocchio is not installed ({}): pip install 'urdfkit[dynamics]'"
_WITHOUT_COAL = "coal is not installed: pip install 'urdfkit[dynamics]'"


def need_coal() -> None:
    """Import coal.

    Raises:
        Unavailable: it is not installed.
    """
    try:
        import_module("coal")
    except ImportError as error:
        raise Unavailable(_WITHOUT_COAL) from error


def need_pinocchio() -> None:
    """Find Pinocchio.

    Raises:
        Unavailable: it is not installed.
    """
    if libraries.find("pinocchio") is None:
        raise Unavailable(WITHOUT_PINOCCHIO.format("no module 'pinocchio'"))
