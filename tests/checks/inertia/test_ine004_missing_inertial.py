import pytest

from tests.conftest import MISSION
from tests.massive import BALL, inertial, joint, link, shape
from tests.naming import naming
from tests.reported import messages, places
from tests.reported import reported as reported_by
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Diagnostic, Severity

HEAVY = inertial(1, (0.1, 0.1, 0.1))
VISUAL = shape("visual", BALL)
BASE = link("base", HEAVY)


def reported(text: str, *targets: str) -> list[Diagnostic]:
    return reported_by("INE004", text, targets=targets)


@pytest.mark.parametrize(
    ("targets", "severity"),
    [
        ((), Severity.INFO),
        (("ros2", "moveit"), Severity.INFO),
        (("classic-ros1",), Severity.ERROR),
        (("ros2", "gz-harmonic"), Severity.ERROR),
    ],
)
def test_the_severity(targets: tuple[str, ...], severity: Severity) -> None:
    robot = BASE + link("arm", VISUAL) + joint("base", "arm", "continuous")
    (found,) = reported(robot, *targets)
    assert found.severity is severity
    assert found.message == naming("arm", "continuous", "arm_joint", "Gazebo")
    assert (found.span.line, found.span.text) == (4, '<link name="arm">')


def test_mujoco_takes_the_mass_from_collisions() -> None:
    robot = BASE + link("arm", VISUAL) + joint("base", "arm", "continuous")
    (found,) = reported(robot, "mujoco")
    assert found.message == naming("arm", "continuous", "arm_joint", "MuJoCo", "rejects")
    (found,) = reported(robot.replace("visual", "collision"), "mujoco")
    assert found.severity is Severity.WARNING
    assert found.message == naming(
        "arm", "continuous", "arm_joint", "<inertial>", "MuJoCo", "1000 kg/m³"
    )


def test_pybullet_gives_every_link_a_kilogram() -> None:
    robot = link("frame") + BASE + joint("frame", "base") + link("arm", HEAVY)
    robot += joint("base", "arm", "revolute") + link("tip") + joint("arm", "tip")
    (found,) = reported(robot, "pybullet")
    assert found.severity is Severity.WARNING
    assert found.message == naming("tip", "<inertial>", "PyBullet", "1 kg")
    assert reported(robot, "classic-ros1") == []
    assert reported(robot.replace(link("tip"), link("tip", HEAVY)), "pybullet") == []


def test_what_goes_with_it_is_named() -> None:
    robot = BASE + link("arm", VISUAL) + joint("base", "arm", "revolute") + link("frame")
    robot += joint("arm", "frame")
    for number in range(6):
        above = f"l{number - 1}" if number else "arm"
        robot += link(f"l{number}", HEAVY) + joint(above, f"l{number}", "prismatic")
    (found,) = reported(robot, "gz-jetty")
    assert found.message == naming("arm", "revolute", "arm_joint", "Gazebo", "l0", "l1", "l2", "3")


@pytest.mark.parametrize(
    "robot",
    [
        BASE + link("arm", VISUAL) + joint("base", "arm"),  # becomes a part of the base
        BASE
        + link("arm", VISUAL)
        + joint("base", "arm", "continuous")
        + link("hand", HEAVY)
        + joint("arm", "hand"),  # what is fixed to it has the mass
        BASE + link("tip") + joint("base", "tip", "continuous"),  # a frame without a shape
        link("dummy") + BASE + joint("dummy", "base"),  # the usual fix for KDL
        link("world") + BASE + joint("world", "base", "floating"),
        BASE + link("arm", inertial(0, (1, 1, 1)), VISUAL) + joint("base", "arm", "revolute"),
        BASE
        + link("arm", '<inertial><mass value="1.1*0.3"/></inertial>', VISUAL)
        + joint("base", "arm", "revolute"),  # no number (URD005)
    ],
)
def test_what_is_all_right_or_another_rule_s(robot: str) -> None:
    assert reported(robot, "classic-ros1") == []


def test_a_root_without_mass_loses_the_robot_in_gazebo() -> None:
    robot = link("base", VISUAL) + link("arm", HEAVY) + joint("base", "arm", "continuous")
    assert reported(robot) == reported(robot, "mujoco") == []
    (found,) = reported(robot, "gz-fortress")
    assert found.message == naming("base", "Gazebo", "arm")


def test_a_fixed_joint_that_gazebo_keeps_needs_a_mass() -> None:
    robot = BASE + link("arm", VISUAL) + joint("base", "arm")
    kept = "<gazebo reference='arm_joint'><preserveFixedJoint>true</preserveFixedJoint></gazebo>"
    assert reported(robot) == []
    (found,) = reported(robot + kept)
    assert found.help == naming("<inertial>", "<preserveFixedJoint>")


def test_the_mission_s_model_has_a_massless_root_and_nothing_is_said() -> None:
    assert engine.check(MISSION, select=["INE004"]).diagnostics == ()


ARM = link("base", VISUAL) + link("arm", VISUAL) + joint("base", "arm", "revolute")


@pytest.mark.parametrize("mass", [0.0, 1.0])
def test_a_robot_without_mass_is_one_finding(mass: float) -> None:
    assert messages("INE004", ARM) == [naming("none", "2")]
    assert places("INE004", ARM) == [(1, '<robot name="example">')]
    assert messages("INE004", link("base", VISUAL)) == [naming("no mass")]
    assert messages("INE004", '<robot name="parts"/>') == []
    robot = ARM + link("hand", inertial(mass, (1, 1, 1))) + joint("arm", "hand")
    assert any("none of the" in one for one in messages("INE004", robot)) is (mass == 0)


TENSOR = (1e-10, 1e-10, 1e-10)


def tip(mass: float, kind: str = "prismatic") -> str:
    return BASE + link("tip", inertial(mass, TENSOR)) + joint("base", "tip", kind)


def test_a_tiny_mass() -> None:
    assert messages("INE004", tip(1e-10)) == [
        naming("tip", "1e-10 kg", "prismatic", "tip_joint", "Gazebo", "1e-06 kg")
    ]
    assert places("INE004", tip(1e-10)) == [(4, "1e-10")]
    assert len(messages("INE004", tip(1e-6))) == 1
    light = link("tip", '<inertial><mass value="1e-10"/></inertial>')
    assert len(messages("INE004", BASE + light + joint("base", "tip", "prismatic"))) == 1


@pytest.mark.parametrize(
    "robot",
    [
        tip(1.1e-6),
        tip(1e-10, "fixed"),
        tip(0),
        tip(1e-10) + link("pad", inertial(0.01, (1, 1, 1))) + joint("tip", "pad"),
    ],
)
def test_other_masses(robot: str) -> None:
    assert messages("INE004", robot) == []


ON_PLATE = (
    link("base", HEAVY)
    + link("plate")
    + link("arm", HEAVY)
    + joint("base", "plate")
    + joint("plate", "arm", "continuous")
)


def test_a_joint_on_a_massless_plate() -> None:
    assert messages("INE004", ON_PLATE) == [naming("arm_joint", "plate", "fixed", "Gazebo", "arm")]
    assert places("INE004", ON_PLATE) == [(8, '<joint name="arm_joint" type="continuous">')]


@pytest.mark.parametrize(
    "robot",
    [
        ON_PLATE.replace(link("plate"), link("plate", HEAVY)),
        ON_PLATE.replace('<parent link="plate"/>', '<parent link="base"/>'),
        ON_PLATE + link("bolt", HEAVY) + joint("plate", "bolt"),  # which is merged into the plate
        ON_PLATE.replace('"base"', '"world"').replace(HEAVY, "", 1),  # a joint that Gazebo keeps
        link("plate")
        + link("base", HEAVY)
        + joint("plate", "base")
        + link("arm", HEAVY)
        + joint("plate", "arm", "continuous"),  # the root
    ],
)
def test_what_older_gazebo_keeps(robot: str) -> None:
    assert not any("older Gazebo" in message for message in messages("INE004", robot))


@pytest.mark.parametrize(
    ("robot", "target", "severity"),
    [
        (ARM, "moveit", Severity.INFO),
        (ARM, "mujoco", Severity.ERROR),
        (ARM, "gz-jetty", Severity.ERROR),
        (tip(1e-10), "ros2", Severity.INFO),
        (tip(1e-10), "gz-harmonic", Severity.INFO),
        (tip(1e-10), "gz-fortress", Severity.WARNING),
        (ON_PLATE, "gz-harmonic", Severity.INFO),
        (ON_PLATE, "classic-ros1", Severity.WARNING),
    ],
)
def test_the_severity_of_each_case(robot: str, target: str, severity: Severity) -> None:
    (found,) = reported(robot, target)
    assert found.severity is severity


def test_merged_frames_whose_masses_are_zero() -> None:
    """The frames of the cameras of SoftBank's Pepper and Romeo; libsdformat 12.3 rejects both."""
    zero = inertial(0, (0, 0, 0))
    robot = BASE + link("camera", zero) + joint("base", "camera")
    assert reported(robot, "classic-ros1") == []
    robot += link("optical", zero) + joint("camera", "optical")
    (found,) = reported(robot, "classic-ros1")
    assert found.severity is Severity.ERROR
    assert found.message == naming("optical", "camera", "optical_joint", "0", "Gazebo")
    assert found.span.text.startswith("<inertial>")
    (found,) = reported(robot)
    assert found.severity is Severity.INFO
    assert reported(robot.replace(link("optical", zero), link("optical")), "classic-ros1") == []


def legs(right: str, more: str = "") -> str:
    """Two shins with fixed feet, of which one shin may have no mass of its own."""
    foot = link("left_foot", HEAVY) + link("right_foot", HEAVY)
    feet = joint("left_shin", "left_foot") + joint("right_shin", "right_foot")
    shins = link("left_shin", VISUAL, HEAVY) + link("right_shin", VISUAL, right)
    hips = joint("base", "left_shin", "revolute") + joint("base", "right_shin", "revolute")
    return BASE + shins + foot + hips + feet + more


def test_one_link_without_the_inertial_of_its_counterpart() -> None:
    assert reported(legs(HEAVY)) == []
    (found,) = reported(legs(""))
    assert found.severity is Severity.WARNING
    assert found.message == naming("right_shin", "<inertial>", "left_shin", "1 kg")
    assert found.span.text == '<link name="right_shin">'
    assert [note.span.text for note in found.related] == ["<inertial>"]


def test_several_links_without_the_inertials_of_their_counterparts() -> None:
    """All of one side, which may be a frame: this is no omission of one."""
    more = link("left_lamp", VISUAL, HEAVY) + link("right_lamp", VISUAL)
    more += joint("base", "left_lamp") + joint("base", "right_lamp")
    assert reported(legs("", more)) == []
    frames = link("left_tip", HEAVY) + link("right_tip")
    frames += joint("left_foot", "left_tip") + joint("right_foot", "right_tip")
    assert reported(legs(HEAVY, frames)) == []


def test_a_mass_that_is_not_an_attribute() -> None:
    """As in SDF, which URD003 reports: the robot has a mass."""
    inertial = "<inertial><mass>{}</mass></inertial>"
    robot = BASE + link("arm") + joint("base", "arm", "continuous")
    for value, count in (("12", 0), ("", 1)):
        massive = robot.replace(BASE, link("base", inertial.format(value)))
        assert len(reported(massive, "classic-ros1")) == count
