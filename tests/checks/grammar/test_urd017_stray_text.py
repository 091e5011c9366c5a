"""URD017: see the rule."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit import check

LINK = '<link name="arm">{}</link>'


@pytest.mark.parametrize(
    ("inside", "text", "where"),
    [
        ("<visual><origin>0 0 1</origin></visual>", "0 0 1", "origin"),
        ("<visual/>>", ">", "link"),
        ("\n  <visual/>\n  left over -->\n", "left over -->", "link"),
    ],
)
def test_text_where_urdf_has_none(inside: str, text: str, where: str) -> None:
    assert messages("URD017", LINK.format(inside)) == [naming("arm", text, f"<{where}>")]
    ((_, shown),) = places("URD017", LINK.format(inside))
    assert shown == text


def test_a_value_that_is_needed_is_missing_already() -> None:
    text = LINK.format("<inertial><mass>1</mass></inertial>")
    assert messages("URD017", text) == []
    assert any("'value'" in message for message in messages("URD003", text))


@pytest.mark.parametrize(
    "text",
    [
        LINK.format("\n  <!-- a comment -->\n"),
        LINK.format("<self_filter>soft</self_filter>"),
        "<gazebo><static>true</static></gazebo>",
        "<vendor:tag>text</vendor:tag>",
    ],
)
def test_text_of_others_is_calm(text: str) -> None:
    assert reported("URD017", text) == []


def test_text_of_an_included_file_is_reported_there(tmp_path: Path) -> None:
    head = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"'
    (tmp_path / "colours.xacro").write_text(f"{head}>\nrgb(1,2,3)\n</robot>")
    include = '<xacro:include filename="colours.xacro"/>'
    (tmp_path / "r.xacro").write_text(f'{head} name="r">{include}{LINK.format("")}</robot>')
    (found,) = check(tmp_path / "r.xacro", select=["URD017"]).diagnostics
    assert Path(found.span.source.path).name == "colours.xacro"
    assert (found.span.line, found.span.text) == (2, "rgb(1,2,3)")


def test_a_bracket_of_an_included_file_is_not_that_of_an_attribute(tmp_path: Path) -> None:
    """xArm's gripper: the file that includes it has an attribute that ends in the same way."""
    head = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"'
    (tmp_path / "gripper.xacro").write_text(f'{head}>\n<link name="gripper"/>">\n</robot>')
    include = '<xacro:include filename="gripper.xacro"/><xacro:if value="${1 > 0}">\n</xacro:if>'
    (tmp_path / "r.xacro").write_text(f'{head} name="r">{include}</robot>')
    (found,) = check(tmp_path / "r.xacro", select=["URD017"]).diagnostics
    assert Path(found.span.source.path).name == "gripper.xacro"
    assert (found.span.line, found.span.text) == (2, '">')


def test_a_macro_says_it_once(tmp_path: Path) -> None:
    body = LINK.format("oops").replace("arm", "${n}")
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        f'<xacro:macro name="m" params="n">{body}</xacro:macro>'
        '<xacro:m n="a"/><xacro:m n="b"/></robot>'
    )
    (tmp_path / "r.xacro").write_text(text)
    (found,) = check(tmp_path / "r.xacro", select=["URD017"]).diagnostics
    assert len(found.calls) == 2
    assert found.span.text == "oops"
