from __future__ import annotations

from pathlib import Path

import pytest

from tests.xacros import codes, reported, told_of, write

ARM = '<xacro:macro name="arm" params="side"><link name="${side}"/></xacro:macro>\n'
BASE = '<link name="base"/>'


def test_never_called() -> None:
    (found,) = reported("XAC005", ARM + BASE)
    assert (found.span.line, found.span.column) == (2, 1)
    assert found.span.text == '<xacro:macro name="arm" params="side">'
    assert found.message == "macro 'arm' is never called"


@pytest.mark.parametrize(
    "call",
    [
        '<xacro:arm side="l"/>',
        '<xacro:if value="false"><xacro:arm side="l"/></xacro:if>',
        '<xacro:macro name="x" params=""><xacro:arm side="l"/></xacro:macro><xacro:x/>',
        '<xacro:call macro="arm" side="l"/>',
    ],
)
def test_called(call: str) -> None:
    assert reported("XAC005", ARM + BASE + call) == []


def test_called_without_its_prefix_is_another_finding() -> None:
    assert codes(f'{ARM}{BASE}<arm side="l"/>') == ["XAC002"]


def test_of_a_library() -> None:
    assert reported("XAC005", ARM) == []


def test_a_file_that_includes_this_one_may_call_it(tmp_path: Path) -> None:
    write(tmp_path, robot=ARM + BASE)
    assert len(told_of("XAC005", tmp_path / "robot.xacro")) == 1
    write(tmp_path, big='<xacro:include filename="robot.xacro"/><xacro:arm side="l"/>')
    assert told_of("XAC005", tmp_path / "robot.xacro") == []
    assert told_of("XAC005", tmp_path / "big.xacro") == []
