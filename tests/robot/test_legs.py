import pytest

from urdfkit.robot.legs import legs


@pytest.mark.parametrize(
    "names",
    [
        ("FL_hip", "FR_hip", "RL_hip", "RR_hip"),
        ("knee_L1", "knee_R1", "knee_L2", "knee_R2"),
        ("front_left_wheel", "front_right_wheel", "rear_left_wheel", "rear_right_wheel"),
        ("wheel-left-front", "wheel-right-front", "wheel-left-back", "wheel-right-back"),
        ("lf_hip_lf_knee", "rf_hip_rf_knee", "lb_hip_lb_knee", "rb_hip_rb_knee"),
    ],
)
def test_one_name_for_each_corner(names: tuple[str, ...]) -> None:
    assert [tuple(group.values()) for group in legs(["base", *names])] == [names]


@pytest.mark.parametrize(
    "names",
    [
        ("left_hip", "right_hip", "left_knee", "right_knee"),  # two legs
        ("joint_1", "joint_2", "joint_3", "joint_4"),
        ("left_hand_l", "left_hand_r", "right_hand_l", "right_hand_r"),
        ("wall", "ball", "fall", "rail"),
        tuple(f"{'x' * 200}_{corner}" for corner in ("fl", "fr", "rl", "rr")),
    ],
)
def test_other_names(names: tuple[str, ...]) -> None:
    assert legs(names) == []


def test_the_corners() -> None:
    (group,) = legs(["RR_hip", "FL_hip", "RL_hip", "FR_hip"])
    assert group == {"rr": "RR_hip", "fl": "FL_hip", "rl": "RL_hip", "fr": "FR_hip"}
