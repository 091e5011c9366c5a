from pathlib import Path

import pytest

from tests.conftest import MISSION
from tests.massive import BALL, BOX, MESH, inertial, joint, link, part, shape
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit.lint import engine
from urdfkit.mesh import samples


def box(mass: float) -> str:
    return part("box", mass, (mass / 120, mass / 240, mass * 0.13 / 12), BOX)


def test_a_mass_in_grams() -> None:
    (found,) = reported("INE010", box(6000))
    assert found.message == naming(
        "box", "6000 kg", "0.2 x 0.3 x 0.1 m", "1e+06 kg/m³", "20", "12000"
    )
    assert found.help == naming("in g", "6", "kg·m²")
    assert places("INE010", box(6000)) == [(2, "6000")]


def test_a_size_in_millimetres() -> None:
    (found,) = reported("INE010", part("box", 6, (0.05, 0.025, 0.065), '<box size="200 300 100"/>'))
    assert "in mm" in found.help


@pytest.mark.parametrize(("mass", "found"), [(0.09, 1), (0.11, 0), (6, 0), (86, 0), (87, 1)])
def test_the_range(mass: float, found: int) -> None:
    assert len(messages("INE010", box(mass))) == found


def test_both_shapes_must_be_implausible() -> None:
    small = shape("collision", BALL)
    large = shape("visual", '<sphere radius="0.5"/>')
    moments = (0.2, 0.2, 0.2)
    assert messages("INE010", link("a", small, large, inertial(70, moments))) == []
    assert len(messages("INE010", link("a", small, inertial(70, moments)))) == 1


def test_the_density_is_that_of_the_shape_in_the_message() -> None:
    """ROS-Drone: a mesh of 1.54e-6 m³ had the density of its convex hull."""
    shapes = shape("collision", BALL) + shape("visual", '<sphere radius="0.15"/>')
    (found,) = messages("INE010", link("a", shapes, inertial(700, (2, 2, 2))))
    assert found == naming("a", "700 kg", "0.1 m", "1.67e+05 kg/m³", "20", "12000")


@pytest.mark.parametrize(
    "robot",
    [
        link("seen only", shape("visual", BOX), inertial(6000, (50, 25, 65))),
        link("mesh", shape("collision", BOX), shape("visual", MESH), inertial(6000, (50, 25, 65))),
        part("marker", 1, (1e-6, 1e-6, 1e-6), '<box size="0.004 0.004 0.004"/>'),
        box(6) + part("dot", 0.01, (1e-8,) * 3, '<sphere radius="0.1"/>') + joint("box", "dot"),
    ],
)
def test_what_is_not_judged(robot: str) -> None:
    assert messages("INE010", robot) == []


def test_a_tensor_out_of_all_bounds_is_reported_instead() -> None:
    robot = part("box", 0.1, (5, 5, 5), BOX)
    assert messages("INE010", robot) == []
    assert len(messages("INE006", robot)) == 1


def test_the_mission_s_model_has_a_footprint_without_collision() -> None:
    assert engine.check(MISSION, select=["INE010"]).diagnostics == ()


def chain(*masses: float) -> str:
    """Boxes that hang on one another, with their uniform tensors."""
    parts = [
        part(f"p{n}", mass, (mass / 120, mass / 240, mass * 0.13 / 12), BOX)
        for n, mass in enumerate(masses)
    ]
    return "".join(parts) + "".join(
        joint(f"p{n}", f"p{n + 1}", "revolute", "0 0.1 0") for n in range(len(masses) - 1)
    )


def test_a_typo_of_the_whole_robot_is_reported_once() -> None:
    (found,) = reported("INE010", chain(6000, 5000, 4000, 3))
    assert found.message == naming(
        "p0", "6000 kg", "0.2 x 0.3 x 0.1 m", "1e+06 kg/m³", "20", "12000", "p1", "p2"
    )
    assert found.help == naming("1000")
    assert found.fix is not None
    assert [one.message.split(":")[0] for one in found.related] == ["link 'p1'", "link 'p2'"]
    assert 'value="4"' in (text := fixed("INE010", chain(6000, 5000, 4000, 3)))
    assert messages("INE010", text) == []


@pytest.mark.parametrize(
    ("masses", "number"),
    [
        ((6000, 5000, 3, 3, 3), 2),  # two of five
        ((6000, 5000, 3), 2),  # too few for a habit
        ((6000, 5000, 0.01), 3),  # some too heavy, some too light
        ((0.006, 0.005, 0.004), 1),
    ],
)
def test_when_links_are_reported_one_by_one(masses: tuple[float, ...], number: int) -> None:
    assert len(messages("INE010", chain(*masses))) == number


def test_gravity_is_then_not_weighed() -> None:
    assert len(messages("DYN003", chain(3, 5000, 4000))) == 1
    assert messages("DYN003", chain(6000, 5000, 4000)) == []


def test_a_mesh_of_a_size_that_nothing_has(tmp_path: Path) -> None:
    """Its density is 0."""
    (tmp_path / "box.stl").write_bytes(samples.stl(samples.box((0, 0, 0), (1, 1, 1))))
    scaled = '<mesh filename="box.stl" scale="1e300 1e300 1e300"/>'
    path = str(tmp_path / "robot.urdf")
    (found,) = reported("INE010", part("a", 1, (1, 1, 1), scaled), path)
    assert "make 0 kg/m³" in found.message


@pytest.mark.parametrize(("mass", "severity"), [(40, "warning"), (4e5, "info")])
def test_a_part_of_millimetres_is_no_wall(mass: float, severity: str) -> None:
    """40 kg in 876 m are a part of 0.876 m, and not a light building."""
    column = part("column", mass, (6e4 * mass,) * 3, '<box size="400 300 876"/>')
    (found,) = reported("INE010", column)
    assert found.severity.value == severity


def test_visuals_in_millimetres_give_no_tensor() -> None:
    """Else a fix would write 2.9e6 kg·m² into a sound link."""
    moments = (0.3, 0.3, 0.08)
    box = shape("visual", '<box size="400 300 876"/>')
    column = link("column", box, inertial(40, moments))
    assert len(reported("INE010", column)) == 1
    assert reported("INE006", column) == []


def test_moments_of_a_usual_part_show_that_the_mass_is_wrong() -> None:
    good = (0.05, 0.025, 0.065)  # of 6 kg
    assert [len(messages(code, part("box", 600, good, BOX))) for code in ("INE010", "INE006")] == [
        1,
        0,
    ]
    assert [len(messages(code, part("box", 6e-4, good, BOX))) for code in ("INE010", "INE006")] == [
        1,
        0,
    ]
    tiny = tuple(moment / 1e4 for moment in good)
    assert [len(messages(code, part("box", 600, tiny, BOX))) for code in ("INE010", "INE006")] == [
        1,
        0,
    ]
    assert [len(messages(code, part("box", 6, tiny, BOX))) for code in ("INE010", "INE006")] == [
        0,
        1,
    ]


def test_grams_of_a_part_with_its_mass_in_the_middle() -> None:
    """Its tensor is that of 6 kg, and a sixth of the uniform box's."""
    (found,) = reported("INE010", part("box", 6000, (0.05 / 6, 0.025 / 6, 0.065 / 6), BOX))
    assert found.help == naming("6", "kg·m²")


def test_the_other_side_shows_that_a_density_is_wrong() -> None:
    """15000 kg/m³ may be due to a coarse shape, unless that of the other side has 1500."""
    volume, moments = 0.02, (0.4, 0.4, 0.4)

    def arms(left: float, right: float) -> str:
        text = link("base")
        for side, density in (("left", left), ("right", right)):
            text += part(f"{side}_arm", volume * density, moments, '<box size="0.1 0.4 0.5"/>')
            text += joint("base", f"{side}_arm", "revolute")
        return text

    for other, severity in ((15000, "info"), (1500, "warning")):
        found = reported("INE010", arms(15000, other))
        assert {one.severity.value for one in found} == {severity}


def test_a_mass_without_effect_whose_tensor_is_that_of_the_part() -> None:
    """A gripper with its mass in tons: the tensor shows that it is not a placeholder."""
    arm = part("arm", 1, (0.004, 0.004, 0.004), BALL)
    light = part("tool", 0.001, (0.00412, 0.00412, 0.00412), BALL) + joint("arm", "tool")
    assert messages("INE010", arm + light) == [
        naming("tool", "0.001 kg", "0.1 m", "0.239 kg/m³", "20", "12000")
    ]
    assert messages("INE006", arm + light) == []
    invented = arm + light.replace("0.00412", "0.004")
    assert messages("INE010", invented) == []
    assert len(messages("INE006", invented)) == 1
