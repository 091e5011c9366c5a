from __future__ import annotations

from tests.gazebos import BASE, child, plugin
from tests.reported import messages, reported

HAND = "libgazebo_ros_hand_of_god.so"
STATES = "libgazebo_ros_joint_state_publisher.so"


def test_a_link_without_mass() -> None:
    text = BASE + child("arm", inside="") + plugin(HAND, "<linkName>arm</linkName>")
    (found,) = reported("GAZ023", text)
    assert found.message == (
        f"plugin 'p' ({HAND}) looks for link 'arm', which Gazebo leaves out (link 'arm': no "
        "inertial): it crashes"
    )
    assert found.help == "give link 'arm' an <inertial> with its mass"


def test_what_hangs_on_it_is_lost_with_it() -> None:
    robot = BASE + child("arm", inside="") + child("hand", parent="arm")
    text = robot + plugin(STATES, "<jointName>hand_joint</jointName>")
    (message,) = messages("GAZ023", text)
    assert "leaves out (link 'hand': hangs on 'arm', which is dropped): it writes" in message


def test_links_that_stay() -> None:
    states = plugin(STATES, "<jointName>arm_joint</jointName>")
    assert reported("GAZ023", BASE + child("arm") + states) == []
    merged = BASE + child("arm", "fixed", inside="") + plugin(HAND, "<linkName>arm</linkName>")
    assert reported("GAZ023", merged) == [], "it is merged, which another rule tells"
