"""JNT025 points at the wheel that is misplaced: the others tell which of the two it is."""

import pytest

from tests.reported import messages

NAMES = ("front_left", "front_right", "rear_left", "rear_right")
PLACES = ("0.2 0.15 0", "0.2 -0.15 0", "-0.2 0.15 0", "-0.2 -0.15 0")


def robot(*places: str) -> str:
    text = '<link name="base"/>'
    for name, place in zip(NAMES, places, strict=True):
        text += (
            f'<link name="{name}"/><joint name="{name}" type="continuous"><parent link="base"/>'
            f'<child link="{name}"/><origin xyz="{place}"/><axis xyz="0 1 0"/></joint>'
        )
    return text


def test_four_wheels_in_their_corners() -> None:
    assert messages("JNT025", robot(*PLACES)) == []


@pytest.mark.parametrize("odd", range(4))
@pytest.mark.parametrize("mistake", ["y", "x", "forward", "up", "below"])
def test_the_odd_one_is_reported(odd: int, mistake: str) -> None:
    x, y, z = map(float, PLACES[odd].split())
    wrong = {
        "y": (x, -y, z),
        "x": (-x, y, z),
        "forward": (x + 0.03, y, z),
        "up": (x, y, 0.05),
        "below": (x, y, -0.1),
    }[mistake]
    places = [*PLACES]
    places[odd] = " ".join(map(str, wrong))
    (message,) = messages("JNT025", robot(*places))
    assert message.startswith(f"joint '{NAMES[odd]}' ")


def test_one_of_two_wheels_left_of_the_middle_is_the_right_one() -> None:
    """Left is +y (REP 103), where no other joint says otherwise."""
    text = robot("0 0.15 0", "0 0.15 0", "-0.2 0 0", "-0.3 0 0")
    assert messages("JNT025", text)[0].startswith("joint 'front_right' ")
    text = robot("0 -0.15 0", "0 -0.15 0", "-0.2 0 0", "-0.3 0 0")
    assert messages("JNT025", text)[0].startswith("joint 'front_left' ")


def test_a_robot_whose_left_is_minus_y() -> None:
    mirrored = [place.replace(" 0.15", " +").replace(" -0.15", " 0.15") for place in PLACES]
    mirrored = [place.replace(" +", " -0.15") for place in mirrored]
    assert messages("JNT025", robot(*mirrored)) == []
    mirrored[3] = mirrored[2]
    assert messages("JNT025", robot(*mirrored))[0].startswith("joint 'rear_right' ")


@pytest.mark.parametrize(("turned", "count"), [(True, 0), (False, 1)])
def test_brackets_that_are_turned_inside_their_links(turned: bool, count: int) -> None:
    """A waferbot: one bracket is half a turn of the other, so its corner is on the other side."""
    sides = (("left", "-0.02 0.08 0", "0.02 -0.03 0"), ("right", "0.02 -0.08 0", "-0.02 0.03 0"))
    text = '<link name="base"/>'
    for side, place, center in sides:
        shift = center if turned else "0.02 -0.03 0"
        text += (
            f'<link name="{side}_bracket"><visual><origin xyz="{shift}"/><geometry>'
            '<box size="0.05 0.055 0.035"/></geometry></visual></link>'
            f'<joint name="{side}_bracket" type="fixed"><parent link="base"/>'
            f'<child link="{side}_bracket"/><origin xyz="{place}"/></joint>'
        )
    assert len(messages("JNT025", text)) == count
