"""The command that installs an extra into this installation of urdfkit.

``pip install 'urdfkit[x]'`` would fail in a checkout, before the first release, and in environments
of pre-commit, uv or pipx. The command therefore names the source of this installation and the
program that made it.
"""

import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from types import ModuleType

from urdfkit.errors import MissingLibrary

#: Directory of the package ``urdfkit``: a checkout, or ``site-packages``.
_HOME = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def install_command(extra: str) -> str:
    """A command that installs an extra; for pre-commit, a line of its configuration.

    If it cannot be installed, ``not possible`` and the reason.

    Args:
        extra: its name; empty for the dependencies of urdfkit itself.
    """
    if obstacle := _obstacle(extra):
        return f"not possible {obstacle}"
    extras = extra and f"[{extra}]"
    if os.path.basename(sys.prefix).startswith("py_env-"):  # pre-commit's
        return f'additional_dependencies: [".{extras}"] in .pre-commit-config.yaml'
    requirement = _requirement(extras)
    if "archive-v" in sys.prefix or "environments-v" in sys.prefix:  # of uv's cache
        return f"uvx --from {requirement} urdfkit"
    return f"{_program()} {requirement}"


def _obstacle(extra: str) -> str:
    """Why the markers in pyproject.toml exclude an extra here; empty if they do not."""
    if sys.platform == "emscripten":
        return "in a browser"
    if extra == "dynamics" and sys.platform == "win32":
        return "on Windows, for which Pinocchio and coal have no wheels"
    if extra == "simulate" and sys.version_info < (3, 11):
        return "with Python 3.10: MuJoCo needs 3.11 or newer"
    if extra == "usd" and sys.version_info >= (3, 14):
        return "with Python 3.14: USD has wheels up to 3.13"
    return ""


def older(module: ModuleType, least: int) -> str:
    """``2.4 at PATH`` if the major version of a library is below the least one; empty if not."""
    version = str(getattr(module, "__version__", ""))
    major = version.partition(".")[0]
    is_older = major.isdigit() and int(major) < least
    return f"{version} at {module.__file__}" if is_older else ""


@contextmanager
def needing(what: str, extra: str, **least: int) -> Iterator[None]:
    """Context of an import from an extra.

    Args:
        what: the subject of the error message: ``what needs numpy``.
        least: least major versions of libraries, which are imported.

    Raises:
        MissingLibrary: a library is not installed, or too old; with the command that installs it.
    """
    try:
        for name, version in least.items():
            if old := older(import_module(name), version):
                raise MissingLibrary(
                    f"{what} needs {name} {version}, not {old}: {install_command(extra)}"
                )
        yield
    except MissingLibrary:
        raise
    except ImportError as error:
        library = str(error.name).partition(".")[0]
        raise MissingLibrary(f"{what} needs {library}: {install_command(extra)}") from error


def _program() -> str:
    """The command by which the program that made this environment installs packages."""
    if _in_prefix("uv-receipt.toml"):
        return "uv tool install"
    if _in_prefix("pipx_metadata.json"):
        return "pipx install --force"
    return "uv pip install" if "\nuv = " in _in_prefix("pyvenv.cfg") else "pip install"


def _in_prefix(name: str) -> str:
    """The text of a file of this environment; empty if it does not exist."""
    try:
        with open(os.path.join(sys.prefix, name), encoding="utf-8") as file:
            return file.read()
    except OSError:
        return ""


def _requirement(extras: str) -> str:
    """Requirement specifier of this urdfkit with extras."""
    if os.path.isfile(os.path.join(_HOME, "pyproject.toml")):
        return f'-e "{_HOME}{extras}"'
    origin = _origin()
    return f'"urdfkit{extras}{origin and " @ "}{origin}"'


def _origin() -> str:
    """URL of the installation, from PEP 610; empty for a package index."""
    import json

    records = (name for name in os.listdir(_HOME) if re.fullmatch(r"urdfkit-.*\.dist-info", name))
    try:
        with open(os.path.join(_HOME, next(records), "direct_url.json"), encoding="utf-8") as file:
            found = json.load(file)
        vcs = found.get("vcs_info")
        return f"{vcs['vcs']}+{found['url']}@{vcs['commit_id']}" if vcs else str(found["url"])
    except (OSError, ValueError, LookupError, StopIteration):
        return ""
