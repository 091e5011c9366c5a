"""Configurations of Cartographer: files of Lua, which the command line of its node names.

Source: ``trajectory_options.cc``, ``node_options.cc`` and ``node.cc`` of cartographer_ros.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from itertools import pairwise

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.ros.launch.contents import StartedProgram, Word
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

CARTOGRAPHER = "cartographer_ros/cartographer_node"
_DIRECTORY, _NAME = "-configuration_directory", "-configuration_basename"
#: The options without which the node stops.
REQUIRED = frozenset({_DIRECTORY.lstrip("-"), _NAME.lstrip("-")})
_COMMENT = re.compile(rb"--[^\n]*")
_TABLE = re.compile(rb"\boptions\s*=\s*\{")
_INNER = re.compile(rb"\{[^{}]*\}")
# A search that begins within a word would take quadratic time.
_OPTION = re.compile(rb"(?<!\w)(\w+)\s*=\s*(?:\"([^\"\n]*)\"|([\w.+-]+))?")
_INCLUDE = re.compile(rb"\binclude[\s(]*[\"']([^\"']+)")
#: Files that come with Cartographer.
_SHIPPED = re.compile(
    rb"(map_builder|trajectory_builder(_[23]d)?|pose_graph|map_builder_server)\.lua"
)
#: The messages of the numbered inputs.
_NUMBERED = {
    "num_laser_scans": ("scan", "LaserScan"),
    "num_multi_echo_laser_scans": ("echoes", "MultiEchoLaserScan"),
    "num_point_clouds": ("points2", "PointCloud2"),
}
_SWITCHED = {"use_odometry": ("odom", "Odometry"), "use_nav_sat": ("fix", "NavSatFix")}


class Option(Record):
    """A value in a table of Lua."""

    text: str
    span: Span
    name_span: Span


class CartographerConfiguration(Record):
    """The configuration of a node."""

    program: StartedProgram
    directory: str  # its path
    name: Word  # of the file
    source: Source | None  # None if there is no such file in the directory
    table: Span | None  # where the options begin; None if they are not a table in the file
    options: dict[str, Option]  # known values, by name
    is_whole: bool  # True if nothing else sets options

    @property
    def inputs(self) -> Iterator[tuple[str, str]]:
        """The topics that the node reads, before remapping, and their messages."""
        for name, (topic, message) in _NUMBERED.items():
            option = self.options.get(name)
            count = int(option.text) if option and option.text.isdigit() else 0
            numbered = [f"{topic}_{number + 1}" for number in range(min(count, 9))]
            for one in numbered if count > 1 else [topic] * count:
                yield one, message
        for name, (topic, message) in _SWITCHED.items():
            if (option := self.options.get(name)) and option.text == "true":
                yield topic, message


def configurations(
    programs: Iterable[StartedProgram], resolver: Resolver
) -> Iterator[CartographerConfiguration]:
    """The configurations whose directories are known."""
    for program in programs:
        words = {flag.text: word for flag, word in pairwise(program.words)}
        directory, name = words.get(_DIRECTORY), words.get(_NAME)
        if program.key != CARTOGRAPHER or directory is None or name is None:
            continue
        if directory.text and name.text and disk.is_directory(directory.text):
            source = resolver.readable(os.path.join(directory.text, name.text))
            yield _read(program, directory.text, name, source)


def _read(
    program: StartedProgram, directory: str, name: Word, source: Source | None
) -> CartographerConfiguration:
    unread = CartographerConfiguration(program, directory, name, source, None, {}, False)
    if source is None:
        return unread
    text = _COMMENT.sub(_blank, source.data)
    start = _TABLE.search(text)
    if start is None:
        return unread
    rest = _INNER.sub(_blank, text[start.end() :])
    table, closing, after = rest.partition(b"}")
    base = start.end()
    options = {
        match[1].decode(): Option(
            (match[2] if match[2] is not None else match[3] or b"").decode("utf-8", "replace"),
            _span(source, match, 2 if match[2] is not None else 3, base),
            _span(source, match, 1, base),
        )
        for match in _OPTION.finditer(table)
    }
    is_known = all(map(_SHIPPED.fullmatch, _INCLUDE.findall(text)))
    is_whole = bool(closing) and is_known and not re.search(rb"\boptions\s*[.\[]", after)
    table_span = Span(source, start.start(), start.start() + len("options"))
    return CartographerConfiguration(
        program, directory, name, source, table_span, options, is_whole
    )


def _blank(match: re.Match[bytes]) -> bytes:
    return b" " * len(match[0])


def _span(source: Source, match: re.Match[bytes], group: int, base: int) -> Span:
    start, end = match.span(group)
    return Span(source, base + max(start, 0), base + max(end, 0))
