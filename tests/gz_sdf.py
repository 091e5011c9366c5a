"""``gz sdf``, which tests compare with."""

import re
import shutil
import subprocess
from functools import cache
from pathlib import Path

from tests.conftest import ROOT
from tests.libsdformat import compiled, pkg_config


def program() -> tuple[str, tuple[int, ...]]:
    """A program with the arguments of ``gz``, and the version of libsdformat.

    ``gz`` or ``ign``, or one that is compiled with libsdformat; skips without these.
    """
    return _installed() or _compiled()


@cache
def _installed() -> tuple[str, tuple[int, ...]] | None:
    for name in ("gz", "ign"):
        path = shutil.which(name)
        if path is None:
            continue
        done = subprocess.run(
            [path, "sdf", "--versions"], capture_output=True, text=True, check=False
        )
        versions = re.findall(r"\d+\.\d+\.\d+", done.stdout)
        if versions:
            return path, max(map(_version, versions))
    return None


def _compiled() -> tuple[str, tuple[int, ...]]:
    packages = re.findall(r"^sdformat\d+", pkg_config("--list-all"), re.MULTILINE)
    package = max(packages, default="sdformat")
    code = Path(__file__).with_suffix(".cc").read_text()
    path = compiled(code, package, ROOT / ".pytest_cache" / "libsdformat")
    return str(path), _version(pkg_config("--modversion", package).strip())


def _version(text: str) -> tuple[int, ...]:
    return tuple(map(int, text.split(".")))
