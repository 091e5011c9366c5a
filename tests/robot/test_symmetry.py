"""Finding the left and the right of a robot by name and by place."""

import re

import pytest

from tests.massive import context, joint, link
from urdfkit.robot.symmetry import joint_pairs, numbered_pairs, on_separate_branches, pairs


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("left_wheel", "right_wheel"),
        ("wheel_left_joint", "wheel_right_joint"),
        ("leftHipYaw", "rightHipYaw"),
        ("LeftArm", "RightArm"),
        ("LEFT_KNEE", "RIGHT_KNEE"),
        ("leftwheel", "rightwheel"),
        ("l_elbow", "r_elbow"),
        ("elbow_l", "elbow_r"),
        ("arm.l.3", "arm.r.3"),
        ("LShoulderPitch", "RShoulderPitch"),
        ("hipYawL", "hipYawR"),
        ("FL_hip_joint", "FR_hip_joint"),
        ("RL_hip_joint", "RR_hip_joint"),
        ("LF_HAA", "RF_HAA"),
        ("LH_HAA", "RH_HAA"),
        ("lr_wheel", "rr_wheel"),
        ("fl.hx", "fr.hx"),
        ("front_left_wheel", "front_right_wheel"),
        ("lf1_lf2", "rf1_rf2"),
        ("left_arm_left_hand", "right_arm_right_hand"),
    ],
)
def test_a_pair(left: str, right: str) -> None:
    assert pairs(["base", left, right]) == [(left, right)]
    assert pairs([right, "base", left]) == [(left, right)]


@pytest.mark.parametrize(
    "names",
    [
        ["link", "rink"],
        ["arm_1", "arm_2"],
        ["front_wheel", "rear_wheel"],
        ["fl_wheel", "rl_wheel"],
        ["left_wheel", "Right_wheel"],
        ["left_wheel"],
        ["l", "left"],
        [],
    ],
)
def test_no_pair(names: list[str]) -> None:
    assert pairs(names) == []


def test_the_four_corners_are_paired_across_and_not_along() -> None:
    corners = ["FL", "FR", "RL", "RR"]
    assert pairs(corners) == [("FL", "FR"), ("RL", "RR")]
    assert pairs(["LF", "RF", "LR", "RR"]) == [("LF", "RF"), ("LR", "RR")]


def test_the_last_side_counts_and_a_name_is_in_one_pair() -> None:
    fingers = [f"{hand}_hand_{finger}_finger" for hand in ("l", "r") for finger in ("l", "r")]
    assert pairs(fingers) == [(fingers[0], fingers[1]), (fingers[2], fingers[3])]
    hands = ["left_hand_l_finger", "right_hand_l_finger"]
    assert pairs(hands) == [("left_hand_l_finger", "right_hand_l_finger")]


def test_numbers_pair_across_y() -> None:
    wheels = {
        "wheel_1": (0.1, 0.13, 0.0),
        "wheel_2": (-0.1, 0.13, 0.0),
        "wheel_3": (0.1, -0.13, 0.0),
        "wheel_4": (-0.1, -0.13, 0.0),
        "arm_1": (0.3, 0.2, 0.0),
    }
    assert numbered_pairs(wheels) == [("wheel_1", "wheel_3"), ("wheel_2", "wheel_4")]


def test_numbers_pair_across_x_if_none_does_across_y() -> None:
    assert numbered_pairs({"f1": (0.02, 0.0, 0.1), "f2": (-0.02, 0.0, 0.1)}) == [("f1", "f2")]


@pytest.mark.parametrize(
    "other",
    [
        (0.1, -0.1300021, 0.0),  # not the mirror image to the micrometre
        (0.1, 0.13, 0.0),  # at the same place
        (0.2, -0.13, 0.0),  # displaced as well
    ],
)
def test_numbers_that_are_no_mirror_images(other: tuple[float, float, float]) -> None:
    assert numbered_pairs({"wheel_1": (0.1, 0.13, 0.0), "wheel_2": other}) == []
    assert numbered_pairs({"wheel_1": (0.1, 0.13, 0.0), "mast_2": (0.1, -0.13, 0.0)}) == []


def test_a_place_on_the_plane_has_no_counterpart() -> None:
    assert numbered_pairs({"mast_1": (0.1, 0.0, 0.0), "mast_2": (0.1, 0.0, 0.0)}) == []


def test_rounding_noise_does_not_part_counterparts() -> None:
    assert numbered_pairs({"w1": (0.3, 0.1 + 0.2, 0.0), "w2": (0.3, -0.3, 0.0)}) == [("w1", "w2")]


def test_many_names_take_no_long_time() -> None:
    names = [f"link_{number}" for number in range(20_000)]
    assert pairs(names) == []
    assert numbered_pairs(dict.fromkeys(names, (0.1, 0.2, 0.3))) == []


def test_endless_names_take_no_long_time() -> None:
    names = ["l_1_" * 200_000, "r_1_" * 200_000]
    assert pairs(names) == []
    assert numbered_pairs({names[0]: (0.0, 1.0, 0.0), names[1]: (0.0, -1.0, 0.0)}) == []


def test_what_hangs_on_one_another_are_no_counterparts() -> None:
    parents = {"link_s": "base", "link_l": "link_s", "link_u": "link_l", "link_r": "link_u"}
    assert on_separate_branches([("link_l", "link_r")], parents) == []
    assert on_separate_branches([("link_r", "link_l")], parents) == []
    fork = {"hand": "base", "l_finger": "hand", "r_finger": "hand", "l_tip": "l_finger"}
    found = [("l_finger", "r_finger"), ("r_finger", "l_tip")]
    assert on_separate_branches(found, fork) == found


def test_links_without_a_tree_are_no_counterparts() -> None:
    assert on_separate_branches([("l", "r")], {}) == []
    assert on_separate_branches([("l", "r")], {"l": "r", "r": "l"}) == []
    assert on_separate_branches([("l", "r")], {"l": "base", "r": "r"}) == []


def test_a_long_chain_takes_no_long_time() -> None:
    count = 100_000
    parents = {f"link_{number}": f"link_{number - 1}" for number in range(1, count)}
    found = [(f"link_{number}", f"link_{number + 1}") for number in range(count - 1)]
    assert on_separate_branches(found, parents) == []


def symmetric_pairs(*joints: str) -> list[tuple[str, str]]:
    """The names of the joints that are pairs in a robot of joints."""
    names = sorted({name for one in joints for name in re.findall(r'(?<=link=")\w+', one)})
    tree = context("".join(map(link, names)) + "".join(joints)).tree
    return [(left.name, right.name) for left, right in joint_pairs(tree)]


def moving(parent: str, child: str, place: str = "0 0 0", kind: str = "continuous") -> str:
    return joint(parent, child, kind, xyz=place)


def test_joints_are_pairs_by_name_wherever_they_hang() -> None:
    found = symmetric_pairs(
        moving("base", "l_hip"),
        moving("l_hip", "l_knee"),
        moving("base", "r_hip"),
        moving("r_hip", "r_knee"),
    )
    assert sorted(found) == [("l_hip_joint", "r_hip_joint"), ("l_knee_joint", "r_knee_joint")]


def test_numbered_joints_are_pairs_by_place_on_one_link() -> None:
    beside = (moving("base", "leg_1", "1 2 0"), moving("base", "leg_2", "1 -2 0"))
    assert symmetric_pairs(*beside) == [("leg_1_joint", "leg_2_joint")]
    assert symmetric_pairs(beside[0], moving("base", "box"), moving("box", "leg_2", "1 -2 0")) == []
    # A name that tells its side is in no second pair.
    assert symmetric_pairs(
        *beside, moving("base", "l_arm", "1 2 0"), moving("base", "r_arm", "1 -2 0")
    ) == [
        ("l_arm_joint", "r_arm_joint"),
        ("leg_1_joint", "leg_2_joint"),
    ]


def test_fixed_joints_and_what_hangs_on_one_another_are_no_pairs() -> None:
    assert (
        symmetric_pairs(moving("base", "l", kind="fixed"), moving("base", "r", kind="fixed")) == []
    )
    assert symmetric_pairs(moving("base", "l"), moving("l", "r")) == []
    assert symmetric_pairs(moving("base", "l"), moving("base", "r")) == [("l_joint", "r_joint")]


def test_numbers_far_from_one_another_are_products() -> None:
    """The grippers RG2 and RG6 of OnRobot, side by side."""
    assert numbered_pairs({"rg2_tip": (0.0, 0.2, 0.0), "rg6_tip": (0.0, -0.2, 0.0)}) == []
