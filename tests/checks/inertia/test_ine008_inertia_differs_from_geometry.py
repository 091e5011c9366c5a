import pytest

from tests.conftest import MISSION
from tests.massive import BALL, BOX, MESH, inertial, joint, link, part, shape
from tests.naming import naming, values
from tests.reported import fixed, messages, reported
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Severity


def test_a_guessed_tensor() -> None:
    robot = part("imu", 0.5, (1e-4, 1e-4, 1e-4), BALL)
    (found,) = reported("INE008", robot)
    assert found.severity is Severity.INFO
    assert found.message == naming("imu", "0.5 kg", "0.0001 kg·m²", "0.1 m", "0.002 kg·m²")
    assert found.help == naming('ixx="0.002"', 'iyy="0.002"', 'izz="0.002"')
    assert found.fix is not None
    assert not found.fix.safe
    assert messages("INE008", fixed("INE008", robot)) == []


@pytest.mark.parametrize(
    "robot",
    [
        part("solid", 1, (0.004, 0.004, 0.004), BALL),
        part("shell", 1, (0.00667, 0.00667, 0.00667), BALL),  # 2/3 m r^2
        part("motor inside", 1, (0.0013, 0.0013, 0.0013), BALL),
        part("from CAD", 1, (0.0009, 1e-5, 0, 0.0009, 0, 0.0009), BALL),
        link("mesh", shape("visual", MESH), shape("collision", BALL), inertial(1, (0.01234,) * 3)),
    ],
)
def test_what_can_be_meant(robot: str) -> None:
    assert messages("INE008", robot) == []


def test_a_diameter_for_a_radius_is_reported() -> None:
    (found,) = reported("INE008", part("ball", 1, (0.016, 0.016, 0.016), BALL))
    assert found.help == naming("twice", 'ixx="0.004"', 'iyy="0.004"', 'izz="0.004"')


def test_the_mission_s_model() -> None:
    found = engine.check(MISSION, select=["INE008"]).diagnostics
    assert [(one.element.split("/")[1], one.span.line) for one in found] == [
        ("base_link", 15),
        ("imu_link", 215),
        ("camera_link", 245),
        ("laser_frame", 272),
    ]
    base, *cubes = found
    assert base.message == naming(
        "base_link", "8.2 kg", "0.1 kg·m²", "0.2 x 0.3 x 0.1 m", "0.0683, 0.0342, 0.0888 kg·m²"
    )
    assert [call.via[-1].span.line for call in base.calls] == [68]
    assert base.fix is None
    for cube in cubes:
        assert values(cube.message)[2:] == ["1e-06 kg·m²", "0.05 x 0.05 x 0.05 m", "4.17e-06 kg·m²"]
        assert cube.help == naming('ixx="4.16667e-06"', 'iyy="4.16667e-06"', 'izz="4.16667e-06"')
        assert cube.fix is not None


def test_no_shape_of_more_than_it_shows() -> None:
    assert messages("INE008", part("box", 12, (0.1, 0.05, 0.13), BOX)) == []


@pytest.mark.parametrize(("edge", "found"), [(0.001, 0), (0.02, 1)])
def test_a_shape_that_marks_a_place_says_nothing_of_the_tensor(edge: float, found: int) -> None:
    camera = part("camera", 1e-5, (1e-6,) * 3, f'<box size="{edge} {edge} {edge}"/>')
    robot = part("base", 12, (0.13, 0.1, 0.05), BOX) + camera + joint("base", "camera")
    assert len(messages("INE008", robot)) == found


def test_radius_and_length_exchanged_are_a_warning() -> None:
    """A macro for cylinders that is called with the height as r and the radius as h."""
    wheel = '<cylinder radius="0.05" length="0.02"/>'
    exchanged = (1 / 12 * (3 * 0.02**2 + 0.05**2),) * 2 + (0.5 * 0.02**2,)
    (found,) = reported("INE008", part("wheel", 1, exchanged, wheel))
    assert found.severity is Severity.WARNING
    assert "the length as the radius" in found.help
