"""JNT033: see the rule."""

import pytest

from tests.told import messages

WHEEL = """\
<link name="base"/><link name="{name}"><collision><origin rpy="{rpy}"/>
<geometry><cylinder radius="0.1" length="{length}"/></geometry></collision></link>
<joint name="j" type="{kind}"><parent link="base"/><child link="{name}"/>
<axis xyz="{axis}"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>"""


def robot(
    axis: str = "0 1 0",
    rpy: str = "1.5708 0 0",
    name: str = "wheel",
    kind: str = "continuous",
    length: str = "0.04",
) -> str:
    return WHEEL.format(axis=axis, rpy=rpy, name=name, kind=kind, length=length)


def test_the_axis_or_the_shape_lies_across() -> None:
    assert messages("JNT033", robot("1 0 0")) == [
        "joint 'j' turns wheel 'wheel' about 1 0 0, and the axis of its cylinder is 0 -1 0"
    ]
    assert messages("JNT033", robot("0 0 1"))
    assert messages("JNT033", robot(rpy="0 0 0"))


@pytest.mark.parametrize(
    "sound",
    [
        robot(),
        robot("0 -1 0"),
        robot("0 0 1", "0 0 0"),
        robot("0 0 1", kind="revolute"),  # it is steered
        robot("0 0 1", name="caster_wheel"),
        robot("1 0 0", name="arm"),
        robot("1 0 0", length="0.5"),  # a roller, or a leg
    ],
)
def test_what_rolls_or_is_steered_is_calm(sound: str) -> None:
    assert messages("JNT033", sound) == []
