"""JNT012: see the rule."""

import pytest

from tests.naming import naming
from tests.reported import messages

LINK = '<link name="{}"><visual><geometry><box size="{}"/></geometry></visual></link>\n'
SMALL = LINK.format("arm", "0.1 0.1 0.3")


def test_a_box_in_millimetres() -> None:
    assert messages("JNT012", SMALL + LINK.format("hand", "50 50 240")) == [
        naming("hand", "visual", "240 m", "0.3 m")
    ]


@pytest.mark.parametrize(
    ("shape", "length"),
    [
        ('sphere radius="3"', 6),
        ('cylinder radius="4" length="4"', 8),
        ('capsule radius="2" length="2"', 6),
    ],
)
def test_a_radius_in_millimetres(shape: str, length: int) -> None:
    ball = f'<link name="ball"><collision><geometry><{shape}/></geometry></collision></link>'
    small = LINK.format("arm", "0.1 0.05 0.05")
    (message,) = messages("JNT012", small + ball)
    assert message == naming("ball", "collision", f"{length} m", "0.1 m")


@pytest.mark.parametrize(
    ("name", "size"),
    [
        ("hand", "0.05 0.05 0.24"),
        ("rail", "0.05 0.05 30"),
        ("ground_plane", "50 50 50"),
        ("ship", "10 4 4"),
    ],
)
def test_what_may_be_intended(name: str, size: str) -> None:
    assert messages("JNT012", SMALL + LINK.format(name, size)) == []


def test_alone_it_tells_nothing() -> None:
    assert messages("JNT012", LINK.format("hand", "50 50 240")) == []


@pytest.mark.parametrize(
    ("size", "found"),
    [
        (15.1, 1),  # more than fifty times the 0.3 m of the arm
        (14.9, 0),
    ],
)
def test_fifty_times_the_rest(size: float, found: int) -> None:
    assert len(messages("JNT012", SMALL + LINK.format("hand", f"{size} 1 1"))) == found


@pytest.mark.parametrize(("size", "found"), [(5.1, 1), (4.9, 0)])
def test_five_metres_at_least(size: float, found: int) -> None:
    tiny = LINK.format("arm", "0.01 0.01 0.02")
    assert len(messages("JNT012", tiny + LINK.format("hand", f"{size} 1 1"))) == found


@pytest.mark.parametrize("word", "ground floor world plane room map terrain field".split())
def test_the_surroundings_may_be_large(word: str) -> None:
    assert messages("JNT012", SMALL + LINK.format(f"my_{word}_link", "50 50 240")) == []
