import pytest

from urdfkit.robot.assets.file_names import is_mistyped


@pytest.mark.parametrize(
    ("wrong", "right", "mistake"),
    [
        ("forarm.stl", "forearm.stl", True),
        ("fore-arm.stl", "forearm.stl", True),
        ("Left Arm.STL", "left_arm.stl", True),
        ("left_arm.stl", "right_arm.stl", False),
        ("l_arm.stl", "r_arm.stl", False),
        ("upper_arm.stl", "lower_arm.stl", False),
        ("link_1.stl", "link_2.stl", False),
        ("link1.stl", "link_1.stl", True),
        ("arm.stl", "arm.dae", False),
        ("arm.stl", "arms_and_legs.stl", False),
        ("pr2_description", "ur_description", False),
        ("arm_descripton", "arm_description", True),
    ],
)
def test_typos(wrong: str, right: str, mistake: bool) -> None:
    assert is_mistyped(wrong, right) is mistake
