"""Measures of mesh files, kept between runs by the content of the files.

An entry is named by the hash of the bytes, so that it is true wherever it is found, and is
written whole or not at all: two runs may write the same one at the same time. What is broken is
measured again.
"""

from __future__ import annotations

import os
import re
from functools import lru_cache

from urdfkit.core import atomic, disk
from urdfkit.core.cache_directory import cache_directory
from urdfkit.core.regular_file import opened
from urdfkit.errors import UnwritableFile
from urdfkit.mesh.io import facts
from urdfkit.mesh.io.facts import MAX_BYTES
from urdfkit.mesh.measures import Measures, from_json, to_json

#: Goes up when measures change, or what they are made from.
VERSION = 10

#: Entries in one of the 256 directories; of some 2 kB each.
MAX_ENTRIES = 100

_MATERIALS = rb"(?:\A|\n)[ \t]*mtllib[ \t]+([^\r\n]*)"
_URI = rb'"uri"\s*:\s*"(?!data:)([^"]{1,1000})"'


@lru_cache
def shared(*, cached: bool) -> Store:
    """The store of this process."""
    return Store(default_directory() if cached else None)


def default_directory() -> str | None:
    """The directory of the cache; None if the environment wants none."""
    cache = cache_directory()
    return os.path.join(cache, "meshes") if cache else None


class Store:
    """Measures mesh files, each content once.

    Args:
        directory: where measures are kept; None keeps them for this process only.
    """

    def __init__(self, directory: str | None) -> None:
        self._directory = os.path.join(directory, f"v{VERSION}") if directory else None
        self._known: dict[tuple[object, ...], Measures | str] = {}  # by path and state
        self._by_content: dict[str, Measures | str] = {}  # by hash: packages copy meshes

    def measures(self, path: str, form: str) -> Measures | str:
        """The measures of a file, or why it has none, as a predicate whose subject is the file."""
        try:
            state = disk.state(path)
        except (OSError, ValueError) as error:
            return f"cannot be read: {error}"
        key = (path, state.st_dev, state.st_ino, state.st_size, state.st_mtime_ns)
        if key not in self._known:
            self._known[key] = self._measures(path, form)
        return self._known[key]

    def _measures(self, path: str, form: str) -> Measures | str:
        try:
            data = disk.read(path, MAX_BYTES)
        except OSError as error:
            return f"cannot be read: {error.strerror or error}"
        digest = _digest(data, form, os.path.dirname(path))
        if digest not in self._by_content:
            self._by_content[digest] = self._of_content(digest, data, path)
        return self._by_content[digest]

    def _of_content(self, digest: str, data: bytes, path: str) -> Measures | str:
        if self._directory is None:
            return _measured(data, path)
        entry = os.path.join(self._directory, digest[:2], f"{digest[2:]}.json")
        known = _read(entry)
        if known is None:
            known = _measured(data, path)
            _write(entry, known)
        return known


def _digest(data: bytes, form: str, directory: str) -> str:
    """Hash of a file and of the files that it names: all that the measures are computed from."""
    from urdfkit.core.digest import blake2b
    from urdfkit.mesh.io import referenced_files

    digest = blake2b(f"{form} {len(data)}\n".encode(), digest_size=20)
    digest.update(data)
    for name in _names(data, form):
        path = referenced_files.place(name, directory)
        digest.update(name.encode() + (referenced_files.read(path, MAX_BYTES, directory) or b""))
    return digest.hexdigest()


def _names(data: bytes, form: str) -> list[str]:
    """How a file names others that its measures are made from too."""
    if form == facts.OBJ:
        return [name.decode("utf-8", "replace") for name in re.findall(_MATERIALS, data)]
    if form not in (facts.GLB, facts.GLTF):
        return []
    from urllib.parse import unquote

    return [unquote(name.decode("utf-8", "replace")) for name in re.findall(_URI, data)]


def _measured(data: bytes, path: str) -> Measures | str:
    from urdfkit.mesh.io.load import UnloadableMesh, load_bytes
    from urdfkit.mesh.measuring import measure

    try:
        return measure(load_bytes(data, path))
    except UnloadableMesh as error:
        return error.reason


def _read(entry: str) -> Measures | str | None:
    """What was written; None if nothing was, or something else."""
    try:
        with opened(entry) as file:
            data = file.read()
    except OSError:
        return None
    import json

    try:
        content = json.loads(data)
        return content if isinstance(content, str) else from_json(content)
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return None


def _write(entry: str, known: Measures | str) -> None:
    """Keep measures; a check goes on if this fails."""
    import json

    content = known if isinstance(known, str) else to_json(known)
    directory = os.path.dirname(entry)
    try:
        os.makedirs(directory, exist_ok=True)
        _make_room(directory)
        atomic.write(entry, json.dumps(content).encode(), durable=False)
    except (OSError, UnwritableFile):
        return


def _make_room(directory: str) -> None:
    """Remove the older half of the entries of a full directory."""
    names = os.listdir(directory)
    if len(names) < MAX_ENTRIES:
        return
    by_age = sorted((os.stat(os.path.join(directory, name)).st_mtime, name) for name in names)
    for _, name in by_age[: MAX_ENTRIES // 2]:
        os.unlink(os.path.join(directory, name))
