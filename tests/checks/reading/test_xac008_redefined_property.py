from pathlib import Path

import pytest

from tests.naming import naming
from tests.xacros import reported, told_of, write

FIRST = '<xacro:property name="a" value="1"/>\n'
SECOND = '<xacro:property name="a" value="2"/>\n'
USE = '<link name="l${a}"/>'


def test_before_its_first_use() -> None:
    (found,) = reported("XAC008", FIRST + SECOND + USE)
    assert (found.span.line, found.span.column, found.span.text) == (3, 23, "a")
    assert found.message == naming("a", "before")
    assert [(one.span.line, one.message) for one in found.related] == [(2, "first defined here")]


@pytest.mark.parametrize(
    "body",
    [
        FIRST + USE + SECOND,
        FIRST + '<link name="m${a}"/>' + SECOND + USE,
        FIRST + '<xacro:property name="b" value="${a}"/><link name="${b}"/>' + SECOND + USE,
        FIRST + FIRST + USE,
        FIRST + SECOND.replace("value", "default") + USE,
        FIRST + f'<xacro:if value="true">{SECOND}</xacro:if>' + USE,
        (
            f'{FIRST}<xacro:macro name="m" params="">{SECOND}{USE}</xacro:macro><xacro:m/>'
            '<link name="m${a}"/>'
        ),
    ],
    ids=["used", "used twice", "used in a property", "same", "default", "conditional", "local"],
)
def test_that_is_meant(body: str) -> None:
    assert reported("XAC008", body) == []


def test_in_two_included_files(tmp_path: Path) -> None:
    robot = '<xacro:include filename="p.xacro"/><xacro:include filename="q.xacro"/>' + USE
    write(tmp_path, robot=robot, p=FIRST, q=SECOND)
    assert told_of("XAC008", tmp_path / "robot.xacro") == []


def test_in_an_included_file(tmp_path: Path) -> None:
    write(tmp_path, robot='<xacro:include filename="p.xacro"/>' + USE, p=FIRST + SECOND)
    (found,) = told_of("XAC008", tmp_path / "robot.xacro")
    assert Path(found.span.source.path).name == "p.xacro"
