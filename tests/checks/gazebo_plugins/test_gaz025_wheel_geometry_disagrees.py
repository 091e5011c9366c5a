from __future__ import annotations

import pytest

from tests.gazebos import BASE, WHEELS, plugin, wheel
from tests.reported import messages, places, reported

DRIVE = "libgazebo_ros_diff_drive.so"
JOINTS = "<leftJoint>left_joint</leftJoint><rightJoint>right_joint</rightJoint>"


def drive(separation: str = "0.3", diameter: str = "0.2", robot: str = WHEELS) -> str:
    tags = f"<wheelSeparation>{separation}</wheelSeparation>"
    return robot + plugin(DRIVE, f"{JOINTS}{tags}<wheelDiameter>{diameter}</wheelDiameter>")


def test_a_wrong_diameter() -> None:
    assert messages("GAZ025", drive(diameter="0.1")) == [
        f"plugin 'p' ({DRIVE}): <wheelDiameter> is 0.1 m, and the wheels have diameter 0.2 m"
    ]
    assert [text for _, text in places("GAZ025", drive(diameter="0.1"))] == ["<wheelDiameter>"]
    assert [found.help for found in reported("GAZ025", drive(diameter="0.1"))] == ["write 0.2"]


def test_a_wrong_separation() -> None:
    (message,) = messages("GAZ025", drive("0.15"))
    assert message == (
        f"plugin 'p' ({DRIVE}): <wheelSeparation> is 0.15 m, and the wheels of 'left_joint' and "
        "'right_joint' are 0.3 m apart"
    )


@pytest.mark.parametrize(
    ("separation", "diameter", "count"),
    [("0.314", "0.209", 0), ("0.316", "0.2", 1), ("0.3", "0.211", 1), ("0.286", "0.191", 0)],
)
def test_the_bound_is_five_percent(separation: str, diameter: str, count: int) -> None:
    assert len(reported("GAZ025", drive(separation, diameter))) == count


def test_the_defaults_count() -> None:
    heard = messages("GAZ025", WHEELS + plugin(DRIVE, JOINTS))
    assert [message.partition(": ")[2].partition(",")[0] for message in heard] == [
        "<wheelDiameter> is 0.15 m (the default)",
        "<wheelSeparation> is 0.34 m (the default)",
    ]


def test_the_tyre_counts_where_it_is_not_on_the_joint() -> None:
    robot = BASE + wheel("left", 0.15, at=0.05) + wheel("right", -0.15, at=-0.05)
    assert reported("GAZ025", drive("0.4", robot=robot)) == []
    assert reported("GAZ025", drive("0.3", robot=robot)) == [], "nor is the distance of the joints"
    assert len(reported("GAZ025", drive("0.35", robot=robot))) == 1


def test_a_radius() -> None:
    joints = "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>"
    tags = "<wheel_separation>0.3</wheel_separation><wheel_radius>0.2</wheel_radius>"
    text = WHEELS + plugin("gz-sim-diff-drive-system", joints + tags)
    (message,) = messages("GAZ025", text)
    assert message.endswith(": <wheel_radius> is 0.2 m, and the wheels have radius 0.1 m")


def test_wheels_that_slip_may_have_a_larger_separation() -> None:
    names = [f"{side}{end}" for side in ("left", "right") for end in ("Front", "Rear")]
    joints = "".join(f"<{n}Joint>{n[: -4 if n[-1] == 'r' else -5]}_joint</{n}Joint>" for n in names)
    tags = "<wheelSeparation>{}</wheelSeparation><wheelDiameter>0.2</wheelDiameter>"
    file = "libgazebo_ros_skid_steer_drive.so"
    assert reported("GAZ025", WHEELS + plugin(file, joints + tags.format("0.5"))) == []
    assert len(reported("GAZ025", WHEELS + plugin(file, joints + tags.format("0.2")))) == 1


def test_a_mesh_tells_nothing() -> None:
    robot = WHEELS.replace('<cylinder radius="0.1" length="0.04"/>', '<mesh filename="w.stl"/>')
    assert reported("GAZ025", drive("5", "5", robot)) == []


def test_a_wheel_that_stands_on_its_side_tells_nothing() -> None:
    assert reported("GAZ025", drive("5", "5", WHEELS.replace("1.57079632679", "0"))) == []


def test_wheels_of_different_size_tell_nothing_of_the_diameter() -> None:
    robot = BASE + wheel("left", 0.15) + wheel("right", -0.15, radius=0.2)
    assert reported("GAZ025", drive(diameter="1", robot=robot)) == []
