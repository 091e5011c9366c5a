"""GAZ073: a driven wheel has next to no friction, or a fixed caster has much."""

from pathlib import Path

import pytest

from tests.naming import values
from tests.reported import messages, reported
from urdfkit import check

INERTIAL = """<inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>"""
BALL = '<collision><geometry><sphere radius="{}"/></geometry></collision>'
BASE = f"""<link name="base">{INERTIAL}</link>
<link name="ball">{BALL.format(0.05)}</link>
<joint name="b" type="fixed"><parent link="base"/><child link="ball"/>
<origin xyz="-0.3 0 -0.05"/></joint>""" + "".join(
    f"""<link name="{side}">{INERTIAL}{BALL.format(0.1)}</link>
<joint name="{side}_joint" type="continuous"><parent link="base"/><child link="{side}"/>
<origin xyz="0 {y} 0"/><axis xyz="0 1 0"/></joint>"""
    for side, y in (("left", 0.2), ("right", -0.2))
)
SURFACE = "<surface><friction><ode><mu>0.02</mu><mu2>0.02</mu2></ode></friction></surface>"
CLASSIC = """<gazebo><plugin name="d" filename="libgazebo_ros_diff_drive.so">
<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint></plugin></gazebo>"""
GZ = """<gazebo><plugin name="gz::sim::systems::DiffDrive" filename="gz-sim-diff-drive-system">
<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint></plugin></gazebo>"""
MECANUM = """<gazebo><plugin name="gz::sim::systems::MecanumDrive"
filename="gz-sim-mecanum-drive-system"><front_left_joint>left_joint</front_left_joint>
<front_right_joint>right_joint</front_right_joint></plugin></gazebo>"""


def friction(link: str, inside: str) -> str:
    return f'<gazebo reference="{link}">{inside}</gazebo>'


@pytest.mark.parametrize("drive", [CLASSIC, GZ])
@pytest.mark.parametrize(
    "inside",
    [
        "<mu1>0.01</mu1><mu2>0.01</mu2>",
        "<mu1>0.01</mu1><mu2>0.2</mu2>",
        '<mu1 value="0.0"/><mu2 value="0.05"/>',
        "<mu1>0</mu1>",
        "<mu1>0.01</mu1><mu2>0.01</mu2><fdir1>1 0 0</fdir1>",
        f"<collision>{SURFACE}</collision>",
    ],
)
def test_a_wheel_without_grip(drive: str, inside: str) -> None:
    (one,) = messages("GAZ073", BASE + drive + friction("left", inside))
    name, coefficient = values(one)
    assert (name, float(coefficient) < 0.1) == ("left", True)


def test_the_place_is_the_coefficient() -> None:
    both = friction("left", "<mu1>0.01</mu1>") + friction("right", "<mu2>0.02</mu2>")
    found = reported("GAZ073", BASE + GZ + both)
    assert [one.span.text for one in found] == ["<mu1>", "<mu2>"]


def test_the_wheels_of_a_controller(tmp_path: Path) -> None:
    (tmp_path / "c.yaml").write_text("""controller_manager:
  ros__parameters:
    drive: {type: diff_drive_controller/DiffDriveController}
drive:
  ros__parameters:
    left_wheel_names: [left_joint]
    right_wheel_names: [right_joint]
""")
    control = f"""<gazebo><plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin"
filename="gz_ros2_control-system"><parameters>{tmp_path}/c.yaml</parameters></plugin></gazebo>"""
    low = friction("right", "<mu1>0.001</mu1><mu2>0.001</mu2>")
    (tmp_path / "r.urdf").write_text(f'<robot name="r">{BASE}{control}{low}</robot>')
    (one,) = check(tmp_path / "r.urdf", select=["GAZ073"]).diagnostics
    assert "driven wheel 'right'" in one.message


@pytest.mark.parametrize(
    "text",
    [
        GZ + friction("left", "<mu1>0.1</mu1><mu2>0.1</mu2>"),
        GZ + friction("left", "<mu1>1</mu1><mu2>0.01</mu2>"),
        GZ + friction("left", "<mu1>0.01</mu1><mu2>1</mu2><fdir1>1 0 0</fdir1>"),
        GZ + friction("left", "<mu1>0.01</mu1><fdir1>1 0 0</fdir1>"),
        GZ + friction("ball", "<mu1>1</mu1><mu2>1</mu2><fdir1>1 0 0</fdir1>"),
        GZ + friction("ball", "<mu1>0.01</mu1><mu2>0.01</mu2>"),
        MECANUM + friction("left", "<mu1>0.01</mu1><mu2>0.01</mu2>"),
        friction("left", "<mu1>0.01</mu1><mu2>0.01</mu2>"),
    ],
)
def test_wheels_that_are_meant_so(text: str) -> None:
    assert messages("GAZ073", BASE + text) == []


@pytest.mark.parametrize(
    ("inside", "count"),
    [
        ("<mu1>0.01</mu1><mu2>0.01</mu2><fdir1>1 0 0</fdir1>", 1),
        ("<mu1>1</mu1><mu2>0.01</mu2><fdir1>1 0 0</fdir1>", 0),
        ("<mu1>0.01</mu1><mu2>0.01</mu2>", 0),  # links of their own may be the rollers
    ],
)
def test_a_wheel_with_rollers(inside: str, count: int) -> None:
    found = reported("GAZ073", BASE + MECANUM + friction("left", inside))
    assert [one.span.text for one in found] == ["<mu1>"] * count


@pytest.mark.parametrize("inside", ["<mu1>1</mu1><mu2>1</mu2>", "<mu1>0.5</mu1>"])
def test_a_caster_with_grip(inside: str) -> None:
    (one,) = messages("GAZ073", BASE + GZ + friction("ball", inside))
    assert "'ball' slides" in one


def test_casters_that_do_no_harm() -> None:
    much = friction("ball", "<mu1>1</mu1><mu2>1</mu2>")
    assert messages("GAZ073", BASE + much) == []
    assert messages("GAZ073", BASE + GZ) == []
    assert messages("GAZ073", BASE + GZ + friction("ball", "<mu1>1</mu1><mu2>0.1</mu2>")) == []
    lifted = BASE.replace("-0.3 0 -0.05", "-0.3 0 0.05")
    assert messages("GAZ073", lifted + GZ + much) == []
    turns = BASE.replace('name="b" type="fixed"', 'name="b" type="continuous"')
    assert messages("GAZ073", turns + GZ + much) == []


@pytest.mark.parametrize(
    ("left", "right", "drive", "words"),
    [
        ("<mu1>1</mu1>", "<mu1>0.5</mu1>", GZ, "coefficient of 0.5"),
        ("<mu1>1</mu1><mu2>0.6</mu2>", "<mu1>1</mu1><mu2>1</mu2>", CLASSIC, "'left' has a"),
        ("<mu1>1</mu1>", "<mu1>0.9</mu1>", GZ, ""),
        ("<mu1>1</mu1>", "<mu2>0.5</mu2>", GZ, ""),
        ("<mu1>1</mu1>", "", GZ, ""),
        ("<mu1>1</mu1>", "<mu1>0.5</mu1><fdir1>1 0 0</fdir1>", GZ, ""),
        ("<mu1>1</mu1>", "<mu1>0.5</mu1>", MECANUM, ""),
    ],
)
def test_unequal_wheels(left: str, right: str, drive: str, words: str) -> None:
    text = BASE + drive + friction("left", left) + friction("right", right)
    found = messages("GAZ073", text)
    assert [words in one for one in found] == [True] * bool(words)
    assert all("its counterpart" in one for one in found)


CORNERS = ("front_left", "front_right", "back_left", "back_right")
FOUR = f'<link name="base">{INERTIAL}</link>' + "".join(
    f"""<link name="{corner}">{INERTIAL}{BALL.format(0.1)}</link>
<joint name="{corner}_joint" type="continuous"><parent link="base"/><child link="{corner}"/>
<origin xyz="{x} {y} 0"/><axis xyz="0 1 0"/></joint>"""
    for corner, x, y in zip(CORNERS, (0.3, 0.3, -0.3, -0.3), (0.2, -0.2) * 2, strict=True)
)
DRIVE = "".join(f"<{corner}_joint>{corner}_joint</{corner}_joint>" for corner in CORNERS)
FOUR += f"""<gazebo><plugin name="gz::sim::systems::MecanumDrive"
filename="gz-sim-mecanum-drive-system">{DRIVE}</plugin></gazebo>"""


@pytest.mark.parametrize(
    ("directions", "attribute", "count"),
    [
        (("1 -1 0", "1 -1 0", "1 -1 0", "1 -1 0"), "gz:expressed_in", 1),
        (("1 -1 0", "1 1 0", "1 1 0", "1 -1 0"), "gz:expressed_in", 0),
        (("1 -1 0", "1 -1 0", "1 -1 0", "1 -1 0"), "frame", 0),  # each in that of its wheel
        (("1 -1 0", "1 -1 0", "1 -1 0"), "gz:expressed_in", 0),
    ],
)
def test_rollers_of_mecanum_wheels(directions: tuple[str, ...], attribute: str, count: int) -> None:
    surfaces = "".join(
        friction(corner, f'<mu1>1</mu1><fdir1 {attribute}="base">{direction}</fdir1>')
        for corner, direction in zip(CORNERS, directions, strict=False)
    )
    found = messages("GAZ073", FOUR + surfaces)
    assert [values(one) for one in found] == [["<fdir1>", "1 -1 0"]] * count


RIGHT = ("1 -1 0", "1 1 0", "1 1 0", "1 -1 0")
MIRRORED = ("1 1 0", "1 -1 0", "1 -1 0", "1 1 0")


@pytest.mark.parametrize(
    ("directions", "mu", "more", "words"),
    [
        (RIGHT, ("1", "0"), "", ""),
        (RIGHT, ("1", "1"), "", "does not roll sideways"),
        (RIGHT, ("0.9", "0.8"), "", "does not roll sideways"),
        (RIGHT, ("1", "0.3"), "", ""),
        (RIGHT, ("0", "1"), "", "is mirrored"),  # the grip is across fdir1
        (MIRRORED, ("1", "0"), "", "is mirrored"),
        (MIRRORED, ("0", "1"), "", ""),
        (MIRRORED, ("1", "0"), "turned", ""),  # the frame of another body
        (("1 0 0", "1 0 0", "0 1 0", "0 1 0"), ("1", "0"), "", ""),
        ((*MIRRORED[:3], "1 -1 0"), ("1", "0"), "", ""),
    ],
)
def test_friction_of_mecanum_wheels(
    directions: tuple[str, ...], mu: tuple[str, str], more: str, words: str
) -> None:
    body = more or "base"
    surfaces = "".join(
        friction(
            corner,
            f"<mu1>{mu[0]}</mu1><mu2>{mu[1]}</mu2>"
            f'<fdir1 gz:expressed_in="{body}">{direction}</fdir1>',
        )
        for corner, direction in zip(CORNERS, directions, strict=True)
    )
    turned = """<link name="turned"/><joint name="t" type="fixed"><parent link="base"/>
<child link="turned"/><origin rpy="0 0 1.5708"/></joint>"""
    found = messages("GAZ073", FOUR + turned + surfaces)
    assert bool(found) == bool(words)
    assert all(words in one for one in found)
