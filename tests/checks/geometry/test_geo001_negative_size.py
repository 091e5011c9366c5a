from __future__ import annotations

import pytest

from tests.massive import link, shape
from tests.reported import messages, places


@pytest.mark.parametrize(
    ("geometry", "expected"),
    [
        ('<box size="1 -2 -3"/>', "size of the <box> in its collision is -3 m"),
        ('<sphere radius="-0.1"/>', "radius of the <sphere> in its collision is -0.1 m"),
        ('<cylinder radius="1" length="-2"/>', "length of the <cylinder> in its collision is -2 m"),
        ('<cylinder radius="-1"/>', "radius of the <cylinder> in its collision is -1 m"),
        ('<capsule radius="2" length="-1"/>', "length of the <capsule> in its collision is -1 m"),
    ],
)
def test_every_primitive(geometry: str, expected: str) -> None:
    assert messages("GEO001", link("arm", shape("collision", geometry))) == [
        f"link 'arm': {expected}"
    ]


def test_the_place_is_the_value_of_each() -> None:
    robot = link("arm", shape("visual", '<cylinder radius="-1" length="-2"/>'))
    assert places("GEO001", robot) == [(2, "-1"), (2, "-2")]


@pytest.mark.parametrize(
    "geometry",
    [
        '<box size="0 0 0"/>',  # GEO012
        '<box size="1 2 -"/>',  # URD005
        '<box size="-1 2"/>',  # URD005
        '<sphere radius="1" length="-1"/>',  # URD002
        '<mesh filename="a.stl" scale="1 -1 1"/>',  # GEO006
    ],
)
def test_what_another_rule_tells(geometry: str) -> None:
    assert messages("GEO001", link("arm", shape("collision", geometry))) == []
