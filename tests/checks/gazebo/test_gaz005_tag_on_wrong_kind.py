from __future__ import annotations

from tests.gazebos import BASE, block, child
from tests.reported import fixed, reported

ROBOT = BASE + child("cam", "fixed") + child("arm")


def heard(tag: str, reference: str) -> list[tuple[str, str]]:
    found = reported("GAZ005", ROBOT + block(f"<{tag}>1</{tag}>", reference))
    return [(one.message, one.help) for one in found]


def test_a_joint_tag_at_a_link() -> None:
    assert heard("preserveFixedJoint", "cam") == [
        (
            "<preserveFixedJoint> is for a joint, and 'cam' is a link: Gazebo ignores it",
            'move it into <gazebo reference="cam_joint">',
        )
    ]


def test_a_link_tag_at_a_joint() -> None:
    assert heard("mu1", "arm_joint") == [
        (
            "<mu1> is for a link, and 'arm_joint' is a joint: Gazebo ignores it",
            'move it into <gazebo reference="arm">',
        )
    ]


def test_a_joint_that_is_not_fixed_cannot_be_preserved() -> None:
    assert [message for message, _ in heard("preserveFixedJoint", "arm_joint")] == [
        "<preserveFixedJoint> has no effect: joint 'arm_joint' is continuous, not fixed"
    ]


def test_no_finding() -> None:
    assert heard("preserveFixedJoint", "cam_joint") == []
    assert heard("mu1", "cam") == []
    assert heard("springStiffness", "arm_joint") == []
    assert heard("sensor", "cam_joint") == []
    assert heard("mu1", "nothing") == []
    assert heard("mu1", "") == []


def test_what_stands_beside_other_tags_gets_a_block_of_its_own() -> None:
    wrong = '<gazebo reference="cam">\n  <mu1>1</mu1>\n  {}</gazebo>\n'
    tag = "<preserveFixedJoint>true</preserveFixedJoint>"
    right = f'<gazebo reference="cam_joint">\n  {tag}\n</gazebo>\n'
    after = wrong.replace("  {}", "") + right
    robot = fixed("GAZ005", ROBOT + wrong.format(f"{tag}\n"))
    assert after in robot


def test_a_joint_that_moves_gets_no_tag_of_fixed_ones() -> None:
    (found,) = reported(
        "GAZ005", ROBOT + block("<preserveFixedJoint>1</preserveFixedJoint>", "arm")
    )
    assert found.fix is None
