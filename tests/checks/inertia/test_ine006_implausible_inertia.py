import pytest

from tests.conftest import MISSION
from tests.massive import BALL, MESH, WHEEL, inertial, joint, link, part, shape
from tests.naming import naming, values
from tests.reported import fixed, messages, places, reported
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Confidence, Severity


def test_a_wheel() -> None:
    robot = part("wheel", 0.5, (0.1, 0.1, 0.1), WHEEL)
    (found,) = reported("INE006", robot)
    assert found.message == naming(
        "wheel",
        "0.1 kg·m²",
        "47.3",
        "0.5 kg",
        "0.065 m",
        "0.06 m",
        "0.05 m",
        "0.000554, 0.000554, 0.0009 kg·m²",
    )
    assert found.help == naming('ixx="0.000554167"', 'iyy="0.000554167"', 'izz="0.0009"')
    assert (found.severity, found.confidence) == (Severity.WARNING, Confidence.INFERRED)
    assert places("INE006", robot) == [
        (3, '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>')
    ]


@pytest.mark.parametrize(("moment", "found"), [(0.019, 0), (0.021, 1)])
def test_twice_the_bound(moment: float, found: int) -> None:
    assert len(messages("INE006", part("ball", 1, (moment,) * 3, BALL))) == found


def test_the_bound_is_met_by_a_shell_that_is_all_rim() -> None:
    ring = part("ring", 1, (0.005, 0.005, 0.01), '<cylinder radius="0.1" length="0.001"/>')
    assert messages("INE006", ring) == []


def test_a_mesh_may_reach_farther() -> None:
    robot = link("a", shape("collision", BALL), shape("visual", MESH), inertial(1, (5, 5, 5)))
    assert messages("INE006", robot) == []


def test_a_striking_radius_of_gyration_is_reported() -> None:
    (message,) = messages("INE006", part("dot", 1e-4, (1, 1, 1), BALL))
    assert message == naming(
        "dot", "1 kg·m²", "1e+06", "0.0001 kg", "0.1 m", "0.1 m", "4e-07 kg·m²", "100 m"
    )


@pytest.mark.parametrize(("moment", "is_named"), [(0.98, False), (1.02, True)])
def test_ten_times_the_reach_is_striking(moment: float, is_named: bool) -> None:
    (message,) = messages("INE006", part("ball", 1, (moment,) * 3, BALL))
    assert ("gyration" in message) is is_named


def test_the_share_of_a_merged_body_is_reported() -> None:
    robot = part("base", 1, (0.3, 0.3, 0.3), '<box size="1 1 1"/>') + part(
        "ball", 1, (0.1, 0.1, 0.1), BALL
    )
    (message,) = messages("INE006", robot + joint("base", "ball"))
    assert message.endswith("'base'")
    assert "25%" in message


def test_no_share_of_a_body_whose_other_links_are_frames() -> None:
    robot = part("ball", 1, (0.1, 0.1, 0.1), BALL) + link("tool") + joint("ball", "tool")
    (message,) = messages("INE006", robot)
    assert "merges" not in message


def test_copies_are_one_finding_and_one_fix() -> None:
    robot = part("a", 1, (7, 7, 7), BALL) + part("b", 0.1, (7, 7, 7), BALL)
    (found,) = reported("INE006", robot)
    assert found.message == naming(
        *("b", "7 kg·m²", "7e+03", "0.1 kg", "0.1 m", "0.1 m", "0.0004 kg·m²", "8.37 m", "a")
    )
    after = fixed("INE006", robot)
    assert messages("INE006", after) == messages("INE008", after) == []
    assert 'ixx="0.004"' in after
    assert 'ixx="0.0004"' in after


def test_one_macro_of_the_mission_s_model_with_five_calls_the_worst_first() -> None:
    (found,) = engine.check(MISSION, select=["INE006"]).diagnostics
    assert found.span.text.startswith('<inertia ixx="0.1"')
    assert [call.via[-1].name for call in found.calls] == ["default_inertial"] * 5
    assert [call.element.split("/")[1] for call in found.calls] == [
        "base_footprint",
        "wheel_1",
        "wheel_2",
        "wheel_3",
        "wheel_4",
    ]
    first, *wheels = (call.message for call in found.calls)
    assert first == found.message
    assert values(first)[:5] == [
        "base_footprint",
        "0.1 kg·m²",
        "1.33e+09",
        "0.0001 kg",
        "0.000866 m",
    ]
    assert values(first)[5:7] == ["0.001 x 0.001 x 0.001 m", "1.67e-11 kg·m²"]
    assert values(first)[7:] == ["31.6 m", "50%", "dummy"]
    for number, message in enumerate(wheels, 1):
        assert message == naming(
            f"wheel_{number}",
            "0.1 kg·m²",
            "47.3",
            "0.5 kg",
            "0.065 m",
            "0.06 m",
            "0.05 m",
            "0.000554, 0.000554, 0.0009 kg·m²",
        )
    assert found.fix is None


@pytest.mark.parametrize(
    ("edge", "mass", "proposed"), [(0.006, 1e-3, True), (0.006, 1e-2, False), (0.005, 1e-4, False)]
)
def test_a_speck_that_stands_for_another_part_gives_no_tensor(
    edge: float, mass: float, proposed: bool
) -> None:
    """A box of 6 mm is the shape of a gramme, not of ten; one of 5 mm marks a place."""
    box = f'<box size="{edge} {edge} {edge}"/>'
    (found,) = reported("INE006", part("dot", mass, (1e-2,) * 3, box))
    assert (found.fix is not None) is proposed
    assert found.help.startswith("write ixx=") is proposed


@pytest.mark.parametrize(("mass", "is_fixed"), [("${mass}", False), ("0.5", True)])
def test_a_macro_that_takes_the_mass_gets_no_constant_tensor(mass: str, is_fixed: bool) -> None:
    """The next call has another mass; urdfkit inertia does not write there, either."""
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        f'<xacro:macro name="wheel" params="mass">{part("wheel", 0.5, (0.1, 0.1, 0.1), WHEEL)}'
        '</xacro:macro><xacro:wheel mass="0.5"/></robot>'
    ).replace('<mass value="0.5"', f'<mass value="{mass}"')
    (found,) = reported("INE006", text, "robot.xacro")
    assert bool(found.fix) is is_fixed
