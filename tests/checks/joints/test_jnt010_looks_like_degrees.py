from math import radians

import pytest

from tests.jointed import joint, limit, of_xacro, robot
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit.text.diagnostic import Confidence


@pytest.mark.parametrize(
    ("lower", "upper", "turns"),
    [
        ("-180", "180", "28.6"),
        ("-90", "90", "14.3"),
        ("0", "45.0", "7.2"),
        ("-1", "135", "21.5"),
        ("-360", "360", "57.3"),
    ],
)
def test_an_angle_that_has_a_name(lower: str, upper: str, turns: str) -> None:
    text = robot(joint("j", "revolute", limit(lower, upper)))
    (found,) = reported("JNT010", text)
    assert f"[{float(lower):g}, {float(upper):g}] rad, {turns} turns" in found.message
    assert found.confidence is Confidence.INFERRED
    assert places("JNT010", text) == [(4, limit(lower, upper))]
    text = fixed("JNT010", text)
    ends = [f"{radians(float(end)):.10g}" for end in (lower, upper)]
    assert limit(*(end if end != "0" else "0" for end in ends)) in text
    assert reported("JNT010", text) == []


def test_ranges_that_differ_from_joint_to_joint() -> None:
    text = robot(
        joint("a", "revolute", limit("-170", "170")), joint("b", "revolute", limit("-120", "65"))
    )
    assert [message.partition(" has")[0] for message in messages("JNT010", text)] == [
        "joint 'a'",
        "joint 'b'",
    ]


def test_one_end_in_degrees() -> None:
    others = [joint(name, "revolute", limit("-1.7", "2.4")) for name in "ab"]
    for lower, upper in (("-94", "4.69"), ("-3.1", "180")):
        text = robot(*others, joint("j", "revolute", limit(lower, upper)))
        (message,) = messages("JNT010", text)
        assert message.endswith("decimal point")
        assert limit(lower, upper) in fixed("JNT010", text)
    assert messages("JNT010", robot(*others, joint("j", "revolute", limit("-3.1", "100")))) == []


@pytest.mark.parametrize(
    ("lower", "upper"),
    [
        ("-6.28", "6.28"),
        ("-6.9813", "6.9813"),  # an IRB 1600
        ("-7", "7"),
        ("-9.42477796077", "9.42477796077"),  # an ANYmal
        ("-10", "10"),  # a Solo
        ("-12", "12"),
        ("-100", "100"),
        ("-50", "50"),
        ("0", "1000"),
        ("-999999", "999999"),  # a Fetch
        ("-1e+16", "1e+16"),  # an Iris
        ("-174.532925", "174.532925"),  # a Jaco
        ("-31.4", "31.4"),
        ("90", "-90"),  # JNT003
        ("90", "90"),  # JNT003
    ],
)
def test_limits_of_real_robots_in_radians(lower: str, upper: str) -> None:
    assert reported("JNT010", robot(joint("j", "revolute", limit(lower, upper)))) == []


@pytest.mark.parametrize(
    ("ends", "count"),
    [("177.6", 1), *((ends, 0) for ends in "94.25 174.53 31.42 12.6 18.8 25.1 177.605".split())],
)
def test_angles_with_decimals(ends: str, count: int) -> None:
    """Not multiples of pi, of 10,000 degrees, or what a computer has converted."""
    others = [joint(name, "revolute", limit("-1.7", "2.4")) for name in "ab"]
    text = robot(*others, joint("j", "revolute", limit(f"-{ends}", ends)))
    assert len(reported("JNT010", text)) == count
    alone = robot(joint("j", "revolute", limit(f"-{ends}", ends)))
    assert reported("JNT010", alone) == []
    if count:
        assert limit(f"{-radians(float(ends)):.10g}", f"{radians(float(ends)):.10g}") in fixed(
            "JNT010", text
        )


@pytest.mark.parametrize(("lower", "count"), [("-6.999", 1), ("-7.001", 0)])
def test_about_a_turn_may_be_in_radians_at_one_end(lower: str, count: int) -> None:
    assert len(reported("JNT010", robot(joint("j", "revolute", limit(lower, "90"))))) == count


def test_round_numbers_alone_are_no_evidence() -> None:
    free = [joint(f"j{size}", "revolute", limit(f"-{size}", f"{size}")) for size in (50, 100, 300)]
    assert reported("JNT010", robot(*free)) == []
    assert reported("JNT010", robot(*free, joint("a", "revolute", limit("-33", "33")))) == []
    assert len(reported("JNT010", robot(*free, joint("a", "revolute", limit("-65", "20"))))) == 4


@pytest.mark.parametrize("kind", ["prismatic", "continuous", "fixed"])
def test_only_revolute_joints_have_angles_for_limits(kind: str) -> None:
    assert reported("JNT010", robot(joint("j", kind, limit("-90", "90")))) == []


def test_what_an_expression_gave_is_not_edited() -> None:
    text = of_xacro(robot(joint("j", "revolute", limit("${-90}", "90"))))
    assert [found.fix for found in reported("JNT010", text, "robot.xacro")] == [None]
    right = of_xacro(robot(joint("j", "revolute", limit("${radians(-90)}", "${pi/2}"))))
    assert reported("JNT010", right, "robot.xacro") == []


def test_one_joint_in_degrees_among_others_in_radians() -> None:
    small = [joint(f"j{n}", "revolute", limit("-2", "2")) for n in range(2)]
    odd = joint("odd", "revolute", limit("-137", "137"))
    assert len(messages("JNT010", robot(*small, odd))) == 1
    assert messages("JNT010", robot(odd)) == []
    free = joint("free", "revolute", limit("-100", "100"))
    assert messages("JNT010", robot(*small, free)) == []


def turned(rpy: str) -> str:
    return robot(joint("j", "fixed", f'<origin xyz="0 0 0" rpy="{rpy}"/>'))


@pytest.mark.parametrize(
    ("rpy", "worst", "better"),
    [
        ("90 0 0", ("90 rad", "14.3"), "1.570796327 0 0"),
        ("0 0 -180", ("-180 rad", "28.6"), "0 0 -3.141592654"),
        ("0 22.5 0", ("22.5 rad", "3.6"), "0 0.3926990817 0"),
        ("0 7 0", ("7 rad", "1.1"), "0 0.1221730476 0"),
        ("90 5 -30", ("90 rad", "14.3"), "1.570796327 0.0872664626 -0.5235987756"),
        ("90 0 1.57", ("90 rad", "14.3"), "1.570796327 0 1.57"),
        ("360 0 0.0", ("360 rad", "57.3"), "6.283185307 0 0.0"),
        ("0 0 79.2", ("79.2 rad", "12.6"), "0 0 1.382300768"),
        ("1.57 0 -33.4", ("-33.4 rad", "5.3"), "1.57 0 -0.5829399702"),
    ],
)
def test_more_than_a_turn_in_whole_degrees(rpy: str, worst: tuple[str, str], better: str) -> None:
    (found,) = reported("JNT010", turned(rpy))
    assert found.message == naming("j", "rpy", *worst)
    assert found.confidence is Confidence.INFERRED
    assert places("JNT010", turned(rpy)) == [(4, rpy)]
    assert f'rpy="{better}"' in fixed("JNT010", turned(rpy))


@pytest.mark.parametrize(
    "rpy",
    [
        "0 0 0",
        "1.5708 0 3.14159",
        "0 0 6.283185307179586",
        "0 0 6.2832",
        "-6 5 4",
        "0 0 4.71238898038469",
        "7.853981633974483 0 0",  # 5/2 pi
        "0 0 14.14",  # 9/2 pi
        "0 0 13.123",
        "0 0 7.25",
        "0 0 1000",
        "90 0",  # URD006
        "90 0 x",  # URD005
    ],
)
def test_angles_in_radians(rpy: str) -> None:
    assert reported("JNT010", turned(rpy)) == []


@pytest.mark.parametrize("part", ["visual", "collision", "inertial"])
def test_the_origins_in_links(part: str) -> None:
    text = f'<link name="a"><{part}><origin rpy="0 90 0"/></{part}></link>' + robot(
        joint("j", "fixed")
    )
    (message,) = messages("JNT010", text)
    assert message == naming("a", f"<{part}>", "rpy", "90 rad", "14.3")


def test_an_origin_elsewhere_is_not_urdf() -> None:
    text = robot(joint("j", "fixed")) + '<gazebo><origin rpy="0 90 0"/></gazebo>'
    assert reported("JNT010", text) == []


def test_an_rpy_of_an_expression_is_not_edited() -> None:
    text = of_xacro(turned("${90} 0 0"))
    assert [found.fix for found in reported("JNT010", text, "robot.xacro")] == [None]
    assert reported("JNT010", of_xacro(turned("${radians(90)} 0 0")), "robot.xacro") == []


def arm(*velocities: str, kind: str = "revolute") -> str:
    """Joints ``j0``, ``j1`` ... of some velocities."""
    return robot(
        *(
            joint(f"j{number}", kind, limit("-1", "1", velocity=velocity))
            for number, velocity in enumerate(velocities)
        )
    )


@pytest.mark.parametrize(
    ("velocities", "suspects"),
    [
        (("180",), ["j0"]),
        (("90", "90", "90"), ["j0", "j1", "j2"]),
        (("155", "155", "230"), ["j0", "j1", "j2"]),  # a data sheet
        (("3.1", "2.5", "183"), ["j2"]),  # 3.2 rad/s
    ],
)
def test_degrees(velocities: tuple[str, ...], suspects: list[str]) -> None:
    found = [message.partition(" has")[0] for message in messages("JNT010", arm(*velocities))]
    assert found == [f"joint '{name}'" for name in suspects]


def test_a_wheel_whose_ends_are_none_may_be_fast() -> None:
    wheels = [joint(f"j{i}", "revolute", limit("-1e9", "1e9", velocity=v)) for i, v in
              enumerate(("73", "92"))]  # fmt: skip
    assert reported("JNT010", robot(*wheels)) == []


def test_the_fix_is_the_same_speed_in_radians() -> None:
    (found,) = reported("JNT010", arm("225"))
    assert "225 rad/s" in found.message
    assert "(3.93 rad/s)" in found.message
    text = fixed("JNT010", arm("225"))
    assert f'velocity="{radians(225):.10g}"' in text
    assert reported("JNT010", text) == []


@pytest.mark.parametrize(
    "velocities",
    [
        ("100", "100"),
        ("1000",),
        ("50", "3"),
        ("20", "30", "37"),  # a G1
        ("30.1", "28.6"),
        ("111", "28.8"),  # the wheels of an Upkie
        ("100", "100.7"),
        ("50000", "1.79769e+308"),
        ("155",),
    ],
)
def test_fast_motors_and_placeholders(velocities: tuple[str, ...]) -> None:
    assert messages("JNT010", arm(*velocities)) == []


def test_wheels_are_fast() -> None:
    assert messages("JNT010", arm("180", kind="continuous")) == []


def test_a_robot_of_one_link() -> None:
    shape = '<origin rpy="90 0 0"/><geometry><sphere radius="1"/></geometry>'
    assert len(messages("JNT010", f'<link name="a"><visual>{shape}</visual></link>')) == 1


def test_radians_that_were_converted_the_wrong_way() -> None:
    text = robot(joint("j", "revolute", limit("-177.616916", "177.616916")))
    (message,) = messages("JNT010", text)
    assert message == naming("j", "[-177.617, 177.617] rad", "28.3")
    assert limit("-3.099999991", "3.099999991") in fixed("JNT010", text)


@pytest.mark.parametrize(
    ("name", "end", "count"),
    [("left_steering_joint", "35", 1), ("arm", "35", 0), ("steer", "100", 0), ("steer", "0.6", 0)],
)
def test_a_wheel_is_not_steered_by_several_turns(name: str, end: str, count: int) -> None:
    assert len(messages("JNT010", robot(joint(name, "revolute", limit(f"-{end}", end))))) == count


@pytest.mark.parametrize(
    ("name", "end", "is_fixed"),
    [
        ("wheel1_joint", "180", False),  # the road wheels of a Bunker
        ("wheel1_joint", "90", True),
        ("wheel_steering", "180", True),
        ("caster_wheel", "180", True),
        ("arm", "180", True),
    ],
)
def test_a_wheel_that_rolls_is_not_stopped_after_a_turn(
    name: str, end: str, is_fixed: bool
) -> None:
    (found,) = reported("JNT010", robot(joint(name, "revolute", limit(f"-{end}", end))))
    assert (found.fix is not None) is is_fixed
    assert ('type="continuous"' in found.help) is not is_fixed


@pytest.mark.parametrize(
    ("lower", "upper", "others", "count"),
    [
        ("-2.61799", "297.38201", 2, 1),  # ${300 - home}
        ("-297.38201", "2.61799", 2, 1),
        ("-2.61799", "297.38201", 1, 0),
        ("-12.61799", "297.38201", 2, 0),  # both ends beyond a turn
        ("0", "297.38201", 2, 0),  # a spool
        ("-2.61799", "11.38201", 2, 0),
    ],
)
def test_one_end_of_which_a_part_is_in_degrees(
    lower: str, upper: str, others: int, count: int
) -> None:
    joints = [joint(name, "revolute", limit("-1.7", "2.4")) for name in "ab"[:others]]
    heard = messages("JNT010", robot(*joints, joint("j", "revolute", limit(lower, upper))))
    assert [one.split("'")[1] for one in heard] == ["j"] * count
