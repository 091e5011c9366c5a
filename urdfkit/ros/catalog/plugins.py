"""Plugins of Gazebo: their libraries, parents and tags."""

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

#: Names of generations and targets in messages.
TITLES = {
    "classic-ros1": "Gazebo Classic with ROS 1",
    "classic-ros2": "Gazebo Classic with ROS 2",
    "classic": "Gazebo Classic",
    "gz": "gz-sim",
    "gz-fortress": "Gazebo Fortress",
    "gz-harmonic": "Gazebo Harmonic",
    "gz-jetty": "Gazebo Jetty",
}

#: Types of parameters that name parts of the simulated model; ``joints`` is a list.
REFERENCES = ("link", "joint", "joints")

# Compiled when needed: few models need the tolerance of gz-sim.
_GZ_NAME = r"(?:.*/)?(?:lib)?(gz-sim|ignition-gazebo)\d*(-.+?)(?:\.so)?$"
_ROS2_CONTROL = r"(?:.*/)?(?:lib)?((?:gz|ign)_ros2_control-system)(?:\.so)?$"


class Parameter(Record):
    """A tag that a plugin reads."""

    name: str  # its path in the plugin, such as ``leftJoint``, ``ros/namespace`` or ``wheel/@name``
    type: str  # ``float``, ``bool``, ``frame``, one of ``REFERENCES`` and so on
    required: bool  # True if the plugin does nothing, or fails, without it
    default: str | None  # as text; None if missing, or known only at run time
    #: Valid values, or names of links that are not looked up; empty if all values are valid. For an
    #: integer the meanings of 0, 1 and so on.
    words: tuple[str, ...] = ()
    other_words: str = ""  # what it reads another word as; empty if as the default


class Drive(Record):
    """Parameters of a plugin that drives a robot."""

    #: The parameter for the distance of left and right wheels; empty if missing.
    separation: str = ""
    size: str = ""  # the parameter for the size of the wheels
    diameter: bool = False  # True if the size is the diameter, False if it is the radius
    #: True if wheels are steered, so that left and right do not define the turning direction.
    steered: bool = False
    #: True if the wheels slip when turning, so that a larger separation is common.
    slips: bool = False


class Plugin(Record):
    """A plugin of one generation."""

    id: str  # the library and the generation
    files: tuple[str, ...]  # file names that load it
    generation: str  # ``classic-ros1``, ``classic-ros2``, ``classic`` (without ROS) or ``gz``
    #: Valid parents: ``model``, ``sensor``, ``visual``, ``world``, ``system``...
    kinds: tuple[str, ...]
    parameters: dict[str, Parameter]  # the tags that it reads, by path
    fortress_files: tuple[str, ...] = ()  # file names in Gazebo Fortress; empty if missing there
    #: The types of sensor that it supports; empty if unknown.
    sensors: tuple[str, ...] = ()
    package: str = ""  # of the library; empty if removed
    class_name: str = ""  # the required ``name`` in gz; empty for other generations
    fortress_class: str = ""  # the required ``name`` in Fortress
    removed: bool = False  # True if the generation no longer has the library
    successor: str | None = None  # file name of its replacement in the next generation, or None
    advice: str = ""  # other steps of the replacement
    missing: str = ""  # effect of a reference to a missing link or joint
    open: tuple[str, ...] = ()  # children with arbitrary contents; ``*`` for all
    patterns: tuple[str, ...] = ()  # regular expressions of other names that it reads
    node: bool = False  # True if its name becomes the name of a ROS node
    lenient: bool = False  # True if it runs without the parameters that it calls required
    any_of: tuple[str, ...] = ()  # parameters of which one is required
    drive: Drive | None = None  # None if it does not drive wheels
    moves: str = ""  # the parameter that names the joint that it moves; ``*`` for any

    @property
    def system(self) -> str:
        """The last word of its class, such as ``Sensors``; empty for other generations than gz."""
        return self.class_name.rpartition("::")[2]

    def reads(self, path: str) -> bool:
        """True if it reads a tag or an attribute at a path, or a part of that tag."""
        top = path.partition("/")[0]
        if path in self.parameters or "*" in self.open or top in self.open:
            return True
        if any(name.startswith(f"{path}/") for name in self.parameters):
            return True
        return any(re.fullmatch(pattern, path) for pattern in self.patterns)


@cache
def _content() -> dict[str, dict[str, Any]]:
    """The content of the file of each generation: 115 kB, read in 1 ms."""
    generations = dict.fromkeys(chain.from_iterable(GENERATIONS.values()))
    return {name: data(f"gazebo_plugins/{name.replace('-', '_')}") for name in generations}


@cache
def _numbers() -> dict[str, list[tuple[str, int]]]:
    """The plugins of each file name: their generations, and their indices there."""
    places: dict[str, list[tuple[str, int]]] = {}
    for generation, content in _content().items():
        for number, entry in enumerate(content["plugins"]):
            for file in dict.fromkeys((*entry["files"], *entry.get("fortress_files", ()))):
                places.setdefault(file, []).append((generation, number))
    return places


def files() -> tuple[str, ...]:
    return tuple(_numbers())


#: Words without meaning in the names of Gazebo's libraries.
_FRAME = frozenset("gz ign ignition gazebo sim system plugin".split())


@cache
def misspelt(filename: str) -> str:
    """The known file name of which an unknown file name is a typo; empty if there is none.

    They differ in one letter, in two swapped letters, or in ``lib`` and ``.so``.
    """
    stem = _stem(filename)
    return next((file for file in files() if is_typo(stem, _stem(file))), "")


def system_of_same_words(filename: str) -> str:
    """The gz-sim system with the words of an unknown library: libgz_diff_drive.so; or empty.

    Only names with the prefix of Gazebo's own libraries are compared.
    """
    words = re.findall(r"[a-z0-9]+", _stem(filename).casefold())
    if words[:1] not in (["gz"], ["ign"], ["ignition"]):
        return ""
    kind = set(words) - _FRAME
    systems = (name for name in files() if name.startswith("gz-sim-"))
    return next((name for name in systems if kind and set(name.split("-")) - _FRAME == kind), "")


def system_of_class(filename: str, name: str) -> str:
    """The gz-sim system with a class, for an unknown library named like one of Gazebo; or empty."""
    name = re.sub(r"::v\d+\b", "", name).replace("ignition::gazebo", "gz::sim")
    is_alike = re.match(r"(ros_)?(gz|ign|ignition|gazebo)[-_]", _stem(filename))
    known = (plugin for plugin in all_plugins() if name and plugin.class_name == name)
    plugin = next(known, None) if is_alike else None
    return plugin.files[0] if plugin else ""


def _stem(filename: str) -> str:
    return filename.removeprefix("lib").removesuffix(".so")


def find(filename: str) -> tuple[Plugin, ...]:
    """The plugins of a ``filename``: one for each generation, or for each class of a library.

    Gazebo Classic requires the exact name of the library; gz-sim accepts names without ``lib`` and
    ``.so``, and a version number as in ``gz-sim8-``.
    """
    known = _numbers()
    places = known.get(filename, ())
    if not places and "-" in filename and (match := re.match(_GZ_NAME, filename)):
        places = known.get("".join(match.groups()), ())
    if not places and "-" in filename and (match := re.match(_ROS2_CONTROL, filename)):
        places = known.get(match.group(1), ())
    return tuple(_plugin(*place) for place in places)


def all_plugins() -> tuple[Plugin, ...]:
    return tuple(
        _plugin(generation, number)
        for generation, content in _content().items()
        for number in range(len(content["plugins"]))
    )


def renames() -> dict[str, str]:
    """Tags of plugins in ROS 2, by the tag in ROS 1."""
    return dict(_content()["classic-ros2"]["renames"])


def often_unread() -> dict[str, list[str]]:
    """Tags in official examples that the plugins do not read, by generation."""
    return {name: content.get("unread", []) for name, content in _content().items()}


@cache
def _plugin(generation: str, number: int) -> Plugin:
    content = _content()[generation]
    entry = content["plugins"][number]
    types: dict[str, str] = (content["ros_block"] if entry.get("ros") else {}) | entry["parameters"]
    words, others = entry.get("words", {}), entry.get("other_words", {})
    return record(
        Plugin,
        entry,
        generation=generation,
        class_name=entry.get("class", ""),
        drive=record(Drive, entry["drive"]) if "drive" in entry else None,
        parameters={
            name: _parameter(name, text, words.get(name, ()), others.get(name, ""))
            for name, text in types.items()
        },
    )


def _parameter(name: str, text: str, words: list[str], other_words: str) -> Parameter:
    """Read ``TYPE``, ``!`` if required, ``*`` if it may be repeated, ``= DEFAULT``."""
    kind, has_default, default = text.partition(" = ")
    return Parameter(
        name,
        kind.rstrip("!*"),
        "!" in kind,
        default if has_default else None,
        tuple(words),
        other_words,
    )
