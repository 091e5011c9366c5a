"""What the worker of the playground asks Python: a package in the memory of the browser."""

import io
import json
import os
import re
import shutil
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Protocol

import urdfkit
from docs.playground.scene import scene
from urdfkit.lint import config_reader
from urdfkit.mesh.io.referenced_files import find_image
from urdfkit.output import formats
from urdfkit.workspace.config_file import nearest

ROOT = Path("/robot")
#: What the editor shows.
TEXTS = ".xacro .urdf .srdf .sdf .world .xml .yaml .yml .toml .py .launch .gazebo .txt".split()
MOST = 1_000_000  # bytes of a text, which an editor still takes
MOST_UNPACKED, MOST_FILES = 300_000_000, 20_000  # bytes and files of a zip
#: Ends of the names of images, of the materials of OBJ, and of the numbers of glTF.
_NAMED = re.compile(rb"\.(?:png|jpe?g|gif|webp|bmp|tga|mtl|bin)\b", re.IGNORECASE)
_LONGEST = 300  # bytes of a name
_AROUND = re.compile(rb"[\"'<>\r\n]")


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
    """Take the text of a file.

    Raises:
        ValueError: the path leads out of the package.
    """
    target = ROOT / path
    if ".." in target.parts or not target.is_relative_to(ROOT):
        raise ValueError(f"'{path}' is outside of the package")
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(text, encoding="utf-8", newline="")


def texts() -> str:
    """JSON of the texts that can be edited, by path."""
    found = {}
    for path in sorted(ROOT.rglob("*")):
        if path.suffix in TEXTS and path.is_file() and path.stat().st_size <= MOST:
            found[path.relative_to(ROOT).as_posix()] = path.read_text("utf-8", errors="replace")
    return json.dumps(found)


def named(path: str) -> str:
    """JSON of the files that a mesh names, and those that its materials name: paths by names."""
    found: dict[str, str] = {}
    unread = [path] if path.lower().endswith((".dae", ".obj", ".gltf")) else []
    while unread:
        file = unread.pop()
        for name in _names(Path(file).read_bytes()) - found.keys():
            if place := find_image(name, os.path.dirname(file)):
                found[name] = place
                if place.lower().endswith(".mtl"):
                    unread.append(place)
    return json.dumps(found)


def _names(data: bytes) -> set[str]:
    """What may be names of files; in OBJ, other words are before them on the line."""
    found: set[str] = set()
    for end in _NAMED.finditer(data):
        text = data[max(end.start() - _LONGEST, 0) : end.end()]
        line = _AROUND.split(text)[-1].decode("utf-8", errors="replace").strip()
        found |= {line, line.split()[-1]}
    return found


def check(shown: str, progress: Callable[[int, int], None]) -> str:
    """JSON of the findings, of what xacro makes of the file that is shown, and of the robot.

    The findings are those of ``urdfkit check .``, or of ``urdfkit check FILE`` if there is one.

    Args:
        progress: called with the number of robots checked and of all; of one, with its meshes.
    """
    files = [path for path in ROOT.rglob("*") if path.is_file()]
    target = files[0].name if len(files) == 1 else "."
    path = nearest(target)
    config = config_reader.load(path, trusted=False) if path else None
    options = urdfkit.Options(progress=progress)
    report = urdfkit.check(target, config=config, options=options)
    found = json.loads(formats.get("json")(report))
    return json.dumps(
        {"report": found, "expanded": _expanded(shown), "scene": scene(report, shown)}
    )


def _expanded(path: str) -> str:
    """The URDF of a file, or why there is none."""
    try:
        return urdfkit.expand(path).text()
    except urdfkit.UrdfkitError as error:
        return str(error)
