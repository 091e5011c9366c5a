"""Worlds of Gazebo in SDF: their systems, physics, ground and models."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from functools import lru_cache

from urdfkit.core.record import Record
from urdfkit.robot.placed import Placed
from urdfkit.robot.values import number, numbers
from urdfkit.ros.catalog import data
from urdfkit.ros.catalog.plugins import find
from urdfkit.text.comments import without_comments
from urdfkit.text.diagnostic import Problem
from urdfkit.text.document import Element
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_as_tinyxml
from urdfkit.workspace.resolve import Resolver

#: Default step of physics, in s.
DEFAULT_STEP = 0.001
#: Directories of a workspace that are searched for models.
MAX_DIRECTORIES = 2000

_FILENAME = rb"""<plugin\b[^<>]*\bfilename\s*=\s*["']([^"']+)"""
#: URI of a model on Gazebo's resource path.
_MODEL = re.compile(r"model://([^/]+)/?$")
_DEFINITIONS = ("model.config", "model.sdf")
#: A box is a floor if it is so wide, and so flat, in m.
_WIDE, _FLAT = 5.0, 0.5
#: A box at this height in m is a ceiling, or above an open field what a lidar sees.
_CEILING = 1.5
#: Elements whose contents are not those of SDF.
_FOREIGN = ("plugin", "gui", "state")


class World(Record):
    """A ``<world>``."""

    at: Element
    source: Source  # the file

    @property
    def name(self) -> str:
        return self.at.get("name") or ""

    @property
    def elements(self) -> Iterator[Element]:
        """All elements of SDF: without those of plugins, which have elements of their own."""
        stack = [self.at]
        while stack:
            element = stack.pop()
            yield element
            stack += [child for child in element.children if child.tag not in _FOREIGN]

    @property
    def plugins(self) -> list[Element]:
        return self.at.all("plugin")

    @property
    def includes(self) -> Iterator[tuple[Element, str]]:
        """The ``<uri>`` of the models that it includes, and their texts."""
        for include in self.at.all("include"):
            uri = include.child("uri")
            if uri is not None:
                yield uri, uri.text.strip()

    @property
    def is_weightless(self) -> bool:
        """True if its gravity is written, and 0."""
        gravity = self.at.child("gravity")
        return gravity is not None and not any(numbers(gravity.text) or ())

    @property
    def step(self) -> Placed[float]:
        """Step of the first physics in s; located at the world if it is the default."""
        for physics in self.at.all("physics")[:1]:
            written = physics.child("max_step_size")
            value = number(written.text.strip()) if written is not None else None
            if written is not None and value is not None and value > 0:
                return Placed(value, written)
        return Placed(DEFAULT_STEP, self.at)

    @property
    def ground(self) -> float | None:
        """Height of the floor in m, if it is one level plane or slab; None if unknown."""
        if self.at.child("heightmap") or any(part.tag == "heightmap" for part in self.at.walk()):
            return None
        heights = {
            height
            for element in (*self.at.all("model"), *self.at.all("include"))
            if _is_plane(element) and (height := _level(element)) is not None
        } or {top for model in self.at.all("model") if (top := _top_of_slab(model)) is not None}
        return heights.pop() if len(heights) == 1 else None

    def loads_default_systems(self) -> bool | None:
        """True if it loads the systems of the server configuration, too; None: by version."""
        for policies in (child for child in self.at.children if child.tag.endswith(":policies")):
            written = policies.child("include_server_config_plugins")
            if written is not None:
                return written.text.strip().lower() in ("true", "1")
        return None


@lru_cache(maxsize=8)  # launch files of a workspace start the same few worlds
def read_world(path: str, resolver: Resolver) -> tuple[World | None, list[Problem]]:
    """The world in a file (None if there is none), and problems of the text.

    Raises:
        UnreadableFile: the file is missing, or cannot be read.
    """
    source = resolver.read(path)
    document, problems = read_as_tinyxml(source)
    root = document.root if document else None
    world = root.child("world") if root is not None and root.tag == "sdf" else None
    return (World(world, source) if world is not None else None), problems


def has_model(path: str, resolver: Resolver) -> bool:
    """True for a file with a model and no world, which gz sim 7 and later load into ``default``.

    Source: gz-sim, Server.cc, gazebosim/gz-sim#1775.
    """
    document, _ = read_as_tinyxml(resolver.read(path))
    return document is not None and document.root.child("model") is not None


def shipped_worlds() -> dict[str, tuple[str, frozenset[str]]]:
    """Name and systems of the worlds of gz sim, by file."""
    worlds = {}
    for file, text in data("worlds")["worlds"].items():
        name, _, systems = text.partition(":")
        worlds[file] = (name, frozenset(systems.split()))
    return worlds


def default_systems() -> frozenset[str]:
    return frozenset(data("worlds")["defaults"].split())


def systems_in(files: list[str]) -> frozenset[str]:
    """The systems of gz sim in libraries, by the last word of their class."""
    loaded = (plugin for file in files for plugin in find(file) if plugin.generation == "gz")
    return frozenset(plugin.system for plugin in loaded)


def own_systems(world: World) -> frozenset[str]:
    """The systems of the plugins directly in a world."""
    return systems_in([plugin.get("filename") or "" for plugin in world.plugins])


def all_systems(world: World, models: Models) -> frozenset[str]:
    """The systems of a world and of its available models."""
    files = _filenames(world.source.data)
    for _, uri in world.includes:
        files += models.libraries(uri)
    return systems_in(files)


def _filenames(text: bytes) -> list[str]:
    names = re.findall(_FILENAME, without_comments(text))
    return [name.decode("utf-8", "replace") for name in names]


class Models:
    """The models of a workspace, which worlds include as ``model://name``."""

    def __init__(self, resolver: Resolver, near: str) -> None:
        self._resolver = resolver
        self._near = near

    @property
    def directories(self) -> dict[str, list[str]]:
        """Model directories, by name."""
        return _models(self._resolver.packages.workspace(self._near), self._resolver)

    def has(self, uri: str) -> bool:
        """True if a model is available."""
        name = model_name(uri)
        return name in self.directories or self._resolver.locate(uri, self._near).path is not None

    def libraries(self, uri: str) -> list[str]:
        """File names of the plugins of a model; empty if it is not available."""
        files: list[str] = []
        for directory in self.directories.get(model_name(uri), ()):
            source = self._resolver.readable(os.path.join(directory, "model.sdf"))
            files += _filenames(source.data) if source else []
        return files


@lru_cache(maxsize=2)
def _models(root: str, resolver: Resolver) -> dict[str, list[str]]:
    """Model directories of a workspace, by name."""
    directories: dict[str, list[str]] = {}
    for path in resolver.directories.files_below(root, MAX_DIRECTORIES):
        directory, name = os.path.split(path)
        if name in _DEFINITIONS:
            directories.setdefault(os.path.basename(directory), []).append(directory)
    return directories


def model_name(uri: str) -> str:
    """The name in ``model://name``; empty for other URIs."""
    match = _MODEL.match(uri)
    return match.group(1) if match else ""


def _is_plane(element: Element) -> bool:
    """True for a floor, by its geometry or the name of the included file."""
    if element.tag == "include":
        uri = element.child("uri")
        words = (uri.text if uri is not None else "").casefold()
        return words.strip().rstrip("/").endswith(("ground_plane", "ground plane"))
    return any(part.tag == "plane" and part.parent is not None for part in element.walk())


def _top_of_slab(model: Element) -> float | None:
    """Height in m of a floor that is a wide and flat box below the origin; None for others."""
    static = model.child("static")
    collisions = [part for part in model.walk() if part.tag == "collision"]
    geometry = collisions[0].child("geometry") if len(collisions) == 1 else None
    box = geometry.child("box") if geometry is not None else None
    size = box.child("size") if box is not None else None
    sides = numbers(size.text) if size is not None else None
    level, pose = _level(model), model.child("pose")
    if static is None or static.text.strip().lower() not in ("true", "1") or level is None:
        return None
    if sides is None or len(sides) != 3 or min(sides[:2]) < _WIDE or sides[2] > _FLAT:
        return None
    if level > _CEILING:
        return None
    x, y = (numbers(pose.text) or (0.0, 0.0))[:2] if pose is not None else (0.0, 0.0)
    return level + sides[2] / 2 if max(abs(x), abs(y)) < min(sides[:2]) / 2 else None


def _level(element: Element) -> float | None:
    """Height of a floor in m; None if it is inclined or unknown."""
    height = 0.0
    for part in element.walk():
        if part.tag != "pose" or not part.text.strip():
            continue
        pose = numbers(part.text)
        if pose is None or len(pose) != 6 or any(pose[3:5]) or part.get("relative_to"):
            return None
        if part.parent is not None and part.parent.tag != "visual":
            height += pose[2]
    return height
