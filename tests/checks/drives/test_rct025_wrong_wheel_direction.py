"""RCT025: see the rule."""

from pathlib import Path

import pytest

from tests.driving import DRIVE, place, reported
from tests.gazebos import BASE, WHEELS, plugin, wheel
from tests.jointed import joint, robot
from tests.naming import naming
from tests.reported import messages, places
from tests.reported import reported as reported_of


def test_swapped_lists(tmp_path: Path) -> None:
    swapped = DRIVE.replace("left_joint", "?").replace("right_joint", "left_joint")
    (found,) = reported(tmp_path, "RCT025", swapped.replace("?", "right_joint"))
    assert found.message == naming(
        "drive", "left", "right_joint", "0.3 m", "right", "left_joint", "forwards"
    )
    assert place(found) == ("c.yaml", 7, "right_joint")


def test_front_and_rear_instead_of_left_and_right(tmp_path: Path) -> None:
    robot = BASE + "".join(
        wheel(f"{end}_{side}", y).replace(f'xyz="0 {y} 0"', f'xyz="{x} {y} 0"')
        for end, x in (("front", 1), ("rear", -1))
        for side, y in (("left", 0.15), ("right", -0.15))
    )
    names = ("[front_left_joint, front_right_joint]", "[rear_left_joint, rear_right_joint]")
    text = DRIVE.replace("[left_joint]", names[0]).replace("[right_joint]", names[1])
    (found,) = reported(tmp_path, "RCT025", text, robot)
    assert found.message == naming(
        "drive", "left", "front_right_joint", "0.3 m", "right", "rear_left_joint", "forwards"
    )
    right = text.replace("front_right", "?").replace("rear_left", "front_right")
    assert reported(tmp_path, "RCT025", right.replace("?", "rear_left"), robot) == []


def test_opposite_axes_of_a_controller(tmp_path: Path) -> None:
    crossed = BASE + wheel("left", 0.15) + wheel("right", -0.15, axis="0 -1 0")
    (found,) = reported(tmp_path, "RCT025", DRIVE, crossed)
    assert "are opposite" in found.message


def test_valid_wheels_are_accepted(tmp_path: Path) -> None:
    assert reported(tmp_path, "RCT025", DRIVE) == []
    unknown = DRIVE.replace("[left_joint]", "[elsewhere]")
    assert reported(tmp_path, "RCT025", unknown) == []
    one_behind_the_other = BASE + wheel("left", 0.15, axis="1 0 0") + wheel("right", -0.15)
    assert reported(tmp_path, "RCT025", DRIVE, one_behind_the_other) == []


# --- drive plugins of Gazebo

LIBRARY = "libgazebo_ros_diff_drive.so"


def drive(robot: str = WHEELS, left: str = "left", right: str = "right", more: str = "") -> str:
    tags = f"<leftJoint>{left}_joint</leftJoint><rightJoint>{right}_joint</rightJoint>"
    return robot + plugin(LIBRARY, tags + more)


def wheels(left: str, right: str) -> str:
    return BASE + wheel("left", 0.15, axis=left) + wheel("right", -0.15, axis=right)


def test_sides_of_a_plugin_are_swapped() -> None:
    (message,) = messages("RCT025", drive(left="right", right="left"))
    assert message == naming(
        "p", LIBRARY, "left", "right_joint", "0.3 m", "right", "left_joint", "forwards"
    )


def test_both_axes_turned_reverse_the_robot() -> None:
    assert len(reported_of("RCT025", drive(wheels("0 -1 0", "0 -1 0")))) == 1
    backwards = drive(wheels("0 -1 0", "0 -1 0"), "right", "left")
    assert reported_of("RCT025", backwards) == [], "it drives along -x, and left is left of that"


def test_opposite_axes_of_a_plugin() -> None:
    (message,) = messages("RCT025", drive(wheels("0 1 0", "0 -1 0")))
    assert message == naming("p", LIBRARY, "left_joint", "right_joint")


@pytest.mark.parametrize(
    "text",
    [
        drive(),
        drive(wheels("1 0 0", "0 1 0")),  # no axle
        drive(wheels("0 0 1", "0 0 1")),  # upright tyres: see JNT033
        drive(left="right", right="left", more="<legacyMode>true</legacyMode>"),
        WHEELS + plugin("libvendor.so", "<leftJoint>right_joint</leftJoint>"),
    ],
)
def test_drives_in_the_right_direction(text: str) -> None:
    assert reported_of("RCT025", text) == []


# --- wheels without a known drive

NAMES = ("fl_wheel", "fr_wheel", "rl_wheel", "rr_wheel")


def rover(*axes: str, names: tuple[str, ...] = NAMES, kind: str = "continuous") -> str:
    return robot(
        *(joint(n, kind, f'<axis xyz="{axis}"/>') for n, axis in zip(names, axes, strict=True))
    )


@pytest.mark.parametrize("odd", range(4))
@pytest.mark.parametrize("way", [1, -1])
def test_one_of_four_wheels(odd: int, way: int) -> None:
    axes = [f"0 {way} 0"] * 4
    axes[odd] = f"0 {-way} 0"
    text = rover(*axes)
    message = naming(NAMES[odd], "3")
    assert messages("RCT025", text) == [message]
    assert places("RCT025", text) == [(4 + 2 * odd, f'<axis xyz="0 {-way} 0"/>')]


def test_axes_in_rotated_frames() -> None:
    turned = '<origin rpy="3.14159265 0 0"/><axis xyz="0 -1 0"/>'
    wheels = [joint(name, "continuous", '<axis xyz="0 1 0"/>') for name in NAMES[:3]]
    assert messages("RCT025", robot(*wheels, joint("rr_wheel", "continuous", turned))) == []


@pytest.mark.parametrize(
    "other",
    [
        rover("0 1 0", "0 -1 0", "0 1 0", "0 -1 0"),  # side against side, as a Scout
        rover("0 1 0", "0 1 0", "0 1 0", "0 1 0"),
        rover("0 1 0", "0 1 0", "0 1 0", "1 0 0"),  # JNT033
        rover("0 1 0", "0 1 0", "0 -1 0", names=NAMES[:3]),
        rover("0 1 0", "0 1 0", "0 1 0", "0 -1 0", names=(*NAMES[:3], "caster_wheel")),
        rover("0 1 0", "0 1 0", "0 1 0", "0 -1 0", kind="fixed"),
    ],
)
def test_axes_that_may_be_intended(other: str) -> None:
    assert messages("RCT025", other) == []


TO_LEFT = '<origin xyz="0 0.2 0"/><axis xyz="0 1 0"/>'
TO_RIGHT = '<origin xyz="0 -0.2 0"/><axis xyz="0 {} 0"/>'


def wheeled(name: str, inside: str, kind: str = "continuous") -> str:
    return (
        f'<link name="{name}_link"/>\n<joint name="{name}" type="{kind}"><parent link="base"/>'
        f'<child link="{name}_link"/>{inside}</joint>\n'
    )


def cart(right: str, *more: str, names: str = "{}_wheel") -> str:
    both = wheeled(names.format("left"), TO_LEFT) + wheeled(names.format("right"), right)
    return f'<link name="base"/>\n{both}{"".join(more)}'


def test_opposite_axes() -> None:
    text = cart(TO_RIGHT.format(-1))
    message = naming("right_wheel", "left_wheel")
    assert messages("RCT025", text) == [message]
    assert places("RCT025", text) == [(6, '<axis xyz="0 -1 0"/>')]


def test_axes_of_a_pair_in_rotated_frames() -> None:
    turned = TO_RIGHT.format(1).replace("/><axis", ' rpy="3.14159265 0 0"/><axis')
    assert len(messages("RCT025", cart(turned))) == 1
    assert messages("RCT025", cart(turned.replace("0 1 0", "0 -1 0"))) == []


FRONT = wheeled("front_wheel", '<origin xyz="0.2 0 0"/><axis xyz="1 0 0"/>')
REAR = wheeled("rear_left_wheel", TO_LEFT) + wheeled("rear_right_wheel", TO_RIGHT.format(-1))


@pytest.mark.parametrize(
    "text",
    [
        cart(TO_RIGHT.format(1)),
        cart(TO_RIGHT.format(-1), REAR),  # four wheels are compared
        cart(TO_RIGHT.format(-1), FRONT),  # an omnidirectional robot
        cart(TO_RIGHT.format(-1), names="{}_caster_wheel"),
        cart(TO_RIGHT.format(-1), names="{}_arm"),
        cart(TO_RIGHT.format(-1)).replace("continuous", "revolute"),
        cart('<origin xyz="0 -0.2 0"/><axis xyz="1 0 0"/>'),  # JNT025
    ],
)
def test_pairs_that_are_not_opposite(text: str) -> None:
    assert messages("RCT025", text) == []


# --- steering controllers and the car of gz sim

CAR = WHEELS + "".join(
    f'<link name="{side}_hub"/><joint name="{side}_steering" type="revolute">'
    f'<origin xyz="0.5 {y} 0"/><parent link="base"/><child link="{side}_hub"/><axis xyz="0 0 1"/>'
    '<limit lower="-0.5" upper="0.5" effort="1" velocity="1"/></joint>'
    for side, y in (("left", 0.1), ("right", -0.1))
)
STEERED = """\
controller_manager:
  ros__parameters:
    car:
      type: ackermann_steering_controller/AckermannSteeringController
car:
  ros__parameters:
    traction_joints_names: [right_joint, left_joint]
    steering_joints_names: [right_steering, left_steering]
    wheelbase: 0.5
"""


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("[right_joint", "[right_joint", ""),
        ("traction_joints", "rear_wheels", ""),
        ("[right_joint, left_joint]", "[left_joint, right_joint]", "0.3 m to the"),
        ("[right_steering, left", "[left_steering, right", "0.2 m to the"),
        ("[right_steering, left_steering]", "[left_steering]", ""),
        ("[right_steering, left", "[nothing, left", ""),
        ("ackermann_steering_controller/Ackermann", "my_controllers/My", ""),
    ],
)
def test_the_right_joint_comes_first(tmp_path: Path, old: str, new: str, message: str) -> None:
    found = reported(tmp_path, "RCT025", STEERED.replace(old, new), CAR)
    assert [message in finding.message for finding in found] == [True] * bool(message)
    assert all(one.help.endswith("the right joint") for one in found)


def test_steering_axes_that_point_down(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "RCT025", STEERED, CAR.replace('"0 0 1"', '"0 0 -1"'))
    assert "steers" in found.message
    backwards = CAR.replace('"0 1 0"', '"0 -1 0"')  # left is right there
    (found,) = reported(tmp_path, "RCT025", STEERED, backwards)
    assert "gets" in found.message


@pytest.mark.parametrize(
    ("first", "second", "count"),
    [("left", "right", 0), ("right", "left", 1)],
)
def test_the_car_of_gz_sim(first: str, second: str, count: int) -> None:
    tags = (
        "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>"
        f"<left_steering_joint>{first}_steering</left_steering_joint>"
        f"<right_steering_joint>{second}_steering</right_steering_joint>"
    )
    found = reported_of("RCT025", CAR + plugin("gz-sim-ackermann-steering-system", tags))
    assert len(found) == count


def quadrotor(*directions: str, places: tuple[str, ...] = ("1 0", "0 1", "-1 0", "0 -1")) -> str:
    """Rotors with their motors, in the order front, left, back, right."""
    text = BASE
    for number, (turning, at) in enumerate(zip(directions, places, strict=False)):
        inside = f'<origin xyz="{at} 0"/><axis xyz="0 0 1"/>'
        text += joint(f"motor_{number}", "continuous", inside, "base")
        names = f"<jointName>motor_{number}</jointName><linkName>motor_{number}_link</linkName>"
        names += f"<motorNumber>{number}</motorNumber>"
        tags = f"{names}<turningDirection>{turning}</turningDirection>"
        text += plugin("librotors_gazebo_motor_model.so", tags)
    return text


@pytest.mark.parametrize(
    ("directions", "wrong"),
    [
        (("cw", "ccw", "cw", "ccw"), ""),
        (("cw", "cw", "cw", "ccw"), "motor_1_link"),
        (("ccw", "ccw", "cw", "ccw"), "motor_0_link"),
        (("cw", "cw", "cw", "cw"), ""),
        (("cw", "cw", "ccw"), ""),
    ],
)
def test_three_of_four_rotors_turn_alike(directions: tuple[str, ...], wrong: str) -> None:
    found = messages("RCT025", quadrotor(*directions))
    assert [wrong in message.partition(",")[0] for message in found] == [True] * bool(wrong)
