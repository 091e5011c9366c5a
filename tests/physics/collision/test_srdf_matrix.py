"""The matrix in SRDF: written, updated, compared."""

from pathlib import Path
from xml.etree import ElementTree

import pytest

pytest.importorskip("coal")

from tests.physics.collision.robots import robot
from urdfkit.lint.loading import read
from urdfkit.physics.collision.matrix import Matrix, PairResult, PairVerdict
from urdfkit.physics.collision.sampling import collisions
from urdfkit.physics.collision.srdf_matrix import compare, new_srdf, srdf_edits
from urdfkit.physics.collision.worker_pool import CollisionError
from urdfkit.physics.poses import pose
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.ros.moveit.srdf_reader import read as read_srdf
from urdfkit.text.editing.apply import apply_edits
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml


def matrix(*pairs: tuple[str, str, PairVerdict], robot: str = "r") -> Matrix:
    results = tuple(PairResult(*pair, True, 0.1, None) for pair in pairs)
    return Matrix(robot, (), results, 10, 10, 10, 0, (), (), {}, False)


MATRIX = matrix(
    ("a", "b", PairVerdict.ADJACENT),
    ("a", "c", PairVerdict.NEVER),
    ("a", "d", PairVerdict.SOMETIMES),
    ("b", "d", PairVerdict.DEFAULT),
    ("c", "d", PairVerdict.UNKNOWN),
)


def source(text: str) -> Source:
    return Source("r.srdf", text.encode())


def updated(text: str) -> bytes:
    before = source(text)
    return apply_edits(before.data, srdf_edits(MATRIX, before))


def reasons(data: bytes) -> dict[tuple[str, str], str]:
    found = ElementTree.fromstring(data).iter("disable_collisions")
    return {(one.attrib["link1"], one.attrib["link2"]): one.get("reason", "") for one in found}


def test_a_new_file_holds_the_pairs_that_need_not_be_checked() -> None:
    assert reasons(new_srdf(MATRIX)) == {
        ("a", "b"): "Adjacent",
        ("a", "c"): "Never",
        ("b", "d"): "Default",
    }
    assert ElementTree.fromstring(new_srdf(MATRIX)).attrib == {"name": "r"}


def test_names_are_escaped() -> None:
    odd = matrix(('a"<&', "b", PairVerdict.ALWAYS), robot='r"<&')
    assert reasons(new_srdf(odd)) == {('a"<&', "b"): "Always"}


OLD = """<?xml version="1.0"?>
<!-- mine -->
<robot name="r">
    <group name="arm"><chain base_link="a" tip_link="d"/></group>
    <!-- the matrix -->
    <disable_collisions link1="b" link2="a" reason="Adjacent" />
    <disable_collisions link1="a" link2="d" reason="Never"/>
    <disable_collisions link1="b" link2="d" reason="Never"/>
    <disable_collisions link1="c" link2="d" reason="Never"/> <!-- cannot be measured -->
    <disable_collisions link1="x" link2="y" reason="Never"/>
    <disable_collisions link1="b" link2="c" reason="User"/>
    <end_effector name="e" parent_link="d" group="arm"/>
</robot>
"""


def test_what_is_there_stays() -> None:
    new = updated(OLD).decode()
    assert new == (
        OLD.replace('    <disable_collisions link1="a" link2="d" reason="Never"/>\n', "")
        .replace('"b" link2="d" reason="Never"', '"b" link2="d" reason="Default"')
        .replace(
            'reason="User"/>\n',
            'reason="User"/>\n    <disable_collisions link1="a" link2="c" reason="Never"/>\n',
        )
    )
    assert updated(new).decode() == new


def test_a_pair_that_a_person_disabled_stays_so() -> None:
    text = '<robot name="r"><disable_collisions link1="d" link2="a" reason="User"/></robot>'
    assert reasons(updated(text))["d", "a"] == "User"
    text = '<robot name="r"><disable_collisions link1="d" link2="a"/></robot>'
    assert ("d", "a") in reasons(updated(text))


@pytest.mark.parametrize(
    "text",
    [
        '<robot name="r"/>',
        '<robot name="r"></robot>',
        '<robot name="r">\r\n  <group name="g"/>\r\n</robot>\r\n',
        "<!-- a --><robot><group name='g'/></robot>",
    ],
)
def test_a_file_without_a_matrix_gets_one(text: str) -> None:
    new = updated(text)
    assert reasons(new) == reasons(new_srdf(MATRIX))
    assert (b"\r\n" in new) == ("\r\n" in text)
    assert new.count(b"\n") == new.count(b"\r\n") or b"\r" not in new


@pytest.mark.parametrize("text", ["", "<robot", "<sdf/>", "<html></html>"])
def test_what_is_no_srdf_is_not_touched(text: str) -> None:
    with pytest.raises(CollisionError, match="is not an SRDF file"):
        updated(text)


def test_a_xacro_is_not_touched() -> None:
    text = '<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:include filename="x"/></robot>'
    with pytest.raises(CollisionError, match="is a xacro"):
        updated(text)


def compared(text: str) -> tuple[list[str], list[str], int]:
    document, _ = read_xml(source(text))
    assert document is not None
    found = compare(MATRIX, Srdf("r.srdf", document.root, robot().tree))
    return (
        [one.first + one.second for one in found.hidden],
        [one.first + one.second for one in found.watched],
        found.agreed,
    )


def test_what_differs_is_reported() -> None:
    assert compared(OLD) == (["ad"], ["ac"], 2)
    assert compared('<robot name="r"/>') == ([], ["ab", "ac"], 0)


def test_a_link_may_be_passed_over_altogether() -> None:
    """As of MoveIt 2.5: disabled for all pairs of a link, unless enabled again."""
    text = '<disable_default_collisions link="a"/><enable_collisions link1="a" link2="c"/>'
    assert compared(f'<robot name="r">{text}</robot>') == (["ad"], ["ac"], 1)


@pytest.mark.parametrize(
    ("frequency", "need_not_be"), [(0.0, False), (0.49, False), (0.5, True), (None, True)]
)
def test_who_checks_what_seldom_collides_is_right(
    frequency: float | None, need_not_be: bool
) -> None:
    """Though it does where the robot begins."""
    pair = PairResult("a", "b", PairVerdict.DEFAULT, True, frequency, None)
    document, _ = read_xml(source('<robot name="r"/>'))
    assert document is not None
    found = compare(matrix()._replace(pairs=(pair,)), Srdf("r.srdf", document.root, robot().tree))
    assert found.watched == ((pair,) if need_not_be else ())
    assert pair.is_seldom != need_not_be


# --- the robots of MoveIt's resources, whose SRDF the Setup Assistant wrote


def test_the_fanuc_matrix_is_the_one_that_it_comes_with(corpus: Path) -> None:
    directory = corpus / "moveit_resources"
    fanuc = read(directory / "fanuc_description" / "urdf" / "fanuc.urdf")
    srdf = read_srdf(str(directory / "fanuc_moveit_config" / "config" / "fanuc.srdf"), fanuc)
    assert srdf is not None
    found = collisions(fanuc)
    assert {one.verdict for one in found.pairs} == {
        PairVerdict.ADJACENT,
        PairVerdict.NEVER,
        PairVerdict.SOMETIMES,
    }
    expected = {pair: one.get("reason") for pair, one in srdf.disabled.items()}
    assert expected == {
        frozenset((one.first, one.second)): one.verdict.reason
        for one in found.pairs
        if one.verdict.reason
    }


def test_the_panda_matrix_differs_in_what_can_be_shown(corpus: Path) -> None:
    """The hand reaches below the second link: a collision that the Setup Assistant missed.

    The SRDF that it comes with was made in its ready pose; where all joints are at 0 the hand
    and link 7 are folded into link 5, and the Setup Assistant would disable these pairs.
    """
    directory = corpus / "moveit_resources"
    panda = read(directory / "panda_description" / "urdf" / "panda.urdf")
    path = str(directory / "panda_moveit_config" / "config" / "panda.srdf")
    srdf = read_srdf(path, panda)
    assert srdf is not None
    found = collisions(panda, begin=pose(panda, name=f"{path}:ready"))
    mine = {frozenset((one.first, one.second)): one for one in found.pairs}
    theirs = {pair: one.get("reason") for pair, one in srdf.disabled.items()}
    differences = {
        pair: (theirs.get(pair, ""), one.verdict.reason)
        for pair, one in mine.items()
        if theirs.get(pair, "") != one.verdict.reason
    }
    assert differences == {frozenset(("panda_link2", "panda_link6")): ("Never", "")}
    (hidden,) = compare(found, srdf).hidden
    assert hidden.nearest is not None
    assert hidden.nearest.distance < -1e-3
    assert len(theirs) == 34

    at_zero = {
        frozenset((o.first, o.second)): o.verdict for o in collisions(panda, samples=0).pairs
    }
    folded = [pair for pair, one in at_zero.items() if one is PairVerdict.DEFAULT]
    assert sorted(map(sorted, folded)) == [
        ["panda_hand", "panda_link5"],
        ["panda_leftfinger", "panda_rightfinger"],
        ["panda_link5", "panda_link7"],
    ]
