import pytest

from tests.massive import MESH, WHEEL, inertial, joint, link, part, shape
from tests.naming import naming
from tests.reported import messages, reported
from tests.xacros import reported as told_of_xacro

SEEN = shape("visual", MESH)


def stand_in(name: str, mass: float, moment: float) -> str:
    return link(name, SEEN, inertial(mass, (moment, moment, moment)))


def test_a_stand_in() -> None:
    assert messages("INE009", stand_in("arm", 4, 1.0)) == [
        naming("arm", "4 kg", "1 kg·m²", "0.5 m")
    ]


@pytest.mark.parametrize(
    ("mass", "moment"),
    [
        (20, 1.0),  # a large body
        (0.1, 0.001),
        (0.3, 0.001),  # the last link of an arm
        (0.001, 1e-6),  # too little to matter
        (1, 0.5),  # no round power of ten
    ],
)
def test_what_can_be_true(mass: float, moment: float) -> None:
    assert messages("INE009", stand_in("arm", mass, moment)) == []


def test_all_links_with_it_are_one_finding_the_worst_first() -> None:
    robot = "".join(stand_in(f"l{i}", 1 + i % 3, 1.0) for i in range(6))
    (found,) = reported("INE009", robot)
    assert found.message == naming("l0", "1 kg", "1 kg·m²", "1 m", "l3", "l1", "3")
    assert len(found.related) == 5


def test_what_the_shape_reports_better_is_not_reported_here() -> None:
    assert messages("INE009", part("wheel", 0.5, (0.1, 0.1, 0.1), WHEEL)) == []


def test_a_light_sensor_on_a_heavy_base_does_not_matter() -> None:
    robot = link("base", SEEN, inertial(50, (2.1, 2.2, 2.3))) + stand_in("imu", 0.001, 0.001)
    assert messages("INE009", robot + joint("base", "imu")) == []
    assert len(messages("INE009", robot + joint("base", "imu", "revolute"))) == 1


MACRO = (
    '<xacro:macro name="inertial" params="mass"><inertial><mass value="${mass}"/>'
    '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></xacro:macro>\n'
)


@pytest.mark.parametrize(("masses", "found"), [((1, 1), 1), ((1, 2), 0)])
def test_a_macro_for_links_of_different_mass_is_reported_by_xac014(
    masses: tuple[int, ...], found: int
) -> None:
    links = "".join(
        f'<link name="l{number}">{SEEN}<xacro:inertial mass="{mass}"/></link>'
        for number, mass in enumerate(masses)
    )
    assert len(told_of_xacro("INE009", MACRO + links)) == found
    assert len(told_of_xacro("XAC014", MACRO + links)) == 1 - found
