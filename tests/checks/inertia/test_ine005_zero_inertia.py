import pytest

from tests.massive import BALL, MESH, inertial, joint, link, part, shape
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Severity

ZERO = (0, 0, 0)
BASE = link("base", inertial(2, (1, 1, 1)))


def test_a_moving_link() -> None:
    robot = BASE + part("arm", 0.5, ZERO, BALL) + joint("base", "arm", "revolute")
    (found,) = reported("INE005", robot)
    assert found.message == naming("arm", "0.5 kg", "revolute", "arm_joint")
    assert found.help == naming("0.1 m", "0.002 kg·m²")
    assert places("INE005", robot) == [
        (5, '<inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/>')
    ]


@pytest.mark.parametrize(
    ("mass", "size", "in_mm"),
    [
        (6.0, "200 300 100", True),
        # a link that closes a loop: a density of 6000 kg/m³ in mm, but of 0.3 mm
        (1e-9, "0.2 0.3 0.1", False),
    ],
)
def test_a_shape_in_mm_is_large(mass: float, size: str, in_mm: bool) -> None:
    arm = part("arm", mass, ZERO, f'<box size="{size}"/>')
    (found,) = reported("INE005", BASE + arm + joint("base", "arm", "revolute"))
    assert ("in mm" in found.help) is in_mm


def test_without_a_shape_the_help_is_the_rule_s() -> None:
    robot = BASE + link("arm", shape("visual", MESH), inertial(0.5, ZERO))
    (found,) = reported("INE005", robot + joint("base", "arm", "revolute"))
    assert "compute" in found.help


@pytest.mark.parametrize(("size", "is_real"), [("0.01", True), ("0.000001", False)])
def test_a_placeholder_shape_gives_no_tensor(size: str, is_real: bool) -> None:
    """UUV Simulator's thrusters: Gazebo drops a link without collision."""
    tiny = f'<cylinder length="{size}" radius="{size}"/>'
    robot = BASE + part("arm", 0.001, ZERO, tiny) + joint("base", "arm", "revolute")
    (found,) = reported("INE005", robot)
    assert (found.fix is not None) is is_real
    assert found.help.startswith("a solid cylinder" if is_real else "write the tensor")


@pytest.mark.parametrize(
    ("axis", "severity"), [("0 1 0", Severity.WARNING), ("1 0 0", Severity.ERROR)]
)
def test_a_steering_carries_its_wheel(axis: str, severity: Severity) -> None:
    """The steering links of gz_ros2_control's test_ackermann_drive.xacro.urdf."""
    steering = link("steering", inertial(0.1, ZERO)) + joint("base", "steering", "revolute")
    wheel = link("wheel", inertial(1, (1, 1, 1))) + joint("steering", "wheel", "revolute")
    wheel = wheel.replace("<limit", f'<axis xyz="{axis}"/><limit')
    (found,) = reported("INE005", BASE + steering + wheel)
    assert found.severity is severity


def test_a_fixed_link_may_be_a_point() -> None:
    robot = BASE + link("arm", inertial(0.5, ZERO)) + joint("base", "arm")
    assert messages("INE005", robot) == []


def test_a_point_beside_another_link_turns_with_it() -> None:
    robot = BASE + link("arm", inertial(0.5, ZERO)) + joint("base", "arm", "revolute")
    other = link("hand", inertial(0.5, (1, 1, 1))) + joint("arm", "hand")
    assert messages("INE005", robot + other) == []
    apart = link("hand", inertial(0.5, ZERO)) + joint("arm", "hand", xyz="0 0 1")
    assert messages("INE005", robot + apart)[0] == naming(
        "arm", "fixed", "revolute", "arm_joint", "0, 0.25", "0.25 kg·m²", "0"
    )
    same = link("hand", inertial(0.5, ZERO)) + joint("arm", "hand")
    assert len(messages("INE005", robot + same)) == 1


def test_no_mass_is_another_rule_s() -> None:
    robot = BASE + link("arm", inertial(0, ZERO)) + joint("base", "arm", "revolute")
    assert messages("INE005", robot) == []


def test_all_links_of_an_export_are_one_finding() -> None:
    robot = BASE
    for above, name, mass in (("base", "a", 1), ("a", "b", 3), ("b", "c", 2)):
        robot += link(name, inertial(mass, ZERO)) + joint(above, name, "revolute")
    (found,) = reported("INE005", robot)
    assert found.message == naming("b", "3 kg", "revolute", "b_joint", "c", "a")


THIN = (0.02, 0.02, 0)


def rod(moments: tuple[float, ...], kind: str = "revolute") -> str:
    return BASE + link("rod", inertial(0.3, moments)) + joint("base", "rod", kind)


def test_a_rod_without_thickness() -> None:
    assert messages("INE005", rod(THIN)) == [
        naming("rod", "revolute", "rod_joint", "0, 0.02", "0.02 kg·m²", "0")
    ]
    assert [line for line, _ in places("INE005", rod(THIN))] == [5]


@pytest.mark.parametrize(
    "robot",
    [
        rod((0.02, 0.02, 1e-9)),
        rod(THIN, "fixed"),
        rod(THIN) + link("ball", inertial(1, (1, 1, 1))) + joint("rod", "ball"),
        rod((0.02, 0, 0)),  # INE003
    ],
)
def test_other_moments(robot: str) -> None:
    assert messages("INE005", robot) == []


def test_two_rods_across_each_other_are_thin_about_no_axis() -> None:
    other = link("bar", inertial(0.3, (0, 0.02, 0.02))) + joint("rod", "bar")
    assert messages("INE005", rod(THIN) + other) == []


def test_all_thin_links_are_one_finding() -> None:
    robot = rod(THIN)
    for above, name, mass in (("rod", "a", 3), ("a", "b", 1)):
        robot += link(name, inertial(mass, (0.03, 0.03, 0))) + joint(above, name, "revolute")
    (found,) = reported("INE005", robot)
    assert found.message.startswith("link 'a'")
    assert found.message == naming("a", "revolute", "a_joint", "0, 0.03", "0.03 kg·m²", "0", "2")
    assert len(found.related) == 2


@pytest.mark.parametrize(
    ("targets", "severity"), [((), Severity.WARNING), (("mujoco",), Severity.ERROR)]
)
def test_the_severity_of_a_thin_link(targets: tuple[str, ...], severity: Severity) -> None:
    (found,) = reported("INE005", rod(THIN), targets=targets)
    assert found.severity is severity


OTHER = (0.002, -1e-4, 3e-4, 0.007, 2e-4, 0.006)
WRITTEN = '<origin xyz="0 0 0"/>'


def arms(
    shape: str,
    rpy: str = "0 0 0",
    origin: str = WRITTEN,
    other: tuple[float, ...] = OTHER,
) -> str:
    """A left arm without inertia, and a right one; ``rpy`` is the left joint's."""
    left = link("left_arm", shape, inertial(1.8, ZERO).replace("<mass", f"{origin}<mass"))
    right = link("right_arm", shape, inertial(1.8, other, "0.1 0.02 0"))
    turn = joint("base", "left_arm", "revolute", "0 0.3 0").replace('0"/>', f'0" rpy="{rpy}"/>', 1)
    return BASE + left + right + turn + joint("base", "right_arm", "revolute", "0 -0.3 0")


BAR = shape("collision", '<box size="0.9 0.2 0.2"/>', "0 -0.1 0")


MIRRORED = 'write ixx="0.002" ixy="0.0001" ixz="{}" iyy="0.007" iyz="{}" izz="0.006" and xyz="{}"'


@pytest.mark.parametrize(
    ("rpy", "changed"),
    [
        ("0 0 0", ("0.0003", "-0.0002", "0.1 -0.02 0")),
        ("0 0 3.141592653589793", ("-0.0003", "0.0002", "-0.1 0.02 0")),
    ],
)
def test_the_counterpart_shows_the_intended_tensor(rpy: str, changed: tuple[str, ...]) -> None:
    """SHC-ASTRA's rover: the shape has 40 times the tensor of the other side."""
    (found,) = reported("INE005", arms(BAR, rpy))
    assert found.help == naming("right_arm", "0.002, 0.007, 0.006 kg·m²")
    assert found.fix is not None
    assert found.fix.title == MIRRORED.format(*changed)
    assert messages("INE012", arms(BAR, rpy)) == [], "INE005 reports it"


def test_a_centre_of_mass_that_cannot_be_written_leaves_the_tensor() -> None:
    (found,) = reported("INE005", arms(BAR, origin=""))
    assert found.fix is None


def test_a_counterpart_elsewhere_has_no_mirrored_tensor() -> None:
    (found,) = reported("INE005", arms(BAR).replace('"0 -0.3 0"', '"0.1 -0.3 0"'))
    assert found.help.startswith("its counterpart")
    assert found.fix is None


def test_a_counterpart_without_inertia_shows_nothing() -> None:
    """Pepper's hands, of which one has 1e-35 kg·m²."""
    found = reported("INE005", arms(BAR, other=(1e-35, 1e-35, 1e-35)))
    assert found != []
    assert not any("counterpart" in one.help for one in found)


def test_a_shape_that_agrees_with_the_counterpart() -> None:
    box = shape("collision", '<box size="0.19 0.058 0.1"/>', "0.1 -0.02 0")
    (found,) = reported("INE005", arms(box))
    assert found.help.startswith("a solid box")


def test_the_centre_of_a_shape_where_the_export_left_none() -> None:
    robot = BASE + link("arm", BAR, inertial(0.5, ZERO).replace("<mass", f"{WRITTEN}<mass"))
    (found,) = reported("INE005", robot + joint("base", "arm", "revolute"))
    assert found.fix is not None
    assert found.fix.title.endswith(' and xyz="0 -0.1 0"')
