"""What gz-sim has instead of plugins of Gazebo Classic, with the values that these have."""

import pytest

from tests.conftest import MISSION
from urdfkit.lint.engine import check
from urdfkit.lint.migrate import migrate
from urdfkit.ros.catalog import data
from urdfkit.ros.catalog.plugins import find
from urdfkit.text.source import Source

GZ = ("gz-fortress", "gz-harmonic", "gz-jetty")

ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="radius" value="0.05"/>
  <link name="base"/>
  <gazebo reference="base">
    {}
  </gazebo>
</robot>
"""
DRIVE = ROBOT.replace(' reference="base"', "")


def migrated(block: str, target: str = "gz-harmonic", robot: str = ROBOT) -> list[str]:
    """The lines of the block after the migration."""
    source = Source("r.xacro", robot.format(block).encode())
    ((_, text),) = migrate(source, target).texts.items()
    lines = text.decode().splitlines()
    return [line.strip() for line in lines[4:-2]]


@pytest.mark.parametrize("target", GZ)
def test_all_plugins_of_the_mission_model_are_replaced(target: str) -> None:
    migration = migrate(MISSION, target)
    assert migration.left == ()
    ((source, text),) = migration.texts.items()
    report = check(Source(source.path, text), targets=(target,), select=["GAZ"])
    wrong = {"GAZ012", "GAZ016", "GAZ021", "GAZ040"}  # the catalogue of gz-sim knows every tag
    assert wrong.isdisjoint(diagnostic.code for diagnostic in report.diagnostics)
    again = migrate(Source(source.path, text), target)
    assert tuple(again) == ({}, (), (), {})


def test_a_drive_of_ros_1() -> None:
    plugin = """<plugin name="d" filename="libgazebo_ros_diff_drive.so">
      <leftJoint>left</leftJoint>
      <rightJoint>right</rightJoint>
      <wheelSeparation>0.4</wheelSeparation>
      <wheelDiameter>${2*radius}</wheelDiameter>
      <odometryFrame>map</odometryFrame>
    </plugin>"""
    assert migrated(plugin, robot=DRIVE) == [
        '<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">',
        "<left_joint>left</left_joint>",
        "<right_joint>right</right_joint>",
        "<wheel_separation>0.4</wheel_separation>",
        "<wheel_radius>${(2*radius)/2}</wheel_radius>",
        "<odom_publish_frequency>100</odom_publish_frequency>",  # the defaults of ROS 1
        "<topic>cmd_vel</topic>",
        "<odom_topic>odom</odom_topic>",
        "<frame_id>map</frame_id>",
        "<child_frame_id>base_footprint</child_frame_id>",
        "</plugin>",
    ]


def test_a_drive_of_ros_2_with_another_topic_in_fortress() -> None:
    plugin = """<plugin name="d" filename="libgazebo_ros_diff_drive.so">
      <ros><remapping>cmd_vel:=/base/cmd</remapping></ros>
      <left_joint>left</left_joint>
      <right_joint>right</right_joint>
      <wheel_separation>0.4</wheel_separation>
      <wheel_diameter>0.13</wheel_diameter>
    </plugin>"""
    found = migrated(plugin, "gz-fortress", DRIVE)
    name = 'name="ignition::gazebo::systems::DiffDrive"'
    assert found[0] == f'<plugin filename="ignition-gazebo-diff-drive-system" {name}>'
    assert "<topic>/base/cmd</topic>" in found
    assert "<wheel_radius>0.065</wheel_radius>" in found


def test_wheel_pairs_of_different_sizes_are_not_replaced() -> None:
    joints = "".join(
        f"<{side}_joint>{side}{n}</{side}_joint>" for side in ("left", "right") for n in "12"
    )
    sizes = "<wheel_diameter>0.1</wheel_diameter><wheel_diameter>{}</wheel_diameter>"
    plugin = '<plugin name="d" filename="libgazebo_ros_diff_drive.so">{}</plugin>'
    other = DRIVE.format(plugin.format(joints + sizes.format("0.2")))
    assert [one.code for one in migrate(Source("r.xacro", other.encode()), "gz-harmonic").left] == [
        "GAZ012"
    ]
    found = migrated(plugin.format(joints + sizes.format("0.1")), robot=DRIVE)
    assert [line for line in found if "left" in line] == [
        "<left_joint>left1</left_joint>",
        "<left_joint>left2</left_joint>",
    ]


@pytest.mark.parametrize(
    ("type", "plugin", "expected"),
    [
        (
            "camera",
            (
                '"libgazebo_ros_camera.so"><cameraName>front</cameraName>'
                "<imageTopicName>image</imageTopicName><frameName>eye</frameName>"
            ),
            ["<topic>front/image</topic>", "<gz_frame_id>eye</gz_frame_id>"],
        ),
        (
            "camera",
            '"libgazebo_ros_camera.so"><camera_name>front</camera_name><frame_name>eye</frame_name>',
            ["<topic>front/image_raw</topic>", "<gz_frame_id>eye</gz_frame_id>"],
        ),
        (
            "camera",
            (
                '"libgazebo_ros_camera.so"><ros><remapping>/s/image_raw:=/view</remapping></ros>'
                "<frame_name>eye</frame_name>"
            ),
            ["<topic>/view</topic>", "<gz_frame_id>eye</gz_frame_id>"],
        ),
        (
            "ray",
            (
                '"libgazebo_ros_ray_sensor.so"><ros><remapping>~/out:=scan</remapping></ros>'
                "<output_type>sensor_msgs/LaserScan</output_type><frame_name>eye</frame_name>"
            ),
            ["<topic>scan</topic>", "<gz_frame_id>eye</gz_frame_id>"],
        ),
    ],
)
def test_a_sensor_has_the_topic_and_the_frame_of_its_plugin(
    type: str, plugin: str, expected: list[str]
) -> None:
    block = (
        f'<sensor name="s" type="{type}">\n<plugin name="p" filename={plugin}</plugin>\n</sensor>'
    )
    assert migrated(block)[1:-1] == expected


def test_expressions_are_copied_and_topics_get_the_namespace() -> None:
    block = """<sensor name="${'front'}" type="camera">
      <plugin name="p" filename="libgazebo_ros_camera.so">
        <ros><namespace>${'a' + 'b'}</namespace></ros>
        <frame_name>${'eye' + '_link'}</frame_name>
      </plugin>
    </sensor>"""
    assert migrated(block)[1:-1] == [
        "<topic>${'a' + 'b'}/${'front'}/image_raw</topic>",
        "<gz_frame_id>${'eye' + '_link'}</gz_frame_id>",
    ]
    plugin = """<plugin name="d" filename="libgazebo_ros_diff_drive.so">
      <ros><namespace>/ns</namespace><remapping>odom:=odom/${'raw'}</remapping></ros>
      <left_joint>left</left_joint><right_joint>right</right_joint>
      <wheel_separation>0.4</wheel_separation><wheel_diameter>${radius * 2}</wheel_diameter>
    </plugin>"""
    found = migrated(plugin, robot=DRIVE)
    assert "<wheel_radius>${(radius * 2)/2}</wheel_radius>" in found
    assert "<topic>/ns/cmd_vel</topic>" in found
    assert "<odom_topic>/ns/odom/${'raw'}</odom_topic>" in found


def test_each_name_of_a_list_becomes_a_tag() -> None:
    plugin = """<plugin name="j" filename="libgazebo_ros_joint_state_publisher.so">
      <jointName>left, right</jointName>
    </plugin>"""
    found = migrated(plugin, robot=DRIVE)
    assert [line for line in found if "joint_name" in line] == [
        "<joint_name>left</joint_name>",
        "<joint_name>right</joint_name>",
    ]


def test_the_topic_of_the_sensor_is_kept() -> None:
    block = """<sensor name="s" type="imu">
      <topic>mine</topic>
      <plugin name="p" filename="libgazebo_ros_imu_sensor.so"><frameName>eye</frameName></plugin>
    </sensor>"""
    assert migrated(block)[1:-1] == ["<topic>mine</topic>", "<gz_frame_id>eye</gz_frame_id>"]


def test_the_catalogue_lists_existing_plugins_and_tags() -> None:
    for file, systems in data("successors")["systems"].items():
        read = {name for plugin in find(file) for name in plugin.parameters}
        for system, tags in systems.items():
            (plugin,) = find(system)
            for tag, names in tags.items():
                assert plugin.reads(tag), (system, tag)
                words = names.replace("+", " ").split()
                assert {one for one in words if not one.startswith("~")} <= read
