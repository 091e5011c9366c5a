"""What the worker of the playground asks Python: a package in the memory of the browser."""

from __future__ import annotations

import io
import json
import os
import shutil
import zipfile
from pathlib import Path
from typing import Protocol

import urdfkit
from urdfkit.lint import config_reader
from urdfkit.output.formats import json as as_json
from urdfkit.workspace.config_file import nearest

ROOT = Path("/robot")
#: What the editor shows.
TEXTS = ".xacro .urdf .srdf .sdf .world .xml .yaml .yml .toml .py .launch .gazebo .txt".split()
MOST = 1_000_000  # bytes of a text, which an editor still takes


class JsBuffer(Protocol):
    """Bytes of JavaScript, as Pyodide hands them over."""

    def to_bytes(self) -> bytes:
        """A copy."""


def clear() -> None:
    """Forget the package before."""
    os.chdir("/")
    shutil.rmtree(ROOT, ignore_errors=True)
    ROOT.mkdir()
    os.chdir(ROOT)


def unpack(data: JsBuffer) -> None:
    """Take the files of a zip."""
    with zipfile.ZipFile(io.BytesIO(data.to_bytes())) as file:
        file.extractall(ROOT)


def write(path: str, text: str) -> None:
    """Take the text of a file."""
    target = ROOT / path
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(text, encoding="utf-8", newline="")


def texts() -> str:
    """JSON of the texts that can be edited, by path."""
    found = {}
    for path in sorted(ROOT.rglob("*")):
        if path.suffix in TEXTS and path.is_file() and path.stat().st_size <= MOST:
            found[path.relative_to(ROOT).as_posix()] = path.read_text("utf-8", errors="replace")
    return json.dumps(found)


def check() -> str:
    """What ``urdfkit check . --format json`` prints; of a single file, ``urdfkit check FILE``."""
    files = [path for path in ROOT.rglob("*") if path.is_file()]
    named = files[0].name if len(files) == 1 else "."
    path = nearest(named)
    config = config_reader.load(path, trusted=False) if path else None
    return as_json.render(urdfkit.check(named, config=config))


def expand(path: str) -> str:
    """What xacro makes of a file, or why it makes nothing."""
    try:
        return urdfkit.expand(path).text()
    except urdfkit.UrdfkitError as error:
        return str(error)
