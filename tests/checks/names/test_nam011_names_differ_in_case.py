"""NAM011: see the rule."""

from tests.reported import messages, places


def test_two_links_and_two_joints() -> None:
    joint = '<joint name="{}" type="fixed"><parent link="{}"/><child link="{}"/></joint>\n'
    text = '<link name="arm"/>\n<link name="Arm"/>\n<link name="hand"/>\n'
    text += joint.format("j", "arm", "Arm") + joint.format("J", "arm", "hand")
    assert messages("NAM011", text) == [
        "link 'Arm' differs from 'arm' in upper and lower case only",
        "joint 'J' differs from 'j' in upper and lower case only",
    ]
    assert [at for _, at in places("NAM011", text)] == ["Arm", "J"]


def test_a_link_and_a_joint_and_equal_names_are_calm() -> None:
    joint = '<joint name="Arm" type="fixed"><parent link="base"/><child link="arm"/></joint>'
    assert messages("NAM011", f'<link name="base"/><link name="arm"/>{joint}') == []
    assert messages("NAM011", '<link name="arm"/><link name="arm"/>') == []  # NAM001
