import pytest

from tests.jointed import joint, limit, robot
from tests.naming import naming
from tests.reported import messages, places, reported


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (limit("0", "0"), ["lower", "upper", "0 rad"]),
        (limit("1.5", "1.5"), ["lower", "upper", "1.5 rad"]),
        (
            '<limit effort="1" velocity="1"/>',
            ["lower", "upper", "0", "Drake", "PyBullet"],
        ),
        (
            '<limit lower="0" effort="1" velocity="1"/>',
            ["lower", "0"],
        ),
    ],
)
def test_a_joint_that_cannot_move(content: str, why: list[str]) -> None:
    text = robot(joint("j", "revolute", content))
    assert messages("JNT003", text) == [naming("j", "revolute", *why)]
    assert places("JNT003", text) == [(4, content)]


def test_what_to_do_depends_on_the_type() -> None:
    helps = {
        kind: reported("JNT003", robot(joint("j", kind, limit("1", "1"))))[0].help
        for kind in ("revolute", "prismatic")
    }
    assert helps == {
        "revolute": naming("lower", "upper", "continuous", "fixed"),
        "prismatic": naming("lower", "upper", "fixed"),
    }


@pytest.mark.parametrize(
    ("kind", "content"),
    [
        ("revolute", limit("0", "0.001")),
        ("revolute", '<limit upper="1" effort="1" velocity="1"/>'),
        ("revolute", limit("x", "0")),  # URD005
        ("continuous", limit("0", "0")),  # JNT020
        ("continuous", '<limit effort="1" velocity="1"/>'),
        ("fixed", limit("0", "0")),
    ],
)
def test_no_finding(kind: str, content: str) -> None:
    assert reported("JNT003", robot(joint("j", kind, content))) == []


@pytest.mark.parametrize(("target", "count"), [("drake", 0), ("mujoco", 0), ("ros2", 1)])
def test_limits_that_a_program_does_not_need(target: str, count: int) -> None:
    for ends in ("", 'lower="0" '):
        text = robot(joint("j", "revolute", f'<limit {ends}effort="1" velocity="1"/>'))
        assert len(reported("JNT003", text, targets=(target,))) == count
    text = robot(joint("j", "revolute", limit("0", "0")))
    assert len(reported("JNT003", text, targets=(target,))) == 1
