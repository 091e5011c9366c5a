"""Libraries without which a rule is skipped."""

from importlib import import_module

from urdfkit.core import libraries
from urdfkit.lint.description_file import Unavailable


def without_pinocchio(why: object) -> str:
    """The reason where Pinocchio cannot be imported."""
    from urdfkit.core.installation import install_command

    return f"Pinocchio is not installed ({why}): {install_command('dynamics')}"


def need_coal() -> None:
    """Import coal.

    Raises:
        Unavailable: it is not installed.
    """
    try:
        import_module("coal")
    except ImportError as error:
        from urdfkit.core.installation import install_command

        raise Unavailable(f"coal is not installed: {install_command('dynamics')}") from error


def need_pinocchio() -> None:
    """Find Pinocchio.

    Raises:
        Unavailable: it is not installed.
    """
    if libraries.find("pinocchio") is None:
        raise Unavailable(without_pinocchio("no module 'pinocchio'"))
