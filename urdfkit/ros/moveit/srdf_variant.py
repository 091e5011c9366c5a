"""Robots of a package that share its SRDFs and the YAML files of MoveIt next to them."""

import re
from collections import Counter
from collections.abc import Iterator
from collections.abc import Set as AbstractSet

from urdfkit.core import disk
from urdfkit.ros import RosDescription
from urdfkit.ros.moveit.srdf import Srdf, neighbours
from urdfkit.text.file_kinds import is_xacro
from urdfkit.text.source import shown
from urdfkit.workspace.file_head import read_head

#: The part of the names in an SRDF that must be unknown to a robot for it to be of another one,
#: and the part of these that the other one must know.
_UNKNOWN, _KNOWN = 0.25, 0.9
_FEWEST = 3
#: Bounds of the search for the other robot.
_MAX_DIRECTORIES, _MAX_FILES, _MAX_XACROS = 200, 60, 10
_MAX_BYTES = 4 * 1024 * 1024


def other_variant(description: RosDescription, srdf: Srdf) -> str:
    """What is wrong if the SRDF is for another variant of the robot; empty if it is not.

    That takes more than unknown names, which an outdated SRDF has, too: with a prefix
    they are those of this robot, or another robot of the package has them.
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
    others = (path for path, names in _other_robots(description) if _fits(unknown, names))
    other = next(others, "")
    return f"{reported}; they are in {shown(other)}" if other else ""


def names_of_other_robots(description: RosDescription, srdf: Srdf, names: set[str]) -> set[str]:
    """Those of some links, joints and groups that another robot with an SRDF next to this one has.

    The robots share the YAML files of MoveIt there.
    """
    others = list(neighbours(srdf, description)) if names else []
    found = {name for other in others for name in names & {*other.named, *other.groups_by_name}}
    if others and found != names:
        for _, known in _other_robots(description):
            found |= names & known
            if found == names:
                break
    return found


def _prefix(bare: set[str], prefixed: set[str]) -> str:
    """What nearly all of some names lack to be those of others."""
    begins = Counter(
        longer[:at] for longer in prefixed for at in range(1, len(longer)) if longer[at:] in bare
    )
    # Of two that fit, the shorter: each name is then a whole one.
    fitting = [begin for begin, count in begins.items() if count >= _KNOWN * len(bare)]
    return min(fitting, key=len, default="")


def _other_robots(description: RosDescription) -> Iterator[tuple[str, AbstractSet[str]]]:
    """The links and joints of the other descriptions of the package: as written, and expanded."""
    package = description.resolver.packages.enclosing(description.source.path)
    if package is None:
        return
    own = disk.real(description.source.path)
    below = description.resolver.directories.files_below(package[1], _MAX_DIRECTORIES)
    paths = [path for path in below if path.endswith((".urdf", ".xacro"))]
    robots = [path for path in paths if disk.real(path) != own and _is_robot(path)]
    xacros = 0
    for path in robots[:_MAX_FILES]:
        data = read_head(path, _MAX_BYTES)
        yield path, {name.decode("utf-8", "replace") for name in _NAME.findall(data)}
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
