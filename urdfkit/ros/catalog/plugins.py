"""Plugins of Gazebo: which library each is, where it belongs and which tags it reads."""

from __future__ import annotations

import re
from functools import cache
from itertools import chain

from urdfkit.core.record import Record
from urdfkit.core.static_typing import Any
from urdfkit.core.suggest import is_typo
from urdfkit.ros.catalog import data, record

#: The generations whose plugins a target loads.
GENERATIONS = {
    "classic-ros1": ("classic-ros1", "classic"),
    "classic-ros2": ("classic-ros2", "classic"),
    "gz-fortress": ("gz",),
    "gz-harmonic": ("gz",),
    "gz-jetty": ("gz",),
}

#: What each generation, and each target, is called in messages.
TITLES = {
    "classic-ros1": "Gazebo Classic with ROS 1",
    "classic-ros2": "Gazebo Classic with ROS 2",
    "classic": "Gazebo Classic",
    "gz": "gz-sim",
    "gz-fortress": "Gazebo Fortress",
    "gz-harmonic": "Gazebo Harmonic",
    "gz-jetty": "Gazebo Jetty",
}

#: Types of parameters that the plugin looks up in the simulated model. ``joints`` is a list.
REFERENCES = ("link", "joint", "joints")

# Compiled when needed: gz-sim forgives what few models need forgiven.
_GZ_NAME = r"(?:.*/)?(?:lib)?(gz-sim|ignition-gazebo)\d*(-.+?)(?:\.so)?$"
_ROS2_CONTROL = r"(?:.*/)?(?:lib)?((?:gz|ign)_ros2_control-system)(?:\.so)?$"


class Parameter(Record):
    """A tag that a plugin reads."""

    name: str  # its path in the plugin, such as ``leftJoint``, ``ros/namespace`` or ``wheel/@name``
    type: str  # ``float``, ``bool``, ``frame``, one of ``REFERENCES`` and so on
    required: bool  # True if the plugin does nothing, or fails, without it
    default: str | None  # as text; None if there is none, or it is found at run time
    #: The values that it may have, or of a link, that are not looked up; empty if any.
    words: tuple[str, ...] = ()


class Drive(Record):
    """How a plugin drives a robot."""

    #: Its parameter with the distance of left and right wheels; empty if it has none.
    separation: str = ""
    size: str = ""  # its parameter with the size of the wheels
    diameter: bool = False  # True if that is the diameter, False if it is the radius
    #: True if wheels are steered, so that left and right say nothing about turning.
    steered: bool = False
    #: True if turning makes the wheels slip, so that a larger separation is often given.
    slips: bool = False


class Plugin(Record):
    """A plugin of one generation."""

    id: str  # the library and the generation
    files: tuple[str, ...]  # the names that it is loaded by
    generation: str  # ``classic-ros1``, ``classic-ros2``, ``classic`` (without ROS) or ``gz``
    #: What it belongs in: ``model``, ``sensor``, ``visual``, ``world``, ``system``...
    kinds: tuple[str, ...]
    parameters: dict[str, Parameter]  # the tags that it reads, by path
    fortress_files: tuple[str, ...] = ()  # those in Gazebo Fortress; empty if it is not there
    #: The types of sensor that it serves; empty if it says nothing about them.
    sensors: tuple[str, ...] = ()
    package: str = ""  # that has it; empty if removed
    class_name: str = ""  # of gz; the ``name`` that the model must give. Empty elsewhere
    fortress_class: str = ""  # the same in Fortress
    removed: bool = False  # True if the generation has no such library any more
    successor: str | None = None  # file name of what replaces it in the next generation, or None
    advice: str = ""  # what else to do then
    missing: str = ""  # what happens if a link or joint that it names is not there
    open: tuple[str, ...] = ()  # children of which it reads anything; ``*`` for all
    patterns: tuple[str, ...] = ()  # regular expressions of more names that it reads
    node: bool = False  # True if its name becomes that of a ROS node
    any_of: tuple[str, ...] = ()  # parameters of which one is required
    drive: Drive | None = None  # how it drives a robot with wheels; None if it is no drive
    moves: str = ""  # of what moves a single joint, the parameter that names it; ``*`` for any

    def reads(self, path: str) -> bool:
        """True if it reads a tag or an attribute at a path in it, or something inside that tag."""
        top = path.partition("/")[0]
        if path in self.parameters or "*" in self.open or top in self.open:
            return True
        if any(name.startswith(f"{path}/") for name in self.parameters):
            return True
        return any(re.fullmatch(pattern, path) for pattern in self.patterns)


@cache
def _content() -> dict[str, dict[str, Any]]:
    """The file of each generation: 115 kB, which take 1 ms."""
    generations = dict.fromkeys(chain.from_iterable(GENERATIONS.values()))
    return {name: data(f"gazebo_plugins/{name.replace('-', '_')}") for name in generations}


@cache
def _numbers() -> dict[str, list[tuple[str, int]]]:
    """The plugins that each file name loads: their generations, and their numbers there."""
    found: dict[str, list[tuple[str, int]]] = {}
    for generation, content in _content().items():
        for number, entry in enumerate(content["plugins"]):
            for file in dict.fromkeys((*entry["files"], *entry.get("fortress_files", ()))):
                found.setdefault(file, []).append((generation, number))
    return found


def files() -> tuple[str, ...]:
    return tuple(_numbers())


#: Words in the names of Gazebo's libraries that do not say what they do.
_FRAME = frozenset("gz ign ignition gazebo sim system plugin".split())


@cache
def misspelt(filename: str) -> str:
    """The file name suggested for an unknown one; empty if it may be a vendor's own.

    They differ in one letter, in two that changed places, or in ``lib`` and ``.so``.
    """
    stem = _stem(filename)
    return next((file for file in files() if is_typo(stem, _stem(file))), "")


def of_same_words(filename: str) -> str:
    """The system of gz-sim that is called like an unknown library: libgz_diff_drive.so; or empty.

    Only names that begin like those of Gazebo's own libraries are looked at.
    """
    words = re.findall(r"[a-z0-9]+", _stem(filename).casefold())
    if words[:1] not in (["gz"], ["ign"], ["ignition"]):
        return ""
    kind = set(words) - _FRAME
    alike = (name for name in files() if name.startswith("gz-sim-"))
    return next((name for name in alike if kind and set(name.split("-")) - _FRAME == kind), "")


def _stem(filename: str) -> str:
    return filename.removeprefix("lib").removesuffix(".so")


def find(filename: str) -> tuple[Plugin, ...]:
    """The plugins that a ``filename`` means: of each generation one, or one for each class.

    Gazebo Classic wants the name of the library as it is; gz-sim forgives a missing ``lib`` and
    ``.so``, and the version number in ``gz-sim8-``.
    """
    known = _numbers()
    found = known.get(filename, ())
    if not found and "-" in filename and (match := re.match(_GZ_NAME, filename)):
        found = known.get("".join(match.groups()), ())
    if not found and "-" in filename and (match := re.match(_ROS2_CONTROL, filename)):
        found = known.get(match.group(1), ())
    return tuple(_plugin(*one) for one in found)


def all_plugins() -> tuple[Plugin, ...]:
    return tuple(
        _plugin(generation, number)
        for generation, content in _content().items()
        for number in range(len(content["plugins"]))
    )


def renames() -> dict[str, str]:
    """What the tags of ROS 1 plugins are called in ROS 2, where the plugin has that tag."""
    return dict(_content()["classic-ros2"]["renames"])


def often_unread() -> dict[str, list[str]]:
    """Tags that shipped examples give to plugins which do not read them, by generation."""
    return {name: content.get("unread", []) for name, content in _content().items()}


@cache
def _plugin(generation: str, number: int) -> Plugin:
    content = _content()[generation]
    entry = content["plugins"][number]
    written: dict[str, str] = (content["ros_block"] if entry.get("ros") else {}) | entry[
        "parameters"
    ]
    words = entry.get("words", {})
    return record(
        Plugin,
        entry,
        generation=generation,
        class_name=entry.get("class", ""),
        drive=record(Drive, entry["drive"]) if "drive" in entry else None,
        parameters={
            name: _parameter(name, text, words.get(name, ())) for name, text in written.items()
        },
    )


def _parameter(name: str, text: str, words: list[str]) -> Parameter:
    """Read ``TYPE``, ``!`` if required, ``*`` if it may be repeated, ``= DEFAULT``."""
    kind, has_default, default = text.partition(" = ")
    return Parameter(
        name, kind.rstrip("!*"), "!" in kind, default if has_default else None, tuple(words)
    )
