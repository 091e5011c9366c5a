from math import pi
from pathlib import Path

import pytest

from tests import meshed
from tests.conftest import MISSION
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.lint import engine
from urdfkit.mesh import samples

LINK = (
    '<link name="{}"><collision><origin xyz="{}" rpy="{}"/><geometry>{}</geometry></collision>'
    "</link>"
)
JOINT = (
    '<joint name="{0}_joint" type="fixed">\n<origin xyz="{1}" rpy="{2}"/><parent link="{0}"/>'
    '<child link="{3}"/></joint>\n'
)
BOX = '<box size="1 2 4"/>'


def robot(shape: str, height: float, turn: str = "0 0 0", own: str = "0 0 0") -> str:
    return (
        '<link name="base_footprint"/>'
        + LINK.format("base_link", own, "0 0 0", shape)
        + JOINT.format("base_footprint", f"0 0 {height}", turn, "base_link")
    )


@pytest.mark.parametrize(
    ("shape", "turn", "reach"),
    [
        (BOX, "0 0 0", 2),
        (BOX, f"{pi / 2} 0 0", 1),
        (BOX, f"0 {pi / 2} 0", 0.5),
        (BOX, f"0 {pi / 4} 0", (0.5 + 2) / 2**0.5),
        ('<sphere radius="0.3"/>', "1 2 3", 0.3),
        ('<cylinder radius="0.06" length="0.05"/>', "0 0 0", 0.025),
        ('<cylinder radius="0.06" length="0.05"/>', f"{-pi / 2} 0 0", 0.06),
        ('<cylinder radius="1" length="2"/>', f"{pi / 4} 0 0", 2**0.5),
        ('<capsule radius="1" length="2"/>', f"{pi / 4} 0 0", 1 + 0.5**0.5),
    ],
)
def test_the_lowest_point_of_every_primitive(shape: str, turn: str, reach: float) -> None:
    assert messages("TRE008", robot(shape, reach, turn)) == []
    assert messages("TRE008", robot(shape, reach - 0.006, turn)) == [
        naming("base_link", "0.006 m", "below", "base_footprint")
    ]
    assert messages("TRE008", robot(shape, reach + 0.006, turn)) == [
        naming("base_link", "0.006 m", "above", "base_footprint")
    ]


def test_tyres_give_way() -> None:
    assert messages("TRE008", robot(BOX, 2.0049)) == messages("TRE008", robot(BOX, 1.9951)) == []


def test_the_shape_s_own_origin_counts() -> None:
    assert messages("TRE008", robot(BOX, 1, own="0 0 1")) == []
    assert len(messages("TRE008", robot(BOX, 1, own="0 0 -1"))) == 1


def test_the_place_is_the_joint_below_the_footprint() -> None:
    assert places("TRE008", robot(BOX, 0)) == [
        (2, '<joint name="base_footprint_joint" type="fixed">')
    ]


def test_a_footprint_that_hangs_below_the_base() -> None:
    model = (
        LINK.format("base_link", "0 0 0", "0 0 0", BOX)
        + '<link name="base_footprint"/>'
        + JOINT.format("base_link", "0 0 {}", "0 0 0", "base_footprint")
    )
    assert messages("TRE008", model.format(-2)) == []
    assert messages("TRE008", model.format(-1.5)) == [
        naming("base_link", "0.5 m", "below", "base_footprint")
    ]


MESH = '<mesh filename="wheel.stl"/>'
SEEN = '<link name="wheel"><visual><geometry><sphere radius="1"/></geometry></visual></link>'


@pytest.mark.parametrize(
    "wheel",
    [
        LINK.format("wheel", "0 0 0", "0 0 0", MESH),
        LINK.format("wheel", "0 0 0", "0 0 0", '<box size="1 x 1"/>'),
        SEEN,
    ],
)
def test_what_cannot_be_measured_may_reach_the_ground_but_lifts_nothing(wheel: str) -> None:
    more = wheel + JOINT.format("base_link", "0 0 0", "0 0 0", "wheel")
    assert messages("TRE008", robot(BOX, 2.5) + more) == []
    assert len(messages("TRE008", robot(BOX, 1.5) + more)) == 1


def test_without_a_footprint_or_a_shape_nothing_is_said() -> None:
    assert reported("TRE008", robot(BOX, 0).replace("base_footprint", "base")) == []
    assert reported("TRE008", '<link name="base_footprint"/>') == []
    assert reported("TRE008", LINK.format("base_footprint", "0 0 0", "0 0 0", BOX)) == []


def test_the_mission_s_model() -> None:
    report = engine.check(MISSION, select=["TRE008"])
    (found,) = report.diagnostics
    assert found.span.text == '<joint name="base_footprint_joint" type="fixed">'
    assert "0.06 m below 'base_footprint'" in found.message


def test_the_height_is_not_known_where_a_mesh_may_reach_lower() -> None:
    wheel = LINK.format("wheel", "0 0 0", "0 0 0", '<mesh filename="wheel.stl"/>')
    text = robot(BOX, 1.9) + wheel + JOINT.format("base_link", "0 0 0", "0 0 0", "wheel")
    (found,) = reported("TRE008", text)
    assert found.fix is None
    assert reported("TRE008", robot(BOX, 1.9))[0].fix is not None


def test_a_leg_does_not_stand_as_it_is_at_zero() -> None:
    """The Unitree Go2: its legs are stretched there, and its footprint is its base."""
    hinge = JOINT.replace('type="fixed"', 'type="revolute"')
    thigh = LINK.format("thigh", "0 0 0", "0 0 0", BOX)
    foot = LINK.format("foot", "0 0 0", "0 0 0", BOX)
    hip = hinge.format("base_link", "0 0 -2", "0 0 0", "thigh")
    text = robot(BOX, 2) + thigh + hip
    assert len(reported("TRE008", text)) == 1, "one hinge may be that of a rocker"
    assert reported("TRE008", text + foot + hinge.format("thigh", "0 0 -2", "0 0 0", "foot")) == []


def car(wheel_height: float, caster_height: float, root: str = "base") -> str:
    """Two wheels of radius 0.1 and a caster of radius 0.05 below a base."""
    text = f'<link name="{root}"/>' + LINK.format(
        "caster", "0 0 0", "0 0 0", '<sphere radius="0.05"/>'
    )
    text += JOINT.format(root, f"-0.3 0 {caster_height}", "0 0 0", "caster")
    wheel = '<cylinder radius="0.1" length="0.04"/>'
    for side, y in (("left", 0.2), ("right", -0.2)):
        text += LINK.format(side, "0 0 0", f"{pi / 2} 0 0", wheel)
        text += (
            f'<joint name="{side}_joint" type="continuous">\n<origin xyz="0 {y} {wheel_height}"/>'
            f'<parent link="{root}"/><child link="{side}"/><axis xyz="0 1 0"/></joint>\n'
        )
    return text


@pytest.mark.parametrize(
    ("wheel_height", "caster_height", "gap"),
    [(0.1, 0.05, ""), (0.11, 0.05, ""), (0.4, 0.05, "0.3 m"), (0.1, -0.05, "0.1 m")],
)
def test_wheels_above_the_ground_without_a_footprint(
    wheel_height: float, caster_height: float, gap: str
) -> None:
    found = messages("TRE008", car(wheel_height, caster_height))
    assert found == ([naming("left", "right", gap, "caster")] if gap else [])


def test_thrusters_are_no_wheels() -> None:
    """The RexROV of UUV Simulator, whose thrusters turn without limits."""
    assert messages("TRE008", car(0.4, 0.05).replace("_joint", "_thruster_joint")) == []


@pytest.mark.parametrize(("kind", "count"), [("revolute", 0), ("continuous", 1)])
def test_pistons_that_follow_a_joint_of_an_arm_are_no_wheels(kind: str, count: int) -> None:
    """FANUC's M-900iB: the joints of its two pistons have no limits."""
    text = car(0.4, 0.05).replace(
        '<axis xyz="0 1 0"/>', '<axis xyz="0 1 0"/><mimic joint="elbow"/>'
    )
    elbow = (
        f'<link name="arm"/><joint name="elbow" type="{kind}"><axis xyz="0 1 0"/>'
        '<parent link="base"/><child link="arm"/></joint>'
    )
    assert len(messages("TRE008", text + elbow)) == count


def test_legs_that_turn_without_limits(tmp_path: Path) -> None:
    """A quadruped whose hips are continuous: what stands is a foot, a child of such a hip."""
    pytest.importorskip("numpy")
    text = car(0.4, 0.35) + LINK.format("foot", "0 0 0", "0 0 0", '<mesh filename="tyre.stl"/>')
    leg = text + JOINT.format("left", "0 0 -0.3", "0 0 0", "foot")
    body = text + JOINT.format("base", "0 0.2 0.1", "0 0 0", "foot")
    files = {"tyre.stl": TYRE}
    assert meshed.reported(tmp_path, "TRE008", leg, files) == []
    assert len(meshed.reported(tmp_path, "TRE008", body, files)) == 1


def test_the_fingers_of_a_robot_on_other_wheels() -> None:
    """Seed Noid: its wheels are revolute, and the fingers of both hands turn without limits."""
    text = car(0.4, 0.05)
    assert messages("TRE008", text.replace('"caster"', '"front_wheel"')) == []
    arms = text
    for side in ("left", "right"):
        above = "base"
        for name in (f"{side}_shoulder", f"{side}_elbow"):
            arms += f'<link name="{name}"/>' + JOINT.format(above, "0 0 0", "0 0 0", name).replace(
                f'"{above}_joint" type="fixed"', f'"{name}_joint" type="revolute"'
            )
            above = name
        arms = arms.replace(
            f'<parent link="base"/><child link="{side}"/>',
            f'<parent link="{above}"/><child link="{side}"/>',
        )
    assert messages("TRE008", arms) == []


#: A wheel of radius 0.1 m about its y axis.
TYRE = samples.stl(samples.box((-0.1, -0.02, -0.1), (0.1, 0.02, 0.1)))


def with_meshes(left: float, right: float) -> str:
    """Two wheels at two heights, with meshes, and a caster on the ground."""
    text = car(0.1, 0.05, "base_footprint")
    text = text.replace('<cylinder radius="0.1" length="0.04"/>', '<mesh filename="tyre.stl"/>')
    text = text.replace(f'rpy="{pi / 2} 0 0"', 'rpy="0 0 0"')
    heights = {"0 0.2 0.1": f"0 0.2 {left}", "0 -0.2 0.1": f"0 -0.2 {right}"}
    for old, new in heights.items():
        text = text.replace(f'xyz="{old}"', f'xyz="{new}"')
    return text


@pytest.mark.parametrize(
    ("left", "right", "found"),
    [
        (0.1, 0.1, ""),
        (0.085, 0.085, ""),  # the tread
        (0.07, 0.07, naming("left", "0.03 m", "below", "base_footprint")),
        (0.01, 0.1, naming("left", "0.09 m", "below", "base_footprint", "right")),
    ],
)
def test_wheels_with_meshes(tmp_path: Path, left: float, right: float, found: str) -> None:
    """Robotnik's AGVS: two wheels of four are 10 cm too low."""
    pytest.importorskip("numpy")
    files = {"tyre.stl": TYRE}
    reports = meshed.reported(tmp_path, "TRE008", with_meshes(left, right), files)
    assert [one.message for one in reports] == ([found] if found else [])
    if left != right:
        assert reports[0].span.text.startswith('<joint name="left_joint"')


@pytest.mark.parametrize(("wheels", "count"), [(4, 1), (3, 0)])
def test_four_wheels_above_the_ground(wheels: int, count: int) -> None:
    """Robotnik's RBCAR, whose visuals without a collision carry nothing."""
    text = SEEN + '<link name="base_footprint"/>' + LINK.format("base", "0 0 1", "0 0 0", BOX)
    text += JOINT.format("base_footprint", "0 0 1", "0 0 0", "base")
    text += JOINT.format("base", "0 0 5", "0 0 0", "wheel")
    wheel = '<cylinder radius="0.3" length="0.1"/>'
    for number in range(wheels):
        text += LINK.format(f"w{number}", "0 0 0", f"{pi / 2} 0 0", wheel)
        text += (
            f'<joint name="w{number}_joint" type="continuous"><origin xyz="{number} 0 -1.2"/>'
            f'<parent link="base"/><child link="w{number}"/><axis xyz="0 1 0"/></joint>\n'
        )
    lifted = text.replace('xyz="0 0 1"', 'xyz="0 0 1.7"')
    assert len(messages("TRE008", lifted)) == count
