"""What is said of tensors that are wrong in one way, or on purpose."""

from pathlib import Path

import pytest

from tests import meshed
from tests.massive import BALL, inertial, joint, link, part, shape
from tests.naming import naming
from tests.reported import messages, reported
from urdfkit.text.diagnostic import Severity

#: A rod of 1 kg, 0.6 x 0.1 x 0.1 m, turned by 30 degrees about z.
ROD = shape("collision", '<box size="0.6 0.1 0.1"/>', rpy="0 0 0.5235987755982988")
BALL_SHAPE = shape("collision", BALL)
TENSOR = (0.0089583, -0.0126295, 0.0, 0.0235417, 0.0, 0.0308333)


def test_the_sign_of_a_product_and_not_the_moments_that_agree() -> None:
    flipped = (TENSOR[0], -TENSOR[1], *TENSOR[2:])
    assert messages("INE006", link("rod", ROD, inertial(1, TENSOR))) == []
    assert messages("INE006", link("rod", ROD, inertial(1, flipped))) == [
        naming("rod", "0.0126 kg·m²", "0.6 x 0.1 x 0.1 m", "-0.0126")
    ]


def test_a_floor_under_the_moments_of_many_links_is_one_finding() -> None:
    """The iCub: no moment below 0.001, of whatever link and beside whatever other entries."""
    fingers = [
        part(f"finger_{n}", 0.01, (0.001, 1e-5 * n, 1e-6, 0.001, 0, 0.0009), BALL)
        + joint("palm", f"finger_{n}", "revolute")
        for n in range(12)
    ]
    palm = part("palm", 1, (0.004, 0.004, 0.004), BALL)
    (found,) = reported("INE006", palm + "".join(fingers))
    assert found.message.endswith(" and 9 more)")
    assert len(found.related) == 11


@pytest.mark.parametrize(("name", "count"), [("ballast", 0), ("wheel", 1)])
def test_weights_that_balance_a_robot(name: str, count: int) -> None:
    """A surface vehicle, trimmed by a heavier weight in front."""
    robot = "".join(
        link(f"{name}_{n}", inertial(mass, (1e-3 * mass,) * 3))
        + joint("base", f"{name}_{n}", "fixed", f"{x} -0.25 0")
        for n, mass, x in ((1, 0.14, 0.225), (2, 0.02, -0.225))
    )
    assert len(reported("INE012", link("base") + robot)) == count


@pytest.mark.parametrize(("mass", "count"), [(59, 0), (63, 1)])
def test_a_density_near_the_bound_is_no_finding(mass: float, count: int) -> None:
    density = 14400 * 0.0041888  # a ball of 0.1 m is of 0.0041888 m^3
    assert (mass > density) is bool(count)
    moment = 0.4 * mass * 0.01
    assert len(reported("INE010", part("ball", mass, (moment,) * 3, BALL))) == count


def test_a_placeholder_mass_gives_no_tensor() -> None:
    """KUKA's arms: links of 1e-6 kg with a tensor of zeros."""
    zeros = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    for mass, is_fixable in ((1e-6, False), (1.0, True)):
        arm = link("arm", BALL_SHAPE, inertial(mass, zeros))
        robot = (
            part("base", 1, (0.004, 0.004, 0.004), BALL) + arm + joint("base", "arm", "revolute")
        )
        (found,) = reported("INE005", robot)
        assert (found.fix is not None) is is_fixable
        assert found.help.startswith("a solid" if is_fixable else "write the mass")


def test_a_centre_of_mass_beside_a_shape_that_marks_a_place() -> None:
    """AgileX's Hunter: a box of 1 mm stands for the steering link, 16 mm from its centre."""
    box = shape("collision", '<box size="0.001 0.001 0.001"/>')
    moments = (1e-4, 0.0, 0.0, 1e-4, 0.0, 1e-4)
    for distance, count in (("0.016", 0), ("1.6", 1)):
        robot = link("base", BALL_SHAPE, inertial(1, TENSOR)) + joint("base", "arm", "revolute")
        arm = link("arm", box, inertial(0.3, moments, xyz=f"{distance} 0 0"))
        assert len(messages("INE011", robot + arm)) == count


@pytest.mark.parametrize(
    ("mass", "moment", "severity"),
    [
        (0.001, 3e-16, Severity.WARNING),
        (0.001, 0.0, Severity.WARNING),
        (0.1, 0.0, Severity.ERROR),
    ],
)
def test_a_tensor_of_a_body_of_a_micrometre(mass: float, moment: float, severity: Severity) -> None:
    """UUV simulator's thrusters: 1 g within 1 µm, on purpose, which Gazebo simulates."""
    tensor = (moment, 0, 0, moment, 0, moment)
    thruster = link("base") + part("thruster", mass, tensor, BALL)
    thruster += joint("base", "thruster", "revolute")
    (found,) = reported("INE005", thruster)
    assert found.severity is severity


@pytest.mark.parametrize(
    ("mass", "size", "severity"),
    [
        (12, "1 0.9 1", Severity.INFO),  # Igus: a coarse collision shape
        (5, "1 0.9 1", Severity.WARNING),
        (5, "1 1.1 1", Severity.INFO),  # the walls that a drone flies around
    ],
)
def test_densities_near_the_bound_and_of_scenery(
    mass: float, size: str, severity: Severity
) -> None:
    (found,) = reported("INE010", part("wall", mass, (1, 0, 0, 1, 0, 1), f'<box size="{size}"/>'))
    assert found.severity is severity


@pytest.mark.parametrize(
    ("mass", "targets", "severity"),
    [
        (0.001, (), Severity.WARNING),
        (0.001, ("mujoco",), Severity.ERROR),
        (0.1, (), Severity.ERROR),
    ],
)
def test_a_gram_without_a_tensor_stands_in(
    mass: float, targets: tuple[str, ...], severity: Severity
) -> None:
    """UUV Simulator: thrusters of a gram, whose forces a plugin computes."""
    robot = part("hull", 10, (1, 1, 1), BALL) + link("thruster", inertial(mass, (0, 0, 0)))
    robot += joint("hull", "thruster", "continuous")
    (found,) = reported("INE005", robot, targets=targets)
    assert found.severity is severity


TOO_LARGE = inertial(0.018, (0.001, 0.001, 0.001))
STABLE = TOO_LARGE.replace("</inertial>", " <!-- To stabilize simulation --></inertial>")
MICROMETRE = shape("collision", '<cylinder radius="0.000001" length="0.000001"/>')


@pytest.mark.parametrize(
    ("finger", "severity"),
    [
        (link("finger", BALL_SHAPE, TOO_LARGE), Severity.WARNING),
        (link("finger", BALL_SHAPE, STABLE), Severity.INFO),
        (link("finger", BALL_SHAPE, STABLE.replace("stabilize", "be")), Severity.WARNING),
    ],
)
def test_a_tensor_that_is_too_large_on_purpose(finger: str, severity: Severity) -> None:
    """PAL's hands have a comment."""
    (found,) = reported("INE006", finger)
    assert found.severity is severity


def test_a_frame_that_measures_a_micrometre() -> None:
    """The optical frames of UUV Simulator."""
    assert messages("INE006", link("eye", MICROMETRE, inertial(0.001, (2e-12,) * 3))) == []


@pytest.mark.parametrize(("moment", "count"), [(6e-4, 0), (0.1, 1)])
def test_a_shape_that_marks_a_place_says_nothing_of_the_size(moment: float, count: int) -> None:
    """jsk_aerial_robot's battery of 0.4 kg: the unit of its mesh is wrong, not its tensor."""
    ball = shape("collision", '<sphere radius="0.00007"/>')
    battery = link("battery", ball, inertial(0.41, (moment / 2, 0, 0, moment, 0, moment)))
    assert len(messages("INE006", battery)) == count


@pytest.mark.parametrize(("mass", "count"), [("10", 0), ("0.001", 1)])
def test_masses_that_are_lost_in_the_body(mass: str, count: int) -> None:
    """jsk_aerial_robot's rotor arms of 1 g and 0.1 g, fixed to the frame."""
    light = (1e-6, 0, 0, 1e-6, 0, 1e-6)
    sides = "".join(
        link(f"{side}_arm", inertial(value, light)) + joint("base", f"{side}_arm", xyz=f"0 {y} 0")
        for side, value, y in (("left", 0.001, 0.2), ("right", 0.0001, -0.2))
    )
    base = link("base", inertial(float(mass), (0.1, 0, 0, 0.1, 0, 0.1)))
    assert len(reported("INE012", base + sides)) == count


@pytest.mark.parametrize(("edge", "count"), [("100", 0), ("0.1", 1)])
def test_a_shape_in_millimetres_says_nothing_of_the_tensor(edge: str, count: int) -> None:
    """AUBO's i7: the mesh of the collision is a thousand times that of the visual."""
    visual = shape("visual", '<box size="0.1 0.1 0.1"/>')
    collision = shape("collision", f'<box size="{edge} {edge} {edge}"/>')
    text = link("arm", visual, collision, inertial(5, (1e-5, 0, 0, 1e-5, 0, 1e-5)))
    assert len(messages("INE006", text)) == count


def test_a_flat_shape_is_in_no_other_unit() -> None:
    """The PR2's forearm: one of its shapes has hardly any volume."""
    flat = shape("visual", '<box size="0.02 0.02 1e-6"/>')
    text = link("arm", flat, shape("collision", BALL), inertial(1, (1, 0, 0, 1.1, 0, 1.2)))
    assert len(messages("INE006", text)) == 1


def test_the_box_of_a_tutorial() -> None:
    """A macro with x and z for iyy and for izz: ixx is not ten times too large."""
    macro = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:macro name="box" params="m x y z"><inertial><mass value="${m}"/><inertia '
        'ixx="${m*(y*y+z*z)/12}" iyy="${m*(x*x+z*z)/12}" izz="${m*(%s*%s+%s*%s)/12}" '
        'ixy="0" ixz="0" iyz="0"/></inertial></xacro:macro>'
        '<link name="a"><xacro:box m="0.1" x="0.01" y="0.04" z="0.01"/></link></robot>'
    )
    (found,) = reported("INE003", macro % ("x", "x", "z", "z"), "r.xacro")
    assert "at iyy and izz" in found.help
    assert found.fix is None
    assert reported("INE003", macro % ("x", "x", "y", "y"), "r.xacro") == []


@pytest.mark.parametrize(
    ("moment", "is_typo"), [("0.000666", True), ("0.0006666666666666668", False)]
)
def test_a_computed_moment_is_no_typo(moment: str, is_typo: bool) -> None:
    """teleop_robot: a program wrote the tensor of a box whose edges were exchanged."""
    inertia = f'<inertia ixx="4.17e-5" iyy="4.17e-5" izz="{moment}" ixy="0" ixz="0" iyz="0"/>'
    text = f'<link name="a"><inertial><mass value="0.1"/>{inertia}</inertial></link>'
    (found,) = reported("INE003", text)
    assert ("ten times" in found.help) is is_typo


def test_a_mesh_in_millimetres_has_no_volume_to_believe() -> None:
    """Tom0Brien/Walk: legs of 3e5 m³, whose volume the help gave as that of the link."""
    big = '<box size="50 60 100"/>'
    base = part("base", 1, (0.01, 0, 0, 0.01, 0, 0.01), BALL)
    for mass, help in (
        (0.1, naming("3e+05 m³", "in mm", "tensor")),
        (1e-4, naming("mass", "3e+05 m³", "tensor")),
    ):
        leg = part("leg", mass, (0, 0, 0, 0, 0, 0), big)
        found = reported("INE005", base + leg + joint("base", "leg", "continuous"))
        assert [one.help for one in found] == [help]


def test_a_tensor_of_zeros_is_not_that_of_a_rod() -> None:
    """kxr: the inertia about two axes is that of the mass fixed at the end of the link."""
    zeros = (0, 0, 0, 0, 0, 0)
    parts = [part(name, 1, zeros, BALL) for name in ("arm", "hand")]
    base = part("base", 1, (0.01, 0, 0, 0.01, 0, 0.01), BALL)
    wrist = joint("arm", "hand", xyz="0 0 1")
    (found,) = reported("INE005", base + "".join(parts) + joint("base", "arm", "revolute") + wrist)
    assert found.message == naming(
        "arm", "fixed", "revolute", "arm_joint", "0, 0.5", "0.5 kg·m²", "0"
    )
    assert found.help == naming("tensor", "0")


def test_a_root_with_an_inertial_of_no_mass_is_not_to_be_given_one() -> None:
    """ayspot_a0: "give it an <inertial>" beside the <inertial>."""
    tensor = (0.01, 0, 0, 0.01, 0, 0.01)
    robot = part("base", 0, tensor, BALL) + part("arm", 1, tensor, BALL)
    found = reported("INE004", robot + joint("base", "arm", "revolute"), targets=("classic-ros1",))
    assert [one.help[:14] for one in found] == ["write its mass"]


def test_a_plant_of_one_kilogram_is_in_millimetres() -> None:
    """A program scales it as it loads it: its tensor is not the mistake."""
    wall = shape("collision", '<box size="300 300 300"/>')
    plant = link("plant", wall, inertial(1, (1, 1, 1.5)))
    robot = link("base") + plant + joint("base", "plant", "revolute")
    (found,) = reported("INE010", robot)
    assert "in mm" in found.help
    assert messages("INE006", robot) == []


@pytest.mark.parametrize(("mass", "is_cause"), [(2, True), (0.01, False)])
def test_a_torque_of_a_displaced_mass(mass: float, is_cause: bool) -> None:
    """Masses of an arm in the frame of its base: more effort is not the cure."""
    ball, inside = shape("collision", BALL), inertial(40, (1.0, 1.0, 1.0), "0 0 0.05")
    displaced = inertial(mass, (0.01, 0.01, 0.01), "0 0 0.7")
    swinging = joint("base", "arm", "revolute").replace("<limit", '<axis xyz="0 1 0"/><limit')
    hand = link("hand", ball, displaced) + joint("arm", "hand", xyz="0 0 0.1")
    weight = () if is_cause else (ball, inside)
    (found,) = reported("DYN003", link("base") + link("arm", *weight) + swinging + hand)
    assert ("INE011" in found.help) is is_cause


@pytest.mark.parametrize(("name", "count"), [("BALLOON", 0), ("blimp_link", 0), ("TANK", 1)])
def test_helium(name: str, count: int) -> None:
    """BALLU, a biped that hangs from a balloon of 0.16 kg in 0.2 m³."""
    robot = (
        f'<link name="{name}"><inertial><mass value="0.15898"/><inertia ixx="0.0106" ixy="0" '
        'ixz="0" iyy="0.0106" iyz="0" izz="0.0081"/></inertial><collision><geometry>'
        '<cylinder radius="0.32" length="0.7"/></geometry></collision></link>'
    )
    assert len(messages("INE010", robot)) == count


@pytest.mark.parametrize(("value", "count"), [("0.001", 1), ("${m*0.01}", 0)])
def test_the_result_of_a_formula_has_no_misplaced_point(value: str, count: int) -> None:
    """The base of a differential drive, whose formulas are those of areas."""
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:property name="m" value="0.1"/><link name="a"><inertial><mass value="0.1"/>'
        f'<inertia ixx="0.0001" iyy="0.0002" izz="{value}" ixy="0" ixz="0" iyz="0"/>'
        "</inertial></link></robot>"
    )
    (found,) = reported("INE003", text.encode(), "r.xacro")
    assert found.help.count("ten times") == count


_CORNERS = ("0 0 0", "0.1 0 0", "0 0.1 0", "0 0 0.1")
_FACES = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))


@pytest.mark.parametrize(("name", "is_other"), [("right_steer", True), ("left_steer", False)])
def test_the_mesh_of_the_other_side(tmp_path: Path, name: str, is_other: bool) -> None:
    """yahboomcar's front_right_steer shows front_left_steer.STL: its tensor is right."""
    facets = (" ".join(f"vertex {_CORNERS[corner]}" for corner in face) for face in _FACES)
    solid = " ".join(f"facet normal 0 0 0 outer loop {facet} endloop endfacet" for facet in facets)
    files = {"left_steer.stl": f"solid a {solid} endsolid a".encode()}
    moments = (7.5e-4, -1.25e-4, -1.25e-4, 7.5e-4, 1.25e-4, 7.5e-4)
    own = link(
        name,
        shape("collision", '<mesh filename="left_steer.stl"/>'),
        inertial(1, moments, "0.025 0.025 0.025"),
    )
    (found,) = meshed.reported(tmp_path, "INE006", own, files)
    assert ("left_steer.stl' is the mesh" in found.message) is is_other
    assert (found.fix is None) is is_other


def test_a_moment_of_a_wheel_whose_other_moments_are_far_from_its_own() -> None:
    """diffbot of ros2_control_demos: m/12 (3 r + h^2), m/12 r^2 and again, all three wrong."""
    moments = (0.0005675, 2.8125e-6, 2.8125e-6)
    wheel = shape("collision", '<cylinder radius="0.015" length="0.02"/>', rpy="1.5708 0 0")
    (found,) = reported("INE003", link("wheel", wheel, inertial(0.15, moments, rpy="1.5708 0 0")))
    assert found.help == 'write ixx="1.34375e-05" iyy="1.34375e-05" izz="1.6875e-05"'
