import pytest

from tests.massive import BALL, BOX, joint, link, part
from tests.naming import naming
from tests.reported import fixed, messages, reported


def test_a_unit_is_recognized() -> None:
    robot = part("base", 12, (1.1e-7, 5.5e-8, 1.3e-7), BOX)
    (found,) = reported("INE006", robot)
    assert found.message == naming(
        "base", "12 kg", "1.3e-07 kg·m²", "1/1000000", "0.2 x 0.3 x 0.1 m", "0.1, 0.05, 0.13 kg·m²"
    )
    assert found.help == naming('ixx="0.1"', 'iyy="0.05"', 'izz="0.13"')
    assert 'ixx="0.1" ixy="0" ixz="0" iyy="0.05"' in fixed("INE006", robot)


@pytest.mark.parametrize(("moment", "found"), [(4.1e-5, 0), (3.9e-5, 1)])
def test_a_hundredth_of_the_solid(moment: float, found: int) -> None:
    assert len(messages("INE006", part("ball", 1, (moment,) * 3, BALL))) == found


def test_a_light_part_of_a_heavy_body_does_not_matter() -> None:
    robot = part("base", 60, (0.5, 0.25, 0.65), BOX) + part("ball", 0.1, (1e-9,) * 3, BALL)
    assert messages("INE006", robot + joint("base", "ball")) == []
    assert len(messages("INE006", robot + joint("base", "ball", "continuous"))) == 1


def test_what_is_fixed_to_the_world_does_not_matter() -> None:
    robot = link("world") + part("rail", 12, (1e-5,) * 3, BOX)
    assert messages("INE006", robot + joint("world", "rail")) == []


def test_a_copy_is_traced() -> None:
    robot = part("small", 1, (0.0004,) * 3, BALL.replace("0.1", "0.0316227766")) + part(
        "large", 9, (0.0004,) * 3, '<sphere radius="0.2"/>'
    )
    (found,) = reported("INE006", robot)
    assert found.help == naming("small", 'ixx="0.144"', 'iyy="0.144"', 'izz="0.144"')
