"""XAC022: see the rule."""

from __future__ import annotations

import pytest

from tests.xacros import marked, reported
from urdfkit import expand
from urdfkit.text.source import Source


@pytest.mark.parametrize(
    "expression", ["2^3", "10^-3", "n ^ 2", "(n + 1)^2 * 3", "1 if n > 3 else n^4"]
)
def test_an_integer_exponent(expression: str) -> None:
    body = f'<xacro:property name="n" value="2"/>\n<link name="a${{{expression}}}"/>'
    found = reported("XAC022", body)
    message = f"the ^ in {expression} is an exclusive or, and no power"
    assert [one.message for one in found] == [message]
    assert marked(found) == [(3, f"${{{expression}}}")]


@pytest.mark.parametrize(
    "body",
    [
        '<link name="a${2**3}"/>',
        '<link name="a${True ^ False}"/>',
        '<xacro:property name="n" value="2"/><link name="a${n ^ n}"/>',
        '<link name="a${6 ^ 1}"/>',
        "<!-- ${2^3} --><link name='a'/>",
        "<link name='a^2'/>",
        "<xacro:macro name='m' params='a:=^|2'><link name='${a}'/></xacro:macro><xacro:m/>",
        "<link name=\"a${'^'}\"/>",
    ],
)
def test_what_is_no_power(body: str) -> None:
    assert reported("XAC022", body) == []


def test_every_sign_of_an_expression_is_mended() -> None:
    (found,) = reported("XAC022", '<link name="a${2^3 + 3^2}"/>')
    assert found.fix is not None
    assert [edit.span.text for edit in found.fix.edits] == ["^", "^"]
    assert not found.fix.safe


def test_xacro_takes_it_for_an_exclusive_or() -> None:
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="${2^3}"/></robot>'
    )
    assert '<link name="1"/>' in expand(Source("r.xacro", text.encode())).text()
