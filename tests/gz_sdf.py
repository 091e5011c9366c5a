"""libsdformat, which tests compare with."""

import re
import shutil
import subprocess
import tempfile
from functools import cache
from pathlib import Path

import pytest


def program() -> tuple[str, tuple[int, ...]]:
    """A program with the arguments of ``gz``, and the version of libsdformat.

    ``gz`` or ``ign``, or one that is compiled with libsdformat-dev of apt; skips without these.
    """
    found = _installed() or _compiled()
    if found is None:
        pytest.skip("neither 'gz sdf' nor libsdformat-dev with g++ and pkg-config is installed")
    return found


@cache
def _installed() -> tuple[str, tuple[int, ...]] | None:
    for name in ("gz", "ign"):
        path = shutil.which(name)
        if path is None:
            continue
        said = _run(path, "sdf", "--versions")
        versions = re.findall(r"\d+\.\d+\.\d+", said.stdout)
        if versions:
            return path, max(map(_version, versions))
    return None


@cache
def _compiled() -> tuple[str, tuple[int, ...]] | None:
    if not (shutil.which("g++") and shutil.which("pkg-config")):
        return None
    listed = re.findall(r"^sdformat\d+", _run("pkg-config", "--list-all").stdout, re.MULTILINE)
    for package in listed:
        version = _run("pkg-config", "--modversion", package).stdout.strip()
        flags = _run("pkg-config", "--cflags", "--libs", package).stdout.split()
        path = Path(tempfile.mkdtemp(prefix="libsdformat-")) / "sdf"
        source = str(Path(__file__).with_suffix(".cc"))
        if _run("g++", "-std=c++17", source, *flags, "-o", str(path)).returncode == 0:
            return str(path), _version(version)
    return None


def _run(*command: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, capture_output=True, text=True, check=False)


def _version(text: str) -> tuple[int, ...]:
    return tuple(map(int, text.split(".")))
