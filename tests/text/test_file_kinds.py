"""What a file is, by its name, its text, or the elements in it."""

import pytest

from urdfkit.text.document import Element
from urdfkit.text.file_kinds import (
    has_srdf_tags,
    is_extension,
    is_launch,
    is_list_of_joints,
    is_xacro,
)
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml

JOINT = '<joint name="j"><parent link="a"/><child link="b"/></joint>'


def root(text: str) -> Element:
    document, _ = read_xml(Source("r.urdf", text.encode()))
    assert document is not None
    return document.root


@pytest.mark.parametrize(
    ("text", "is_semantic", "is_listed", "is_extended"),
    [
        ('<robot name="r"><link name="a"/></robot>', False, False, False),
        ('<robot name="r"><group name="arm"/></robot>', True, False, False),
        ('<robot name="r"><link name="a"/><group name="arm"/></robot>', False, False, False),
        ('<robot name="r"><joint name="j"/></robot>', False, True, False),
        (f'<robot name="r">{JOINT}</robot>', False, False, False),
        (f"<robot>{JOINT}</robot>", False, False, True),
        (f'<robot>{JOINT}<link name="a"/></robot>', False, False, False),
        ("<robot/>", False, False, False),
    ],
)
def test_what_the_elements_say(
    text: str, is_semantic: bool, is_listed: bool, is_extended: bool
) -> None:
    robot = root(text)
    found = has_srdf_tags(robot), is_list_of_joints(robot), is_extension(robot)
    assert found == (is_semantic, is_listed, is_extended)


@pytest.mark.parametrize(
    ("name", "text", "expected"),
    [
        ("r.urdf.xacro", "<robot/>", True),
        ("r.urdf", '<robot><xacro:property name="a" value="1"/></robot>', True),
        ("r.urdf", '<robot xmlns:xacro="x"><link name="${a}"/></robot>', True),
        ("r.urdf", '<robot xmlns:xacro="x"><link name="a"/></robot>', False),
        ("r.urdf", "<robot><xacro:wheel/></robot>", False),
        ("r.urdf", '<robot><!-- <xacro:property name="a"/> --></robot>', False),
    ],
)
def test_xacro_by_its_content(name: str, text: str, expected: bool) -> None:
    assert is_xacro(Source(name, text.encode())) is expected


def test_launch_files_by_their_names() -> None:
    names = ("a.launch", "a.launch.py", "a_launch.xml", "launch.py", "a.launch.json")
    assert [is_launch(name) for name in names] == [True, True, True, False, False]
