import itertools

import pytest

from tests import documents
from urdfkit.robot.tree import MAX_LOOPS, KinematicTree


def tree(links: str, *joints: str) -> KinematicTree:
    """A tree of links and joints such as ``a b 0 0 1``: parent, child and height."""
    text = "".join(f'<link name="{name}"/>' for name in links.split())
    for joint in joints:
        parent, child, *xyz = joint.split()
        text += (
            f'<joint name="{parent}{child}" type="fixed"><origin xyz="{" ".join(xyz)}"/>'
            f'<parent link="{parent}"/><child link="{child}"/></joint>'
        )
    return documents.tree(f'<robot name="r">{text}</robot>')


def loops(made: KinematicTree) -> list[str]:
    return [" ".join(joint.name for joint in loop) for loop in made.cycles]


def test_roots_are_in_the_order_of_the_document() -> None:
    made = tree("c b a d", "a d")
    assert [root.name for root in made.roots] == ["c", "b", "a"]


def test_parents_come_before_children() -> None:
    made = tree("e d c b a", "a b", "b c", "a d", "d e")
    below = made.below("a")
    assert sorted(below) == list("abcde")
    assert [below.index(p) < below.index(c) for p, c in ("ab", "bc", "ad", "de")] == [True] * 4
    assert made.below("d") == ["d", "e"]


@pytest.mark.parametrize(
    ("links", "joints", "found"),
    [
        ("a b c", ("a b", "b c"), []),
        ("a b c d", ("a b", "a c", "b d", "c d"), []),
        ("a b", ("a b", "b a"), ["ab ba"]),
        ("r a b c", ("r a", "a b", "b c", "c a"), ["ab bc ca"]),
        ("a b c", ("a b", "b a", "b c", "c b"), ["ab ba", "bc cb"]),
        ("a", ("a a",), []),
        ("a", ("a x", "x a"), []),
    ],
)
def test_cycles(links: str, joints: tuple[str, ...], found: list[str]) -> None:
    assert loops(tree(links, *joints)) == found


@pytest.mark.parametrize(
    ("links", "joints", "sound"),
    [
        ("a", (), True),
        ("a b c", ("a b", "b c"), True),
        ("a b c", ("a c", "a b"), True),
        ("", (), False),
        ("a b", (), False),  # two roots
        ("a b b", ("a b", "a b"), False),  # one link twice, and one joint
        ("a b b", ("a b",), False),
        ("a b", ("a b", "a b"), False),  # two joints to one link
        ("r a b", ("a b", "b a"), False),  # a loop beside the root
        ("a b c", ("a b", "a c", "b c"), False),  # two parents
        ("a b c", ("a b", "a b"), False),  # one joint too few, one twice
        ("a b", ("a x",), False),
        ("a", ("a a",), False),
    ],
)
def test_a_sound_tree(links: str, joints: tuple[str, ...], sound: bool) -> None:
    assert tree(links, *joints).is_sound is sound


def test_loops_have_a_bound() -> None:
    names = [f"l{number}" for number in range(50)]
    back = [f"{name} l0" for name in names[1:]]
    made = tree(" ".join(names), *map(" ".join, itertools.pairwise(names)), *back)
    assert len(made.cycles) == MAX_LOOPS


def test_frames_add_up_from_the_root() -> None:
    made = tree("c b a", "a b 0 0 1", "b c 0 2 0")
    assert {name: frame.position for name, frame in made.frames.items()} == {
        "a": (0, 0, 0),
        "b": (0, 0, 1),
        "c": (0, 2, 1),
    }
