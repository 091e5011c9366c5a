"""GEO004, radius: see the rule."""

import pytest

from tests.massive import link, shape
from tests.naming import naming
from tests.reported import messages, places

LINK = (
    '<link name="a"><visual><geometry>{}</geometry></visual>\n'
    "<collision>{}<geometry>{}</geometry></collision></link>"
)
SMALL = '<cylinder radius="0.1" length="0.05"/>'
LARGE = '<cylinder radius="0.2" length="0.05"/>'


def test_twice_the_radius() -> None:
    text = LINK.format(SMALL, "", LARGE)
    assert messages("GEO004", text) == [
        naming("a", "collision", "0.2 m", "twice", "visual", "0.1 m")
    ]
    assert places("GEO004", text) == [(3, LARGE)]


@pytest.mark.parametrize(
    ("radius", "factor"), [("1", "10 times"), ("0.01", "10 times"), ("0.001", "100 times")]
)
def test_the_decimal_point_of_a_radius(radius: str, factor: str) -> None:
    robot = LINK.format(SMALL, "", SMALL.replace("0.1", radius))
    (message,) = messages("GEO004", robot)
    assert message.startswith("link 'a': the radius of the ")
    assert f"is {factor} that" in message


def test_a_ball_of_another_size_is_reported_once() -> None:
    ball = '<sphere radius="0.1"/>'
    assert len(messages("GEO004", LINK.format(ball, "", ball.replace("0.1", "1")))) == 1


@pytest.mark.parametrize(
    ("seen", "origin", "touched"),
    [
        (SMALL, "", SMALL),
        (SMALL, "", LARGE.replace("0.2", "0.19")),
        (SMALL, "", LARGE.replace("0.05", "0.1")),
        (SMALL, '<origin xyz="0 0 1"/>', LARGE),
        (SMALL, "", '<sphere radius="0.2"/>'),
    ],
)
def test_other_shapes(seen: str, origin: str, touched: str) -> None:
    found = messages("GEO004", LINK.format(seen, origin, touched))
    assert not any("radius" in message for message in found)


def test_of_several_shapes_none_is_the_other_of_one() -> None:
    text = LINK.format(SMALL, "", LARGE)
    one, other = (
        text[text.index(f"<{tag}>") : text.index(f"</{tag}>")] + f"</{tag}>"
        for tag in ("visual", "collision")
    )
    assert len(messages("GEO004", f'<link name="a">{one}{other}</link>')) == 1
    assert messages("GEO004", f'<link name="a">{one}{one}{other}</link>') == []
    assert messages("GEO004", f'<link name="a">{one}{other}{other}</link>') == []


def feet(*radii: float, seen: float = 0.015) -> str:
    names = ("foot_L1", "foot_R1", "foot_L2", "foot_R2")
    return "".join(
        link(
            name,
            shape("visual", f'<sphere radius="{seen}"/>'),
            shape("collision", f'<sphere radius="{radius}"/>'),
        )
        for name, radius in zip(names, radii, strict=True)
    )


@pytest.mark.parametrize(
    ("radii", "found"),
    [
        ((0.015, 0.015, 0.015, 0.02), ["foot_R2"]),
        ((0.02, 0.02, 0.015, 0.02), ["foot_L2"]),
        ((0.02, 0.02, 0.02, 0.02), []),
        ((0.015, 0.015, 0.02, 0.02), []),  # the hind feet
    ],
)
def test_one_leg_with_another_collision(radii: tuple[float, ...], found: list[str]) -> None:
    heard = messages("GEO004", feet(*radii))
    assert [one.split("'")[1] for one in heard] == found
    text = feet(*radii).replace("0.015", "0.018", 1)
    assert messages("GEO004", text) == [], "the visuals differ, too"
