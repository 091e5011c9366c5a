"""Which joint of one program is which of another one."""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.ros.importers.imported import Imported, ImportedJoint


class NoIndexMap(UrdfkitError):
    """Two programs do not have the same degrees of freedom."""


class IndexMap(Record):
    """For each degree of freedom of one program, its index in another one.

    Free roots are left out: degrees of freedom are counted from the first joint.
    """

    #: source and target: names of the programs.
    source: str
    target: str
    joints: tuple[ImportedJoint, ...]  # of each degree of freedom of the target, in its order
    #: Of the same in the source: ``values[indices]`` are those of the target.
    indices: tuple[int, ...]


def index_map(source: Imported, target: Imported) -> IndexMap:
    """The map from the degrees of freedom of one program to those of another one.

    Raises:
        NoIndexMap: one has a joint that the other one lacks, or that moves in other ways there.
    """
    first = {one.joint.name: one for one in source.joints}
    _compare(source, target, first)
    start = min((one.v for one in source.joints), default=0)
    joints: list[ImportedJoint] = []
    indices: list[int] = []
    for one in target.joints:
        place = first[one.joint.name].v - start
        joints += [one] * one.nv
        indices += range(place, place + one.nv)
    return IndexMap(source.facts.name, target.facts.name, tuple(joints), tuple(indices))


def _compare(source: Imported, target: Imported, first: dict[str, ImportedJoint]) -> None:
    second = {one.joint.name: one for one in target.joints}
    names = source.facts.name, target.facts.name
    for have, lack, name, other in ((first, second, *names), (second, first, *names[::-1])):
        for joint in have:
            if joint not in lack:
                raise NoIndexMap(f"joint '{joint}' has coordinates in {name}, and none in {other}")
    for joint, one in first.items():
        if max(one.nv, second[joint].nv) > 1:
            kind = one.joint.kind
            raise NoIndexMap(
                f"joint '{joint}' is {kind}: its {one.nv} velocities in {names[0]} and "
                f"{second[joint].nv} in {names[1]} need not mean the same"
            )
