"""GEO013: see the rule."""

import pytest

from tests.told import messages

LINK = '<link name="{}"><visual><geometry><box size="{}"/></geometry></visual></link>\n'
SMALL = LINK.format("arm", "0.1 0.1 0.3")


def test_a_box_in_millimetres() -> None:
    assert messages("GEO013", SMALL + LINK.format("hand", "50 50 240")) == [
        "link 'hand': the visual is 240 m long, and nothing else of the robot is longer than 0.3 m"
    ]


@pytest.mark.parametrize(
    ("name", "size"),
    [
        ("hand", "0.05 0.05 0.24"),
        ("rail", "0.05 0.05 30"),
        ("ground_plane", "50 50 50"),
        ("ship", "10 4 4"),
    ],
)
def test_what_may_be_meant_is_calm(name: str, size: str) -> None:
    assert messages("GEO013", SMALL + LINK.format(name, size)) == []


def test_alone_it_tells_nothing() -> None:
    assert messages("GEO013", LINK.format("hand", "50 50 240")) == []
