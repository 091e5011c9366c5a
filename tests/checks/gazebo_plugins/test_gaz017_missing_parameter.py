import pytest

from tests.gazebos import BASE, WHEELS, plugin
from tests.naming import naming
from tests.reported import messages, reported

SLIP = "libgazebo_ros_wheel_slip.so"
DRIVE = "libgazebo_ros_diff_drive.so"


def test_a_tag_without_which_nothing_works() -> None:
    assert messages("GAZ017", BASE + plugin("libgazebo_ros_hand_of_god.so")) == [
        naming("p", "libgazebo_ros_hand_of_god.so", "<linkName>", "missing")
    ]


def test_an_empty_tag_is_none() -> None:
    text = BASE + plugin("libgazebo_ros_hand_of_god.so", "<linkName> </linkName>")
    assert len(reported("GAZ017", text)) == 1
    assert reported("GAZ017", text.replace("> <", ">base<")) == []


def test_in_a_block_only_where_the_block_is() -> None:
    assert messages("GAZ017", BASE + plugin(SLIP)) == [naming("p", SLIP, "<wheel>", "missing")]
    wheel = "<wheel><wheel_normal_force>1</wheel_normal_force></wheel>"
    assert messages("GAZ017", BASE + plugin(SLIP, wheel)) == [
        naming("p", SLIP, "link_name", "<wheel>", "missing")
    ]


def test_a_default_that_names_no_joint() -> None:
    text = WHEELS + plugin(DRIVE, "<leftJoint>left_joint</leftJoint>")
    assert reported("GAZ017", text) == [], "right_joint is the default, and it exists"
    other = text.replace('"right_joint"', '"right_wheel_joint"')
    (message,) = messages("GAZ017", other)
    assert message == naming("p", DRIVE, "<rightJoint>", "right_joint")


@pytest.mark.parametrize(
    ("tags", "count"),
    [
        ("", 0),
        ("<num_wheel_pairs>2</num_wheel_pairs>", 1),
        ("<left_joint>left_joint</left_joint>", 1),
        ("<num_wheel_pairs>$(arg pairs)</num_wheel_pairs>", 0),
    ],
)
def test_pairs_of_wheels(tags: str, count: int) -> None:
    joints = "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>"
    found = messages("GAZ017", WHEELS + plugin(DRIVE, joints + tags))
    assert ["<num_wheel_pairs>" in one for one in found] == [True] * count


def test_one_of_two() -> None:
    text = BASE + plugin("libgazebo_ros_ft_sensor.so", "<update_rate>1</update_rate>")
    assert messages("GAZ017", text) == [
        naming("p", "libgazebo_ros_ft_sensor.so", "<body_name>", "<joint_name>")
    ]
    assert reported("GAZ017", text.replace("<update", "<body_name>base</body_name><update")) == []


def test_tags_of_the_other_generation_are_reported_elsewhere() -> None:
    tags = "<leftJoint>left_joint</leftJoint><rightJoint>right_joint</rightJoint>"
    assert reported("GAZ017", WHEELS + plugin(DRIVE, tags), targets=("classic-ros2",)) == []


@pytest.mark.parametrize("file", ["libvendor.so", "libgazebo_ros_planar_move.so"])
def test_plugins_that_need_nothing(file: str) -> None:
    assert reported("GAZ017", BASE + plugin(file)) == []
