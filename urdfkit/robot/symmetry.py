"""Left/right counterparts: links and joints that are intended to be mirror images.

Authors write one side and copy it. A difference between the two is a mistake more often than an
intention, and the counterpart shows the intended value.
"""

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache

from urdfkit.core.grouping import by_key
from urdfkit.core.spatial import Rotation, Vector, vector
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Link
from urdfkit.robot.tree import KinematicTree

#: The words of a name; ``l_hip``, ``LHip``, ``hipL`` and ``FL-hip`` each have one for the side.
_WORD = r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+"

#: Words for the left side and their counterparts. Besides the plain words, the corners of a vehicle
#: or a quadruped, with the side first or last: front, rear, back, hind, middle.
_RIGHT_OF = {"left": "right", "l": "r"} | {
    left: left.replace("l", "r") for end in "frbhm" for left in (end + "l", "l" + end)
}

_SIDES = frozenset((*_RIGHT_OF, *_RIGHT_OF.values()))

_NUMBER = r"\d+"

#: Longer names are not compared: the cost is quadratic in their length.
_MAX_LENGTH = 200


def pairs(names: Iterable[str]) -> list[tuple[str, str]]:
    """Names that differ only in their side, each as (left, right), in the order of the lefts.

    A name is in one pair at most. If a name contains several sides, such as the left finger of the
    left hand, the last one that has a counterpart counts: the right finger of the left hand.
    """
    candidates = dict.fromkeys(name for name in names if len(name) <= _MAX_LENGTH)
    of_last_side = set(filter(None, map(_with_last_side, candidates))) & candidates.keys()
    paired: set[str] = set()
    result: list[tuple[str, str]] = []
    for name in candidates:
        for right in _right_names(name) if name not in of_last_side else ():
            if right in candidates and name not in paired and right not in paired:
                paired.update((name, right))
                result.append((name, right))
    return result


def _with_last_side(name: str) -> str | None:
    """The name with its last word for a side, if that is left, replaced by right."""
    sides = [word.lower() for word in re.findall(_WORD, name) if _is_side(word.lower())]
    is_left = bool(sides) and (sides[-1] in _RIGHT_OF or "left" in sides[-1])
    return _right_names(name)[0] if is_left else None


def _is_side(word: str) -> bool:
    return word in _SIDES or "left" in word or "right" in word


@lru_cache(maxsize=4096)
def _right_names(name: str) -> tuple[str, ...]:
    """The name with one of its words for left replaced by right, the last word first.

    Then with all of them: ``lf1_lf2`` is the counterpart of ``rf1_rf2``.
    """
    names: list[str] = []
    every = name
    for match in reversed(list(re.finditer(_WORD, name))):
        word = match.group()
        right = _RIGHT_OF.get(word.lower())
        if right is None and "left" in word.lower():  # leftwheel
            right = word.lower().replace("left", "right")
        if right is None:
            continue
        if word.isupper():
            right = right.upper()
        elif word[0].isupper():
            right = right.capitalize()
        names.append(name[: match.start()] + right + name[match.end() :])
        every = every[: match.start()] + right + every[match.end() :]
    return tuple(names) if len(names) < 2 else (*names, every)


def has_one_side(name: str) -> bool:
    """True for a name with one word for a side, unlike the left finger of the left hand."""
    return sum(_is_side(word.lower()) for word in re.findall(_WORD, name)) == 1


def numbered_pairs(places: Mapping[str, Vector]) -> list[tuple[str, str]]:
    """Names that differ in one number and have mirrored positions: ``wheel_1``, ``wheel_2``.

    Two positions are mirrored if their y (the lateral axis in ROS) differs only in its sign, and x
    and z are equal; if no positions of a series of names are, the same holds for x. A name is in
    one pair at most.

    Args:
        places: positions in m, in a frame with the plane of symmetry as one of its coordinate
            planes: the parent link for joints, the root link for links. Compared to the
            micrometre.
    """
    by_affixes: dict[tuple[str, str], list[str]] = {}
    for name in places:
        if len(name) > _MAX_LENGTH:
            continue
        for match in re.finditer(_NUMBER, name):
            by_affixes.setdefault((name[: match.start()], name[match.end() :]), []).append(name)
    taken: set[str] = set()
    result: list[tuple[str, str]] = []
    for (before, after), series in by_affixes.items():
        numbers = [int(name[len(before) : len(name) - len(after)]) for name in series]
        if max(numbers) - min(numbers) >= 2 * len(set(numbers)):
            continue  # product names: the grippers RG2 and RG6
        free = {name: places[name] for name in series if name not in taken}
        mirrored = _mirrored(free, 1) or _mirrored(free, 0)
        result += mirrored
        taken.update(name for pair in mirrored for name in pair)
    return result


def joint_pairs(tree: KinematicTree) -> list[tuple[Joint, Joint]]:
    """The moving joints that are intended to be mirror images, the left one first.

    They are paired by their names, or by numbers and mirrored positions on one link. Their links
    are on different branches.
    """
    above = {
        child: (joints[0], joints[0].parent_name)
        for child, joints in tree.parents.items()
        if joints
    }
    children: dict[str, str] = {}  # child links of moving joints
    siblings: dict[str, dict[str, Vector]] = {}
    for child, (joint, parent) in above.items():
        if joint.is_single_dof and joint.name:
            children[joint.name] = child
            siblings.setdefault(parent, {})[joint.name] = joint.origin.position
    names = pairs(children)
    taken = {name for pair in names for name in pair}
    for places in siblings.values():
        free = {name: place for name, place in places.items() if name not in taken}
        names += numbered_pairs(free) if len(free) > 1 else []
    links = [(children[a], children[b]) for a, b in names]
    separate = on_separate_branches(links, {child: parent for child, (_, parent) in above.items()})
    return [(above[a][0], above[b][0]) for a, b in separate]


def are_copies(one: Link | None, other: Link | None) -> bool:
    """True for two links with the same meshes: both sides have the same product, such as an arm.

    They are not mirror images. A part that is turned over in the frame of its link, to fit the
    other side, is no copy.
    """
    meshes = _visual_meshes(one)
    return bool(meshes) and meshes == _visual_meshes(other)


def _visual_meshes(link: Link | None) -> list[tuple[str, Vector, Rotation]]:
    """The meshes of the visuals with scale and rotation, also those that do not exist."""
    return [
        (body.file.value, body.shape.scale, _rounded(body.origin.rotation))
        for body in (link.visuals if link else ())
        if body.shape and body.file
    ]


def _rounded(rotation: Rotation) -> Rotation:
    x, y, z = (vector(round(part, 2) + 0.0 for part in row) for row in rotation)
    return x, y, z


def on_separate_branches(
    pairs: Iterable[tuple[str, str]], parents: Mapping[str, str]
) -> list[tuple[str, str]]:
    """The pairs of links of which neither is an ancestor of the other.

    Links of one chain are not counterparts, whatever their names: the axes ``l`` and ``r`` of some
    industrial arms.

    Args:
        parents: the parent of each link that has one.
    """
    spans = _spans(parents)
    separate: list[tuple[str, str]] = []
    for pair in pairs:
        first, second = (spans.get(name) for name in pair)
        if first and second and not (_contains(first, second) or _contains(second, first)):
            separate.append(pair)
    return separate


def _contains(outer: tuple[int, int], inner: tuple[int, int]) -> bool:
    return outer[0] <= inner[0] and inner[1] <= outer[1]


def _spans(parents: Mapping[str, str]) -> dict[str, tuple[int, int]]:
    """For each link of a tree, the range of the numbers of its descendants.

    Links are numbered in depth-first order, so that a link is a descendant if its range is within
    the range of the other. Links in a cycle are omitted.
    """
    children = by_key((parent, child) for child, parent in parents.items())
    entered: dict[str, int] = {}
    spans: dict[str, tuple[int, int]] = {}
    stack = [name for name in children if name not in parents]
    while stack:
        name = stack[-1]
        if name not in entered:
            entered[name] = len(entered)
            stack += children.get(name, ())
        else:
            stack.pop()
            spans[name] = (entered[name], len(entered))
    return spans


def _mirrored(places: Mapping[str, Vector], axis: int) -> list[tuple[str, str]]:
    """Pairs of positions that differ only in the sign of one coordinate."""
    waiting: dict[tuple[float, ...], str] = {}
    result: list[tuple[str, str]] = []
    for name, place in places.items():
        key = tuple(round(value, 6) for value in place)
        image = (*key[:axis], -key[axis], *key[axis + 1 :])
        if key[axis] and image in waiting:
            result.append((waiting.pop(image), name))
        else:
            waiting.setdefault(key, name)
    return result
