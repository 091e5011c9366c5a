import pytest

from tests.jointed import joint, limit, robot
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Confidence

REVOLUTE = limit("-1", "2", "80", "11")


def symmetric_pairs(left: str, right: str, kind: str = "revolute", other: str = "revolute") -> str:
    return robot(joint("left_arm", kind, left), joint("right_arm", other, right))


@pytest.mark.parametrize(
    ("right", "difference"),
    [
        (limit("-1", "2", "1000", "11"), "effort 1000, not 80 N·m"),
        (limit("-1", "2", "81", "11"), "effort 81, not 80 N·m"),
        (limit("-1", "2", "80", "5"), "velocity 5, not 11 rad/s"),
        (limit("-1", "1.5", "80", "11"), "limits [-1, 1.5], not [-1, 2] rad"),
        (limit("-1.2", "2.2", "80", "11"), "limits [-1.2, 2.2], not [-1, 2] rad"),
        (
            limit("0", "2", "1", "2"),
            "effort 1, not 80 N·m, velocity 2, not 11 rad/s, limits [0, 2], not [-1, 2] rad",
        ),
    ],
)
def test_what_differs(right: str, difference: str) -> None:
    text = symmetric_pairs(REVOLUTE, right)
    (found,) = reported("JNT025", text)
    assert found.message == naming("right_arm", "left_arm", difference)
    assert found.confidence is Confidence.INFERRED
    assert places("JNT025", text) == [(6, right)]
    assert [other.message for other in found.related] == ["counterpart 'left_arm'"]


def test_another_type() -> None:
    text = symmetric_pairs(REVOLUTE, limit("-1", "2"), other="continuous")
    assert messages("JNT025", text) == [naming("right_arm", "left_arm", "continuous", "revolute")]
    assert places("JNT025", text) == [(6, '<joint name="right_arm" type="continuous">')]


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (REVOLUTE, REVOLUTE),
        (REVOLUTE, limit("-2", "1", "80", "11")),  # mirrored
        (REVOLUTE, limit("-1.1", "2.1", "80.4", "11.05")),
        # the ankle of a NAO
        (
            limit("-1.189442", "0.922581", "3.023", "6.4"),
            limit("-1.1863", "0.932006", "3.0226", "6.4"),
        ),
        (REVOLUTE, limit("-1", "2", "0", "0")),  # JNT008
        (REVOLUTE, limit("0", "0", "80", "11")),  # JNT003
        (REVOLUTE, limit("-1", "2", "-80", "11")),  # JNT008
        (REVOLUTE, ""),  # JNT002
        (REVOLUTE, limit("x", "2", "x", "11")),  # URD005
    ],
)
def test_no_finding(left: str, right: str) -> None:
    assert reported("JNT025", symmetric_pairs(left, right)) == []


def test_wheels_of_which_one_has_no_limit_are_left_to_another_rule() -> None:
    wheel = '<limit effort="100" velocity="100"/>'
    assert reported("JNT025", symmetric_pairs("", wheel, "continuous", "continuous")) == []


def test_axes_of_one_arm_are_no_counterparts() -> None:
    first = joint("joint_l", "revolute", limit("-1", "2", "6000", "2"))
    second = joint("joint_r", "revolute", limit("-3", "3", "700", "3"), parent="joint_l_link")
    assert reported("JNT025", robot(first, second)) == []


def numbered(*origins: str) -> str:
    return robot(
        *(
            joint(
                f"wheel_{number}",
                "continuous",
                f'<origin xyz="{xyz}"/><limit effort="{number}" velocity="1"/>',
            )
            for number, xyz in enumerate(origins, 1)
        )
    )


def test_numbered_joints_are_counterparts_if_they_lie_mirrored() -> None:
    assert messages("JNT025", numbered("0.1 0.2 0", "0.1 -0.2 0")) == [
        naming("wheel_2", "wheel_1", "effort", "2", "1 N·m")
    ]
    assert reported("JNT025", numbered("0.1 0.2 0", "0.1 -0.25 0")) == []
    assert reported("JNT025", numbered("0 0 0.1", "0 0 0.2")) == []


def test_no_tree() -> None:
    text = symmetric_pairs(REVOLUTE, limit("-1", "2", "1", "11"))
    assert reported("JNT025", text.replace('<parent link="base"/>', '<parent link="z"/>')) == []
    assert reported("JNT025", text.replace('<parent link="base"/>', "")) == []
    loop = text.replace('<parent link="base"/>', '<parent link="left_arm_link"/>')
    assert reported("JNT025", loop) == []


LOSSES = '<dynamics damping="{}" friction="{}"/>'


@pytest.mark.parametrize(
    ("losses", "difference"),
    [
        ((5, 0.2), "damping 5, not 0.5 N·m·s/rad"),
        ((0.5, 0.02), "friction 0.02, not 0.2 N·m"),
        ((0.4, 0.3), ""),  # they are measured
        ((0, 0.2), ""),
    ],
)
def test_damping_and_friction(losses: tuple[float, float], difference: str) -> None:
    robot = symmetric_pairs(REVOLUTE + LOSSES.format(0.5, 0.2), REVOLUTE + LOSSES.format(*losses))
    expected = [naming("right_arm", "left_arm", difference)] if difference else []
    assert messages("JNT025", robot) == expected
