from pathlib import Path

import pytest

from tests import meshed
from tests.jointed import joint, limit, robot
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit.mesh import samples
from urdfkit.text.diagnostic import Confidence


def at(name: str, xyz: str) -> str:
    return joint(name, "fixed", f'<origin xyz="{xyz}"/>')


def shown(geometry: str) -> str:
    return f'<link name="s"><visual><geometry>{geometry}</geometry></visual></link>'


NEAR = [at("a", "0 0 0.1"), at("b", "0 0.2 0"), at("c", "0.3 0 0"), at("d", "0 0 0")]
MESH = '<mesh filename="arm.stl" scale="{0} {0} {0}"/>'


def test_one_origin_far_from_all_others() -> None:
    text = robot(*NEAR, at("j", "0 0 -150"))
    (found,) = reported("JNT012", text)
    assert found.message == naming("j", "150 m", "3", "0.2 m", "millimetres")
    assert found.confidence is Confidence.INFERRED
    assert places("JNT012", text) == [(12, '<origin xyz="0 0 -150"/>')]


def test_a_robot_that_stands_far_from_the_world() -> None:
    text = robot(*NEAR, at("j", "33 17 2"))
    assert len(reported("JNT012", text)) == 1
    assert reported("JNT012", text.replace('"base"', '"world"')) == []


@pytest.mark.parametrize(("reach", "count"), [("9.9", 0), ("10", 1)])
def test_ten_metres_are_far(reach: str, count: int) -> None:
    near = [at(name, "0 0 0.05") for name in "abc"]
    assert len(reported("JNT012", robot(*near, at("j", f"0 0 {reach}")))) == count


def test_a_robot_in_millimetres_with_meshes_that_are_scaled() -> None:
    far = robot(at("a", "0 0 120"), at("b", "0 250 0"))
    (message,) = messages("JNT012", shown(MESH.format("0.001")) + far)
    assert message == naming("a", "b", "120 m", "0.001", "millimetres")
    assert reported("JNT012", shown(MESH.format("1")) + far) == []


@pytest.mark.parametrize(
    ("size", "count"), [("0.4 0.4 0.4", 1), ("0.1 1.19 0.1", 1), ("0.1 1.21 0.1", 0)]
)
def test_shapes_tell_the_size_of_the_robot(size: str, count: int) -> None:
    text = shown(f'<box size="{size}"/>') + robot(at("a", "0 0 120"), at("b", "0 250 0"))
    assert len(reported("JNT012", text)) == count


@pytest.mark.parametrize(
    "joints",
    [
        [*NEAR],
        [*NEAR, at("j", "0 0 9.9")],
        [*NEAR, at("j", "0 0 15")],  # a frame in the room, 75 times as far
        [at("a", "0 0 2"), at("b", "0 5 0"), at("c", "4 0 0"), at("j", "0 0 600")],  # a crane
        [at("a", "0 0 0.1"), at("b", "0 0.2 0"), at("j", "0 0 150")],  # too few to compare with
        [at("a", "0 0 120"), at("b", "0 250 0")],
    ],
)
def test_no_evidence(joints: list[str]) -> None:
    assert reported("JNT012", robot(*joints)) == []


ROBOT = """\
<link name="a"><visual><geometry><box size="{size} 0.1 0.1"/></geometry></visual></link>
<link name="b"/>
<joint name="j" type="prismatic"><parent link="a"/><child link="b"/>
<limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/></joint>"""


def gripper(lower: str, upper: str, size: str = "0.1") -> str:
    return ROBOT.format(lower=lower, upper=upper, size=size)


def test_thirty_metres_of_a_gripper() -> None:
    assert messages("JNT012", gripper("0", "30")) == [naming("j", "[0, 30] m", "0.1 m")]
    text = fixed("JNT012", gripper("-5", "30"))
    assert 'lower="-0.005" upper="0.03"' in text


@pytest.mark.parametrize(
    ("lower", "upper", "size"),
    [
        ("0", "0.03", "0.1"),
        ("0", "30", "2"),  # a gantry
        ("0", "30.5", "0.1"),  # nobody measures half millimetres
        ("-1000000", "1000000", "0.1"),  # free
    ],
)
def test_a_plausible_travel(lower: str, upper: str, size: str) -> None:
    assert messages("JNT012", gripper(lower, upper, size)) == []


def test_an_object_that_moves_in_the_world() -> None:
    """A block of 6 cm on three prismatic joints, for PyBullet: links without bodies."""
    block = '<visual><geometry><box size="0.06 0.06 0.06"/></geometry></visual>'
    text = f'<link name="base"/><link name="block">{block}</link>'
    assert messages("JNT012", text + joint("x", "prismatic", limit("-50", "50"))) == []
    assert len(messages("JNT012", text + joint("x", "prismatic", limit("0", "50")))) == 1


def test_a_lift_with_meshes(tmp_path: Path) -> None:
    """The elevator of Robotnik's AGVS: 5 cm, on a robot of 1.7 m."""
    pytest.importorskip("numpy")
    body = meshed.link(meshed.mesh("body.stl", "visual"), name="base")
    text = body + '<link name="lid"/>' + joint("lift", "prismatic", limit("0", "50"))
    for size, count in ((1.7, 1), (3, 0)):
        files = {"body.stl": samples.stl(samples.box((0, 0, 0), (size, 0.1, 0.1)))}
        assert len(meshed.reported(tmp_path, "JNT012", text, files)) == count


_VISUAL = f"<visual><geometry>{MESH.format(1)}</geometry></visual>"


@pytest.mark.parametrize(
    ("limits", "parent", "found"),
    [
        (("-100", "150"), _VISUAL, 1),
        (("-100", "100"), _VISUAL, 0),  # of a mobile base
        (("0", "150"), "<inertial/>", 0),
        (("0", "20"), _VISUAL, 0),
    ],
)
def test_limits_next_to_meshes(limits: tuple[str, str], parent: str, found: int) -> None:
    """A lift of 15 cm: the origins show that the robot is small."""
    text = f'<link name="base">{parent}</link><link name="lid">{_VISUAL}</link>'
    text += joint("rack", "prismatic", '<origin xyz="0.3 0 0"/>' + limit(*limits))
    expected = naming("rack", f"[{limits[0]}, {limits[1]}] m", "0.3 m")
    assert messages("JNT012", text) == [expected] * found
