"""XAC003: a name in braces without a dollar."""

import pytest

from tests.naming import naming
from tests.reported import fixed, messages
from tests.xacros import HEAD
from urdfkit import check
from urdfkit.text.source import Source

MACRO = (
    f'{HEAD}<xacro:property name="width" value="1"/>'
    '<xacro:macro name="m" params="p:=a *block"><link name="${p}_link"/>INSIDE</xacro:macro>'
    '<xacro:m p="left"><origin/></xacro:m><xacro:m p="right"><origin/></xacro:m></robot>'
)


@pytest.mark.parametrize(
    ("inside", "name"),
    [
        ('<gazebo reference="{p}_link"/>', "p"),
        ("<gazebo><plugin>/robot/{p}/scan</plugin></gazebo>", "p"),
        ('<material name="grey-{width}"/>', "width"),
        ('<material name="$ {p}"/>', "p"),
    ],
)
def test_a_name_in_braces(inside: str, name: str) -> None:
    text = MACRO.replace("INSIDE", inside)
    (found,) = check(Source("r.urdf.xacro", text.encode()), select=["XAC003"]).diagnostics
    assert found.message == naming(f"{{{name}}}", "dollar")
    assert len(found.calls) == 2


@pytest.mark.parametrize(
    "inside", ['<a b="${p}"/>', '<a b="{other}"/>', '<a b="{{p: 1}}"/>', "<a>{}</a>"]
)
def test_others_are_calm(inside: str) -> None:
    robot = f'{HEAD}<xacro:property name="p" value="1"/>{inside}</robot>'
    assert messages("XAC003", robot, "r.urdf.xacro") == []


def test_it_is_fixed() -> None:
    robot = f'{HEAD}<xacro:property name="p" value="1"/><link name="{{p}}_link"/></robot>'
    assert '<link name="${p}_link"/>' in fixed("XAC003", robot, "r.urdf.xacro")
