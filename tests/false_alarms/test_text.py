"""Texts that are no XML: what is said of them, and what mends them."""

import pytest

from tests.naming import naming
from tests.reported import fixed, reported
from urdfkit import Source, check

ROBOT = '<robot name="r">\n{}<link name="a"/>\n</robot>\n'


@pytest.mark.parametrize(
    ("comment", "mended"),
    [
        ("<!-- roslaunch --wait --screen -->", "<!-- roslaunch - -wait - -screen -->"),
        ("<!------ sensors ------>", "<!--==== sensors ====-->"),
        ("<!-- a ---->", "<!-- a ==-->"),
        ("<!-- a --->", "<!-- a -->"),
        ("<!-- a\n---\nb -->", "<!-- a\n===\nb -->"),
    ],
)
def test_hyphens_in_a_comment_are_named_and_fixed(comment: str, mended: str) -> None:
    robot = ROBOT.format(comment).encode()
    (found,) = reported("XML001", robot)
    assert found.span.source.data[found.span.start :].startswith(b"-")
    assert found.fix is not None
    assert fixed("XML001", robot.decode()) == ROBOT.format(mended)
    assert check(Source("r.urdf", ROBOT.format(mended).encode()), select=["XML"]).ok


@pytest.mark.parametrize(
    "comments",
    [
        '<!-- the base -> <link name="b"/> <!-- its end -->',
        '<!-- the base -- > <link name="b"/> <!-- its end -->',
        '<!-- off: <link name="b"/> <!-- its end --> <link name="c"/> -->',
    ],
)
def test_a_comment_in_a_comment_has_no_fix(comments: str) -> None:
    """Whether the elements in it are commented out, only its author knows."""
    robot = ROBOT.format(comments).encode()
    (found,) = reported("XML001", robot)
    assert (found.span.start, found.span.text) == (robot.rindex(b"<!--"), "<!--")
    assert found.related[0].span.start == robot.index(b"<!--")
    assert found.fix is None


@pytest.mark.parametrize(("count", "what"), [(1, ["NUL byte"]), (7, ["7", "NUL bytes"])])
def test_nul_bytes_are_one_finding(count: int, what: list[str]) -> None:
    (found,) = reported("XML001", ROBOT.format("").encode() + count * b"\0")
    assert found.message == naming(*what)
    assert (found.span.line, found.span.column) == (4, 1)
    assert found.help.startswith("remove")


@pytest.mark.parametrize(("text", "severity"), [("## link", "info"), ("0 0 1", "warning")])
def test_a_comment_in_the_style_of_another_language(text: str, severity: str) -> None:
    (found,) = reported("URD017", ROBOT.format(text).encode())
    assert found.severity.value == severity


@pytest.mark.parametrize(("name", "count"), [("mesh.xacro", 0), ("", 1)])
def test_a_first_value_that_a_missing_include_may_use(name: str, count: int) -> None:
    """DAVE's vehicles: the macros between the two are in a package that is not there."""
    include = f'<xacro:include filename="{name}"/>' if name else ""
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:property name="mesh" value="a.dae"/>'
        f'{include}<xacro:property name="mesh" value="b.dae"/><link name="${{mesh}}"/></robot>'
    )
    assert len(reported("XAC008", text.encode(), "robot.xacro")) == count


@pytest.mark.parametrize(("name", "count"), [("calibration.xacro", 0), ("", 1)])
def test_a_block_that_a_missing_include_may_define(name: str, count: int) -> None:
    """hector_models: the calibration of the lidar is in a package that is not there."""
    include = f'<xacro:include filename="{name}"/>' if name else ""
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        f'{include}<link name="a"/><xacro:insert_block name="calibration"/></robot>'
    )
    found = [one.message for one in reported("XAC001", text.encode(), "robot.xacro")]
    assert sum("block 'calibration'" in message for message in found) == count


def test_a_tag_that_is_cut_off_is_one_mistake() -> None:
    """An editor that died: `<xacro:arg name="is_sim" defaul`, and the next line."""
    found = reported("XML001", ROBOT.format('<arg name="sim" defaul\n<arg name="a"/>').encode())
    assert [one.message for one in found] == [naming("attribute", "defaul")]


@pytest.mark.parametrize("name", ["robot.urdf", "robot.xacro"])
def test_a_declaration_that_is_commented_out(name: str) -> None:
    """human2humanoid: the declaration of a SolidWorks export became its first comment."""
    text = b'<!-- <?xml version="1.0"?> -->\n<robot name="r"><link name="a"/></robot>'
    assert reported("XML", text, name) == []


def test_a_space_in_the_declaration_is_one_mistake() -> None:
    """vigir_atlas_common: the second mistake was that the declaration is text."""
    found = reported("XML001", b'<? xml version="1.0"?>\n<robot name="r"><link name="a"/></robot>')
    assert [(one.span.start, one.span.end) for one in found] == [(0, 22)]
