"""Links and joints that are called otherwise, and those that are others."""

import re
from pathlib import Path

import pytest

from tests.conftest import CORPUS, MODELS, needs_corpus
from tests.documents import model
from urdfkit import load
from urdfkit.output.comparison.differences import Tolerances, differences
from urdfkit.output.comparison.renames import renames
from urdfkit.robot.model import RobotModel

GRIPPER = (MODELS / "good" / "gripper.urdf").read_text(encoding="utf-8")
#: Two sensors at one place, as frames are.
FRAMES = """\
<robot name="r">
  <link name="base"/><link name="a"/><link name="b"/>
  <joint name="ja" type="fixed"><parent link="base"/><child link="a"/></joint>
  <joint name="jb" type="fixed"><parent link="base"/><child link="b"/></joint>
</robot>
"""


def called(before: str, *changes: tuple[str, str]) -> tuple[dict[str, str], dict[str, str]]:
    """The links and joints that have other names after some changes of a text."""
    after = before
    for old, new in changes:
        assert old in after
        after = after.replace(old, new)
    found = renames(model(before), model(after), Tolerances())
    return dict(found.links), dict(found.joints)


def texts(before: RobotModel, after: RobotModel) -> list[str]:
    allowed = Tolerances()
    return list(map(str, differences(before, after, allowed, renames(before, after, allowed))))


def test_a_renamed_link_is_no_other_difference() -> None:
    """Neither of the joints at it nor of what follows them."""
    after = GRIPPER.replace('"palm"', '"hand"').replace('"left_finger_joint"', '"left"')
    assert texts(model(GRIPPER), model(after)) == [
        "link 'palm': renamed to 'hand'",
        "joint 'left_finger_joint': renamed to 'left'",
    ]


def test_what_else_became_of_a_renamed_link_is_reported_under_its_new_name() -> None:
    after = GRIPPER.replace('"palm"', '"hand"').replace('<mass value="0.5"/>', '<mass value="1"/>')
    sentences = texts(model(GRIPPER), model(after))
    assert "link 'palm': renamed to 'hand'" in sentences  # its place and children are as before
    assert "link 'hand': mass 0.5 kg -> 1 kg" in sentences


@pytest.mark.parametrize("what", ["link", "joint"])
def test_all_names_with_a_prefix(what: str) -> None:
    quoted = {"link": r'(?<=link name=")|(?<=link=")', "joint": r'(?<=joint name=")|(?<=joint=")'}
    before = model(GRIPPER)
    found = renames(before, model(re.sub(quoted[what], "new_", GRIPPER)), Tolerances())
    names = before.links_by_name if what == "link" else before.joints_by_name
    expected = {name: f"new_{name}" for name in names}
    assert (found.links if what == "link" else found.joints) == expected
    assert not (found.joints if what == "link" else found.links)


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ([('"a"', '"c"')], {"a": "c"}),
        ([('"a"', '"c"'), ('"b"', '"d"')], {"a": "c", "b": "d"}),  # their joints are as before
        ([('"a"', '"c"'), ('"ja"', '"jc"')], {"a": "c"}),  # the other one is still there
        ([('"a"', '"c"'), ('"ja"', '"jc"'), ('"b"', '"d"'), ('"jb"', '"jd"')], {}),
    ],
)
def test_what_could_be_meant_in_two_ways_is_not_guessed(
    changes: list[tuple[str, str]], expected: dict[str, str]
) -> None:
    links, _ = called(FRAMES, *changes)
    assert links == expected


@pytest.mark.parametrize(
    "changes",
    [
        [('"ja" type="fixed"', '"jc" type="floating"')],
        [('<joint name="ja" type="fixed">', '<joint name="jc" type="fixed"><origin xyz="1 0 0"/>')],
        [('"ja" type="fixed"><parent link="base"', '"ja" type="fixed"><parent link="b"')],
    ],
    ids=["by another joint", "elsewhere", "on another link"],
)
def test_another_link_is_new(changes: list[tuple[str, str]]) -> None:
    assert called(FRAMES, *changes, ('"a"', '"c"')) == ({}, {})


@needs_corpus
@pytest.mark.parametrize(
    "path",
    [
        "anymal_c_simple_description/urdf/anymal.urdf",
        "moveit_resources/panda_description/urdf/panda.urdf",
    ],
)
def test_every_link_of_a_real_robot_is_known_again(path: str, tmp_path: Path) -> None:
    """With a new name, alone, it is found; its old name is that of no other link."""
    text = (CORPUS / path).read_text(encoding="utf-8")
    before = load(CORPUS / path)
    for name in list(before.links_by_name)[:12]:
        after = model(re.sub(rf'(?<=link name="){name}(?=")|(?<=link="){name}(?=")', "other", text))
        assert dict(renames(before, after, Tolerances()).links) == {name: "other"}
