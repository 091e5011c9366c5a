"""Cache of the measures of mesh files between runs, by file content.

An entry is named by the hash of the bytes, so that it never becomes stale, and is written
atomically: two runs may write the same entry at the same time. Broken entries are computed again.
"""

from __future__ import annotations

import json
import os
import re
from functools import lru_cache

from urdfkit.core import disk
from urdfkit.core.cache_directory import cache_directory
from urdfkit.core.cache_entries import store
from urdfkit.core.regular_file import opened
from urdfkit.mesh.io import facts
from urdfkit.mesh.io.facts import MAX_BYTES
from urdfkit.mesh.measures import Measures, from_json, to_json

#: Increases when the measures, their texts, or the data they are computed from change.
VERSION = 12

#: Most bytes of one of the 256 directories; an entry has about 2 kB.
MAX_DIRECTORY = 200_000

_MATERIALS = rb"(?:\A|\n)[ \t]*mtllib[ \t]+([^\r\n]*)"
_URI = rb'"uri"\s*:\s*"(?!data:)([^"]{1,1000})"'


@lru_cache
def shared(*, cached: bool) -> Store:
    """The store of this process."""
    return Store(default_directory() if cached else None)


def default_directory() -> str | None:
    """The directory of the cache; None if the environment disables the cache."""
    cache = cache_directory()
    return os.path.join(cache, "meshes") if cache else None


class Store:
    """Measures mesh files, each content once.

    Args:
        directory: the cache directory; None caches for this process only.
    """

    def __init__(self, directory: str | None) -> None:
        self._directory = os.path.join(directory, f"v{VERSION}") if directory else None
        self._known: dict[tuple[object, ...], Measures | str] = {}  # by path and state
        self._by_content: dict[str, Measures | str] = {}  # by hash: packages copy meshes

    def measures(self, path: str, form: str) -> Measures | str:
        """The measures of a file, or the reason for none: a predicate whose subject is the file."""
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
        result = _read(entry)
        if result is None:
            result = _measured(data, path)
            content = result if isinstance(result, str) else to_json(result)
            store(entry, json.dumps(content).encode(), MAX_DIRECTORY)
        return result


def _digest(data: bytes, form: str, directory: str) -> str:
    """Hash of a file and the files that it references, on which the measures depend."""
    from urdfkit.core.digest import blake2b
    from urdfkit.mesh.io import referenced_files

    digest = blake2b(f"{form} {len(data)}\n".encode(), digest_size=20)
    digest.update(data)
    for name in _names(data, form):
        path = referenced_files.place(name, directory)
        digest.update(name.encode() + (referenced_files.read(path, MAX_BYTES, directory) or b""))
    return digest.hexdigest()


def _names(data: bytes, form: str) -> list[str]:
    """References of a file to other files on which its measures depend."""
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
    """The content of an entry; None if it is missing or broken."""
    try:
        with opened(entry) as file:
            data = file.read()
    except OSError:
        return None
    try:
        content = json.loads(data)
        return content if isinstance(content, str) else from_json(content)
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return None
