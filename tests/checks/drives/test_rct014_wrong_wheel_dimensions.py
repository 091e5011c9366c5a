from pathlib import Path

import pytest

from tests.controls import controller, reported_with_file
from tests.gazebos import BASE, WHEELS
from tests.gazebos import plugin as gazebo_plugin
from tests.gazebos import wheel as tyre
from tests.naming import naming
from tests.reported import messages, places
from tests.reported import reported as reported_anywhere
from urdfkit import Diagnostic
from urdfkit.text.diagnostic import Severity

DIFF = "diff_drive_controller/DiffDriveController"
ACKERMANN = "ackermann_steering_controller/AckermannSteeringController"
MECANUM = "mecanum_drive_controller/MecanumDriveController"


def wheel(name: str, x: float, y: float, radius: float = 0.1, shift: float = 0.0) -> str:
    """A wheel about y; its tyre is ``shift`` to the left of its joint."""
    return (
        f'<link name="{name}_link"><collision><origin xyz="0 {shift} 0" rpy="1.5707963 0 0"/>'
        f'<geometry><cylinder radius="{radius}" length="0.05"/></geometry></collision></link>'
        f'<joint name="{name}" type="continuous"><parent link="base"/><child link="{name}_link"/>'
        f'<origin xyz="{x} {y} 0"/><axis xyz="0 1 0"/></joint>'
    )


def robot(radius: float = 0.1, shift: float = 0.0) -> str:
    return '<link name="base"/>' + "".join(
        wheel(f"{end}{side}", x, sign * 0.2, radius, sign * shift)
        for end, x in (("f", 0.3), ("r", -0.3))
        for side, sign in (("l", 1), ("r", -1))
    )


def reported(directory: Path, text: str, model: str) -> list[Diagnostic]:
    return reported_with_file("RCT014", directory, text, "", model)


def drive(separation: float, radius: float) -> str:
    return controller(
        "d",
        DIFF,
        left_wheel_names="[fl, rl]",
        right_wheel_names="[fr, rr]",
        wheel_separation=str(separation),
        wheel_radius=str(radius),
    )


@pytest.mark.parametrize(
    ("parameter", "value", "count"),
    [
        ("wheel_separation_multiplier", "1.5", 1),
        ("left_wheel_radius_multiplier", "1.02", 1),
        ("wheel_separation_multiplier", "1.0", 2),
    ],
)
def test_a_length_that_is_multiplied(
    parameter: str, value: str, count: int, tmp_path: Path
) -> None:
    text = drive(0.3, 0.2).rstrip("\n") + f"\n    {parameter}: {value}\n"
    assert len(reported(tmp_path, text, robot())) == count


@pytest.mark.parametrize(
    ("separation", "factor", "count"), [(0.2, "1.3", 1), (0.2, "2.0", 0), (0.4, "0.5", 0)]
)
def test_a_separation_that_no_multiplier_explains(
    separation: float, factor: str, count: int, tmp_path: Path
) -> None:
    text = drive(separation, 0.1).rstrip("\n") + f"\n    wheel_separation_multiplier: {factor}\n"
    found = reported(tmp_path, text, robot())
    assert ["wheel_separation is" in one.message for one in found] == [True] * count


def test_one_wheel_with_a_misplaced_decimal_point(tmp_path: Path) -> None:
    model = '<link name="base"/>' + wheel("l", 0, 0.2) + wheel("r", 0, -0.2, radius=1.0)
    text = controller(
        "d",
        DIFF,
        left_wheel_names="[l]",
        right_wheel_names="[r]",
        wheel_separation="0.4",
        wheel_radius="0.1",
    )
    (found,) = reported(tmp_path, text, model)
    assert found.message == naming("d", "r_link", "1 m", "l_link", "0.1 m")
    assert found.span.text == '<cylinder radius="1.0" length="0.05"/>'
    (note, *_) = found.related
    assert note.span.text == '<cylinder radius="0.1" length="0.05"/>'


def test_wheel_of_a_plugin_with_another_radius_than_its_counterpart() -> None:
    model = BASE + tyre("left", 0.15, radius=0.01) + tyre("right", -0.15)
    tags = "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>"
    size = "<wheel_separation>0.3</wheel_separation><wheel_diameter>0.2</wheel_diameter>"
    text = model + gazebo_plugin("libgazebo_ros_diff_drive.so", tags + size)
    (found,) = messages("RCT014", text)
    assert "'left'" in found
    assert "0.01 m" in found


def test_separation(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, drive(0.3, 0.1), robot())
    assert found.message == naming("d", "wheel_separation", "0.3 m", "0.4 m")
    assert found.help == "write 0.4"
    assert found.span.source.path == str(tmp_path / "c.yaml")
    assert (found.span.line, found.span.text) == (6, "0.3")


@pytest.mark.parametrize(("separation", "found"), [(0.381, 0), (0.419, 0), (0.379, 1), (0.421, 1)])
def test_within_five_percent(separation: float, found: int, tmp_path: Path) -> None:
    assert len(reported(tmp_path, drive(separation, 0.1), robot())) == found


def test_radius(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, drive(0.4, 0.2), robot())
    assert found.message == naming("d", "wheel_radius", "0.2 m", "0.1 m")


@pytest.mark.parametrize(("separation", "radius"), [(0.4, 0.1), (0.419, 0.1049), (0.381, 0.0951)])
def test_within_calibration(tmp_path: Path, separation: float, radius: float) -> None:
    assert reported(tmp_path, drive(separation, radius), robot()) == []


def test_tyres_away_from_their_joints(tmp_path: Path) -> None:
    model = robot(shift=0.05)
    assert reported(tmp_path, drive(0.5, 0.1), model) == [], "between the tyres"
    assert reported(tmp_path, drive(0.4, 0.1), model) == [], "between the joints"
    (found,) = reported(tmp_path, drive(0.6, 0.1), model)
    assert found.message == naming("d", "wheel_separation", "0.6 m", "0.5 m")


@pytest.mark.parametrize(
    ("separation", "severity"), [(0.48, Severity.INFO), (0.3, Severity.WARNING)]
)
def test_several_wheels_on_a_side_may_be_calibrated(
    tmp_path: Path, separation: float, severity: Severity
) -> None:
    """BILLEE: three wheels on each side slip in turns, as if they were further apart."""
    (found,) = reported(tmp_path, drive(separation, 0.1), robot())
    assert found.severity is severity
    assert found.help.startswith("write 0.4")
    assert ("wheel_separation_multiplier" in found.help) is (severity is Severity.INFO)
    two = drive(separation, 0.1).replace(", rl", "").replace(", rr", "")
    (found,) = reported(tmp_path, two, robot())
    assert found.severity is Severity.WARNING


def test_unknown_dimensions(tmp_path: Path) -> None:
    mesh = robot().replace('<cylinder radius="0.1" length="0.05"/>', '<mesh filename="w.stl"/>')
    assert reported(tmp_path, drive(0.4, 7), mesh) == []
    (found,) = reported(tmp_path, drive(0.4, 7), robot().replace('"0.1"', '"0.3"', 1))
    assert "7 m" not in found.message, "two sizes"
    assert reported(tmp_path, drive(9, 9).replace("fl", "xl"), robot()) == [], "RCT001"
    assert reported(tmp_path, drive(9, 9).replace("9", "nine"), robot()) == []


def test_a_steered_car(tmp_path: Path) -> None:
    def car(wheelbase: float, track: float) -> str:
        return controller(
            "car",
            ACKERMANN,
            front_wheels_names="[fl, fr]",
            rear_wheels_names="[rl, rr]",
            wheelbase=str(wheelbase),
            rear_wheel_track=str(track),
        )

    assert reported(tmp_path, car(0.6, 0.4), robot()) == []
    found = reported(tmp_path, car(0.8, 0.5), robot())
    assert [one.message for one in found] == [
        naming("car", "0.8 m", "0.6 m"),
        naming("car", "rear_wheel_track", "0.5 m", "0.4 m"),
    ]


def test_the_wheelbase_of_front_wheel_drive(tmp_path: Path) -> None:
    """Monash Nova Rover's: the controller has no names for the wheels that only roll."""
    model = robot()
    for name in ("fl", "fr"):
        old = f'<joint name="{name}" type="continuous"><parent link="base"/>'
        pivot = f'<link name="p{name}"/><joint name="p{name}" type="continuous">'
        pivot += f'<parent link="base"/><child link="p{name}"/><axis xyz="0 0 1"/></joint>'
        model = model.replace(old, pivot + old.replace("base", f"p{name}"))
    names = {"front_wheels_names": "[pfl, pfr]", "rear_wheels_names": "[fl, fr]"}
    assert reported(tmp_path, controller("car", ACKERMANN, **names, wheelbase="0.6"), model) == []


def test_mecanum_wheels(tmp_path: Path) -> None:
    text = controller("m", MECANUM, front_left_wheel_command_joint_name="fl", kinematics="")
    (found,) = reported(tmp_path, text + "      wheels_radius: 0.3\n", robot())
    assert found.message == naming("m", "kinematics.wheels_radius", "0.3 m", "0.1 m")
    assert reported(tmp_path, text + "      wheels_radius: 0.1\n", robot()) == []


@pytest.mark.parametrize(("value", "count"), [("0.5", 0), ("0.3", 1), ("0.0", 1)])
def test_the_projection_of_mecanum_wheels(tmp_path: Path, value: str, count: int) -> None:
    names = {
        "front_left_wheel_command_joint_name": "fl",
        "rear_right_wheel_command_joint_name": "rr",
    }
    parameter = "sum_of_robot_center_projection_on_X_Y_axis"
    text = controller("m", MECANUM, **names, kinematics="") + f"      {parameter}: {value}\n"
    found = reported(tmp_path, text, robot())
    who = naming("m", f"kinematics.{parameter}", f"{float(value):g} m", "0.5 m")
    assert [one.message for one in found] == [who] * count


# --- drive plugins of Gazebo


def of_plugin(text: str) -> list[Diagnostic]:
    return reported_anywhere("RCT014", text)


DRIVE = "libgazebo_ros_diff_drive.so"
TAGS = "<leftJoint>left_joint</leftJoint><rightJoint>right_joint</rightJoint>"


def plugged(separation: str = "0.3", diameter: str = "0.2", robot: str = WHEELS) -> str:
    tags = f"<wheelSeparation>{separation}</wheelSeparation>"
    return robot + gazebo_plugin(DRIVE, f"{TAGS}{tags}<wheelDiameter>{diameter}</wheelDiameter>")


def test_a_wrong_diameter() -> None:
    assert messages("RCT014", plugged(diameter="0.1")) == [
        naming("p", DRIVE, "<wheelDiameter>", "0.1 m", "0.2 m")
    ]
    assert [text for _, text in places("RCT014", plugged(diameter="0.1"))] == ["<wheelDiameter>"]
    assert [found.help for found in of_plugin(plugged(diameter="0.1"))] == ["write 0.2"]


def test_a_wrong_separation() -> None:
    (message,) = messages("RCT014", plugged("0.15"))
    assert message == naming("p", DRIVE, "<wheelSeparation>", "0.15 m", "0.3 m")


@pytest.mark.parametrize(
    ("separation", "diameter", "count"),
    [("0.314", "0.209", 0), ("0.316", "0.2", 1), ("0.3", "0.211", 1), ("0.286", "0.191", 0)],
)
def test_the_bound_is_five_percent(separation: str, diameter: str, count: int) -> None:
    assert len(of_plugin(plugged(separation, diameter))) == count


def test_defaults_are_compared() -> None:
    heard = messages("RCT014", WHEELS + gazebo_plugin(DRIVE, TAGS))
    assert [message.partition(": ")[2].partition(", but")[0] for message in heard] == [
        "<wheelDiameter> is 0.15 m, the default",
        "<wheelSeparation> is 0.34 m, the default",
    ]


def test_tyre_that_is_not_at_the_joint() -> None:
    robot = BASE + tyre("left", 0.15, at=0.05) + tyre("right", -0.15, at=-0.05)
    assert of_plugin(plugged("0.4", robot=robot)) == []
    assert of_plugin(plugged("0.3", robot=robot)) == [], "nor is the distance of the joints"
    assert len(of_plugin(plugged("0.35", robot=robot))) == 1


def test_a_radius_of_a_plugin() -> None:
    joints = "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>"
    tags = "<wheel_separation>0.3</wheel_separation><wheel_radius>0.2</wheel_radius>"
    text = WHEELS + gazebo_plugin("gz-sim-diff-drive-system", joints + tags)
    (message,) = messages("RCT014", text)
    assert message == naming("p", "gz-sim-diff-drive-system", "<wheel_radius>", "0.2 m", "0.1 m")


def test_wheels_that_slip_may_have_a_larger_separation() -> None:
    names = [f"{side}{end}" for side in ("left", "right") for end in ("Front", "Rear")]
    joints = "".join(f"<{n}Joint>{n[: -4 if n[-1] == 'r' else -5]}_joint</{n}Joint>" for n in names)
    tags = "<wheelSeparation>{}</wheelSeparation><wheelDiameter>0.2</wheelDiameter>"
    file = "libgazebo_ros_skid_steer_drive.so"
    assert of_plugin(WHEELS + gazebo_plugin(file, joints + tags.format("0.5"))) == []
    assert len(of_plugin(WHEELS + gazebo_plugin(file, joints + tags.format("0.2")))) == 1


def test_mesh_has_no_known_radius() -> None:
    robot = WHEELS.replace('<cylinder radius="0.1" length="0.04"/>', '<mesh filename="w.stl"/>')
    assert of_plugin(plugged("5", "5", robot)) == []


def test_wheel_on_its_side_is_ignored() -> None:
    assert of_plugin(plugged("5", "5", WHEELS.replace("1.57079632679", "0"))) == []


def test_wheels_of_different_sizes_have_no_common_diameter() -> None:
    robot = BASE + tyre("left", 0.15) + tyre("right", -0.15, radius=0.2)
    (found,) = of_plugin(plugged(diameter="1", robot=robot))
    assert "<wheel_diameter>" not in found


def test_wheels_at_the_same_place(tmp_path: Path) -> None:
    wheels = "".join(wheel(name, 0, 0) for name in ("fl", "rl", "fr", "rr"))
    (found,) = reported(tmp_path, drive(0.3, 0.1), '<link name="base"/>' + wheels)
    assert found.help == naming("positions", "<origin>")


def test_an_axis_across_the_line_between_the_wheels(tmp_path: Path) -> None:
    """JNT033 reports the axis of a cylinder; the distance along it says nothing."""
    wrong = robot().replace('xyz="0 1 0"', 'xyz="1 0 0"').replace('rpy="1.5707963 0 0"', "")
    assert reported(tmp_path, drive(0.4, 0.1), wrong) == []
    assert len(reported(tmp_path, drive(0.3, 0.1), robot())) == 1


@pytest.mark.parametrize(("radius", "is_unit"), [(100.0, True), (10.0, True), (0.5, False)])
def test_a_model_in_another_unit(radius: float, is_unit: bool, tmp_path: Path) -> None:
    found = [
        one
        for one in reported(tmp_path, drive(0.4, 0.1), robot(radius))
        if "wheel_radius" in one.message
    ]
    help = "write the length in the model in m, not in another unit"
    assert [one.help for one in found] == [help if is_unit else f"write {radius:g}"]
