"""Maps between the joint indices of two programs."""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.ros.importers.imported import Imported, ImportedJoint


class NoIndexMap(UrdfkitError):
    """Two programs have different degrees of freedom."""


class IndexMap(Record):
    """For each degree of freedom of the target, its index in the source.

    Free roots are ignored: degrees of freedom are counted from the first joint.
    """

    #: source and target: names of the programs.
    source: str
    target: str
    joints: tuple[ImportedJoint, ...]  # for each degree of freedom of the target, in its order
    #: Indices of the same degrees of freedom in the source: ``values[indices]`` are the target's.
    indices: tuple[int, ...]


def index_map(source: Imported, target: Imported) -> IndexMap:
    """The map from the degrees of freedom of a program to those of another program.

    Raises:
        NoIndexMap: a joint is missing in a program, or has other degrees of freedom there.
    """
    first = {imported.joint.name: imported for imported in source.joints}
    _compare(source, target, first)
    start = min((imported.v for imported in source.joints), default=0)
    joints: list[ImportedJoint] = []
    indices: list[int] = []
    for imported in target.joints:
        place = first[imported.joint.name].v - start
        joints += [imported] * imported.nv
        indices += range(place, place + imported.nv)
    return IndexMap(source.facts.name, target.facts.name, tuple(joints), tuple(indices))


def _compare(source: Imported, target: Imported, first: dict[str, ImportedJoint]) -> None:
    second = {imported.joint.name: imported for imported in target.joints}
    names = source.facts.name, target.facts.name
    for have, lack, name, other_name in ((first, second, *names), (second, first, *names[::-1])):
        for joint in have:
            if joint not in lack:
                raise NoIndexMap(f"joint '{joint}' has coordinates in {name}, not in {other_name}")
    for joint, imported in first.items():
        if max(imported.nv, second[joint].nv) > 1:
            raise NoIndexMap(
                f"joint '{joint}' is {imported.joint.kind}: its {imported.nv} velocities in "
                f"{names[0]} and {second[joint].nv} in {names[1]} may have different meanings"
            )
