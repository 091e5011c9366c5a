"""How this installation gets an extra of urdfkit.

A hint that names the package index fails in a checkout, before the first release, and in an
environment that pre-commit, uv or pipx made. So a hint names from where this urdfkit came, and by
which program.
"""

import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from urdfkit.errors import MissingLibrary

#: Where the package ``urdfkit`` is: a checkout, or ``site-packages``.
_HOME = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def install_command(extra: str) -> str:
    """What installs an extra here: a command, or for pre-commit a line of its configuration.

    Args:
        extra: its name; empty for what urdfkit itself needs.
    """
    extras = extra and f"[{extra}]"
    if sys.platform == "emscripten":
        return "not possible in a browser"
    if os.path.basename(sys.prefix).startswith("py_env-"):  # pre-commit's, in a clone of its own
        return f'additional_dependencies: [".{extras}"] in .pre-commit-config.yaml'
    requirement = _requirement(extras)
    if "archive-v" in sys.prefix or "environments-v" in sys.prefix:  # of uv's cache
        return f"uvx --from {requirement} urdfkit"
    return f"{_program()} {requirement}"


@contextmanager
def needing(what: str, extra: str) -> Iterator[None]:
    """For the imports of libraries in an extra, without which something cannot be done.

    Raises:
        MissingLibrary: one is not installed; with what installs it.
    """
    try:
        yield
    except MissingLibrary:
        raise
    except ImportError as error:
        raise MissingLibrary(f"{what} needs {error.name}: {install_command(extra)}") from error


def _program() -> str:
    """The program that made this environment, and its words for installing into it."""
    if _in_prefix("uv-receipt.toml"):
        return "uv tool install"
    if _in_prefix("pipx_metadata.json"):
        return "pipx install --force"
    return "uv pip install" if "\nuv = " in _in_prefix("pyvenv.cfg") else "pip install"


def _in_prefix(name: str) -> str:
    """The text of a file of this environment; empty if there is none."""
    try:
        with open(os.path.join(sys.prefix, name), encoding="utf-8") as file:
            return file.read()
    except OSError:
        return ""


def _requirement(extras: str) -> str:
    """This urdfkit with an extra, as pip and uv take it."""
    if os.path.isfile(os.path.join(_HOME, "pyproject.toml")):
        return f'-e "{_HOME}{extras}"'
    origin = _origin()
    return f'"urdfkit{extras}{origin and " @ "}{origin}"'


def _origin() -> str:
    """The URL that urdfkit was installed from, by PEP 610; empty for a package index."""
    import json

    records = (name for name in os.listdir(_HOME) if re.fullmatch(r"urdfkit-.*\.dist-info", name))
    try:
        with open(os.path.join(_HOME, next(records), "direct_url.json"), encoding="utf-8") as file:
            found = json.load(file)
        vcs = found.get("vcs_info")
        return f"{vcs['vcs']}+{found['url']}@{vcs['commit_id']}" if vcs else str(found["url"])
    except (OSError, ValueError, LookupError, StopIteration):
        return ""
