"""Robots of a package that share its SRDFs and MoveIt's YAML files."""

import re
from collections import Counter
from collections.abc import Iterator
from collections.abc import Set as AbstractSet
from itertools import chain, combinations

from urdfkit.core import disk
from urdfkit.core.grouping import by_key
from urdfkit.ros import RosDescription
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.ros.moveit.srdf_reader import neighbours
from urdfkit.text.file_kinds import is_xacro
from urdfkit.text.source import shown
from urdfkit.workspace.file_head import read_head

#: Least part of the names in an SRDF that a robot lacks if the SRDF is for another robot, and
#: least part of these names that the other robot has.
_UNKNOWN, _KNOWN = 0.25, 0.9
_FEWEST = 3
#: Most frequent prefixes that are tried.
_MAX_PREFIXES = 4
#: Bounds of the search for the other robot.
_MAX_DIRECTORIES, _MAX_FILES, _MAX_XACROS = 200, 60, 10
_MAX_BYTES = 4 * 1024 * 1024


def other_variant(description: RosDescription, srdf: Srdf) -> str:
    """The problem if the SRDF is for another variant of the robot; empty if it is not.

    Unknown names alone could be those of an outdated SRDF: with a prefix they must be names of
    this robot, or another robot of the package must have them.
    """
    unknown = srdf.unknown
    if len(unknown) < max(_FEWEST, _UNKNOWN * len(srdf.named)):
        return ""
    known = srdf.known("link") | srdf.known("joint")
    reported = f"{len(unknown)} of {len(srdf.named)} names in the SRDF are not in this robot"
    prefix = _prefix(unknown, known)
    if prefix:
        return f"{reported}, whose names begin with '{prefix}'"
    prefix = _prefix(known - srdf.named, unknown)
    if prefix:
        return f"{reported}; they begin with '{prefix}'"
    if len(unknown) >= _KNOWN * len(srdf.named) and (prefixes := _prefixes(known, unknown)):
        begins = " or ".join(f"'{prefix}'" for prefix in prefixes)
        return f"{reported}; they begin with {begins}"
    others = (path for path, names in _other_robots(description) if _fits(unknown, names))
    other = next(others, "")
    return f"{reported}; they are in {shown(other)}" if other else ""


def names_of_other_robots(description: RosDescription, srdf: Srdf, names: set[str]) -> set[str]:
    """The names of links, joints and groups that another robot with an SRDF in the directory has.

    These robots share MoveIt's YAML files.
    """
    others = list(neighbours(srdf, description)) if names else []
    found = {name for other in others for name in names & {*other.named, *other.groups_by_name}}
    if others and found != names:
        for _, known in _other_robots(description):
            found |= names & known
            if found == names:
                break
    return found


def names_of_namesakes(description: RosDescription) -> set[str]:
    """The names that the xacros with the file name of a plain URDF beside it contain.

    MoveIt may read the xacro, and the URDF be an older output of it.
    """
    path = description.source.path
    if not path.endswith(".urdf"):
        return set()
    xacros = (path + ".xacro", path.removesuffix(".urdf") + ".xacro")
    return {name for xacro in xacros if disk.is_file(xacro) for name in _written_names(xacro)}


def _written_names(path: str) -> set[str]:
    """The names of the links and joints in the text of a file, unexpanded."""
    data = read_head(path, _MAX_BYTES)
    return {name.decode("utf-8", "replace") for name in _NAME.findall(data)}


def _prefix(bare: AbstractSet[str], prefixed: AbstractSet[str]) -> str:
    """The prefix that turns nearly all ``bare`` names into ``prefixed`` names."""
    begins = Counter(
        longer[:at] for longer in prefixed for at in range(1, len(longer)) if longer[at:] in bare
    )
    # The shorter of two fitting prefixes, so that each name is complete.
    fitting = [begin for begin, count in begins.items() if count >= _KNOWN * len(bare)]
    return min(fitting, key=len, default="")


def _prefixes(known: AbstractSet[str], unknown: AbstractSet[str]) -> tuple[str, ...]:
    """One or two prefixes, as of two arms, with which nearly all names are those of a robot."""
    made = by_key(
        (name[:at], name) for name in unknown for at in range(1, len(name)) if name[at:] in known
    )
    most = sorted(made, key=lambda prefix: (-len(made[prefix]), len(prefix)))[:_MAX_PREFIXES]
    for prefixes in chain(combinations(most, 1), combinations(most, 2)):
        if len({name for prefix in prefixes for name in made[prefix]}) >= _KNOWN * len(unknown):
            return tuple(sorted(prefixes))
    return ()


def _other_robots(description: RosDescription) -> Iterator[tuple[str, AbstractSet[str]]]:
    """Links and joints of the other robots of the package: unexpanded, and expanded."""
    package = description.resolver.packages.enclosing(description.source.path)
    if package is None:
        return
    own = disk.real(description.source.path)
    below = description.resolver.directories.files_below(package[1], _MAX_DIRECTORIES)
    paths = [path for path in below if path.endswith((".urdf", ".xacro"))]
    robots = [path for path in paths if disk.real(path) != own and _is_robot(path)]
    xacros = 0
    for path in robots[:_MAX_FILES]:
        yield path, _written_names(path)
        if xacros < _MAX_XACROS and is_xacro(description.resolver.read(path)):
            xacros += 1
            yield path, description.names_in_robot(path)


_NAME = re.compile(rb"""<(?:link|joint)\b[^<>]*?\bname\s*=\s*["']([^"'<>]*)""")
_ROBOT = re.compile(rb"<robot\b[^<>]*\bname\s*=")


def _is_robot(path: str) -> bool:
    return not path.endswith((".srdf.xacro", ".sdf.xacro")) and bool(
        _ROBOT.search(read_head(path, 20_000))
    )


def _fits(names: set[str], known: AbstractSet[str]) -> bool:
    return len(names & known) >= _KNOWN * len(names)
