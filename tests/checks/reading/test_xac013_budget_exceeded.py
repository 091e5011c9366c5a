from pathlib import Path

import pytest

from tests.naming import naming
from tests.xacros import codes, reported, told_of, write
from urdfkit.xacro import expansion

COUNT = '<xacro:macro name="m" params="n"><xacro:if value="${n}"><xacro:m n="${n-1}"/></xacro:if>'


@pytest.mark.parametrize(
    ("body", "message"),
    [
        (
            '<xacro:macro name="m" params="n"><xacro:m n="${n+1}"/></xacro:macro><xacro:m n="0"/>',
            naming("rejected", "150"),
        ),
        ('<link name="${2**10**9}"/>', naming("rejected", "integer", "1e+09", "${2**10**9}")),
        (
            "<link name=\"${'a'*10**9}\"/>",
            naming("rejected", "1e+09", "${'a'*10**9}"),
        ),
        (
            '<link name="${[x for x in range(10**9)]}"/>',
            naming("rejected", "1e+09", "${[x for x in range(10**9)]}"),
        ),
    ],
)
def test_more_than_any_robot_needs(body: str, message: str) -> None:
    (found,) = reported("XAC013", body)
    assert found.message == message


def test_macros_that_double(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(expansion, "MAX_CALLS", 2000)  # 50 000 take ten seconds
    levels = "".join(
        f'<xacro:macro name="m{n}" params=""><xacro:m{n - 1}/><xacro:m{n - 1}/></xacro:macro>'
        for n in range(1, 40)
    )
    body = f'<xacro:macro name="m0" params=""><link/></xacro:macro>{levels}<xacro:m39/>'
    write(tmp_path, robot=body)
    (found,) = told_of("XAC013", tmp_path / "robot.xacro")
    assert found.message == naming("rejected", "2000")


def test_an_include_of_itself(tmp_path: Path) -> None:
    write(tmp_path, robot='<link name="a"/><xacro:include filename="robot.xacro"/>')
    (found,) = told_of("XAC013", tmp_path / "robot.xacro")
    assert found.message == naming("infinite")


def test_a_macro_that_counts_down() -> None:
    body = f'{COUNT}</xacro:macro><xacro:m n="100"/><link name="a"/>'
    assert reported("XAC013", body) == []


def test_properties_in_a_circle_are_an_error_of_xacro() -> None:
    body = '<xacro:property name="a" value="${b}"/><xacro:property name="b" value="${a}"/>'
    assert codes(body + '<link name="${a}"/>') == ["XAC001"]
