"""What the worker of the playground asks Python: a package in the memory of the browser."""

import io
import json
import os
import shutil
import zipfile
from pathlib import Path
from typing import Protocol

import urdfkit
from docs.playground.scene import scene
from urdfkit.lint import config_reader
from urdfkit.output.formats import json as as_json
from urdfkit.workspace.config_file import nearest

ROOT = Path("/robot")
#: What the editor shows.
TEXTS = ".xacro .urdf .srdf .sdf .world .xml .yaml .yml .toml .py .launch .gazebo .txt".split()
MOST = 1_000_000  # bytes of a text, which an editor still takes
MOST_UNPACKED, MOST_FILES = 300_000_000, 20_000  # bytes and files of a zip


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
    """Take the files of a zip.

    Raises:
        ValueError: it holds more than the memory of a browser.
    """
    with zipfile.ZipFile(io.BytesIO(data.to_bytes())) as file:
        members = file.infolist()
        size = sum(one.file_size for one in members)
        if size > MOST_UNPACKED or len(members) > MOST_FILES:
            raise ValueError(
                f"the zip has {len(members):,} files of {size / 1e6:,.0f} MB; the playground "
                f"takes {MOST_FILES:,} of {MOST_UNPACKED / 1e6:,.0f} MB"
            )
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


def check(shown: str) -> str:
    """JSON of the findings, of what xacro makes of the file that is shown, and of the robot.

    The findings are those of ``urdfkit check .``, or of ``urdfkit check FILE`` if there is one.
    """
    files = [path for path in ROOT.rglob("*") if path.is_file()]
    named = files[0].name if len(files) == 1 else "."
    path = nearest(named)
    config = config_reader.load(path, trusted=False) if path else None
    report = urdfkit.check(named, config=config)
    found = json.loads(as_json.render(report))
    return json.dumps(
        {"report": found, "expanded": _expanded(shown), "scene": scene(report, shown)}
    )


def _expanded(path: str) -> str:
    """The URDF of a file, or why there is none."""
    try:
        return urdfkit.expand(path).text()
    except urdfkit.UrdfkitError as error:
        return str(error)
