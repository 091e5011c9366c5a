"""JNT030: see the rule."""

import pytest

from tests.naming import naming
from tests.reported import fixed, messages, reported
from tests.sensing import findings

ROBOT = """\
<link name="{camera}"/><link name="{optical}"/>
<joint name="j" type="fixed"><parent link="{camera}"/><child link="{optical}"/>
<origin rpy="{rpy}"/></joint>"""


def robot(rpy: str, camera: str = "camera_link", optical: str = "camera_optical_frame") -> str:
    return ROBOT.format(rpy=rpy, camera=camera, optical=optical)


def test_a_camera_of_gazebo_is_not_turned_away() -> None:
    camera = '<gazebo reference="camera_optical_frame"><sensor name="s" type="camera"/></gazebo>'
    (found,) = reported("JNT030", robot("0 0 0") + camera)
    assert found.fix is None
    assert "sensor" in (found.help or "")
    assert 'rpy="-1.5707963 0 -1.5707963"' in (found.help or "")


@pytest.mark.parametrize(("pose", "count"), [("1.5708 -1.5708 0", 0), ("1.5708 0 0", 1)])
def test_a_camera_of_gazebo_that_looks_along_z(pose: str, count: int) -> None:
    """A camera that looks up, and Gazebo's pose says so, too."""
    sensor = f'<sensor name="s" type="camera"><pose>0 0 0 {pose}</pose></sensor>'
    camera = f'<gazebo reference="camera_optical_frame">{sensor}</gazebo>'
    assert len(reported("JNT030", robot("0 0 -1.5708") + camera)) == count


def test_a_camera_whose_z_points_down() -> None:
    """The camera of a hexapod, in the frame of its CAD part."""
    mount = '<link name="base"/><joint name="m" type="fixed"><parent link="base"/>'
    mount += '<child link="camera_link"/><origin rpy="3.14159 0 0"/></joint>'
    (found,) = reported("JNT030", mount + robot("0 0 0"))
    assert found.fix is None
    assert found.help == naming('rpy="1.5707963 0 1.5707963"', "camera_link")


@pytest.mark.parametrize(
    ("rpy", "way"),
    [
        ("0 0 0", "looks up"),
        ("1.5708 0 -1.5708", "looks backward"),
        ("0 1.5708 0", "forward, but rotated"),
        ("-1.5708 0 0", "left"),
    ],
)
def test_other_ways_are_reported_and_fixed(rpy: str, way: str) -> None:
    (message,) = messages("JNT030", robot(rpy))
    assert message == naming("j", "camera_optical_frame", way, "camera_link")
    assert 'rpy="-1.5707963 0 -1.5707963"' in fixed("JNT030", robot(rpy))


def test_the_fix_keeps_the_digits_of_the_file() -> None:
    text = robot("-1.57079632679 0 1.57079632679")
    assert 'rpy="-1.57079632679 0 -1.57079632679"' in fixed("JNT030", text)


@pytest.mark.parametrize(
    ("rpy", "camera", "optical"),
    [
        ("-1.57 0 -1.57", "camera_link", "camera_optical_frame"),
        ("-1.2 0 -1.57", "camera_link", "camera_optical_frame"),  # tilted
        # CRANE+: tilted by 90 degrees, as it looks down on the table
        ("0 3.14159 1.5708", "camera_link", "camera_optical_frame"),
        ("3.14159 0 -1.5708", "camera_link", "camera_optical_frame"),
        # mujoco_ros2_control: the frame of a camera in MuJoCo, which looks along -z
        ("3.14159 0 0", "camera", "camera_optical_frame"),
        ("0 0 0", "camera_optical_frame", "camera_optical_frame_2"),
        ("0 0 0", "overhead_camera_link", "overhead_camera_optical_frame"),  # above a table
        ("0 0 0", "head", "camera_optical_frame"),  # the head may be turned as it likes
    ],
)
def test_what_may_be_meant_is_calm(rpy: str, camera: str, optical: str) -> None:
    assert messages("JNT030", robot(rpy, camera, optical)) == []


def test_the_camera_of_gazebo_looks_along_x() -> None:
    """Elkapod's depth camera; without Gazebo tags the frame may be that of MuJoCo."""
    of_mujoco = robot("3.14159 0 0", "camera", "camera_optical_frame")
    gazebo = '<gazebo reference="camera"><sensor name="s" type="depth"/></gazebo>'
    (message,) = messages("JNT030", of_mujoco + gazebo)
    assert "looks down" in message


@pytest.mark.parametrize(
    ("name", "rpy", "count"),
    [
        ("front_camera", "1.5707963 0 1.5707963", 0),  # in a vehicle whose z points down
        ("down_camera", "0 0 1.5707963", 0),
        ("downward_camera", "3.1415927 0 0", 0),
        ("lidar", "0 0 0", 0),  # elkapod's lidar_optical, which is no camera
        ("front_camera", "0 0 1.5707963", 1),
        ("dome_camera", "0 0 1.5707963", 1),
    ],
)
def test_vehicles_under_water(name: str, rpy: str, count: int) -> None:
    text = (
        f'<link name="{name}_link"/><link name="{name}_optical"/>'
        f'<joint name="j" type="fixed"><parent link="{name}_link"/><child link="{name}_optical"/>'
        f'<origin rpy="{rpy}"/></joint><link name="thruster_1"/>'
        f'<joint name="t" type="fixed"><parent link="{name}_link"/>'
        '<child link="thruster_1"/></joint>'
    )
    assert len(reported("JNT030", text)) == count


def test_the_commonest_mistake_of_signs_turns_the_image_over() -> None:
    (message,) = messages("JNT030", robot("1.5707963 0 1.5707963"))
    assert message == naming(
        "j", "camera_optical_frame", "forward", "upside", "down", "camera_link", "forward", "right"
    )
    assert 'rpy="-1.5707963 0 -1.5707963"' in fixed("JNT030", robot("1.5707963 0 1.5707963"))


@pytest.mark.parametrize(("roll", "count"), [("3.1415927", 0), ("0.3", 1)])
def test_a_camera_mounted_head_down_has_its_image_upright(roll: str, count: int) -> None:
    mount = (
        '<link name="base"/><joint name="mount" type="fixed"><parent link="base"/>'
        f'<child link="camera_link"/><origin rpy="{roll} 0 0"/></joint>'
    )
    assert len(messages("JNT030", mount + robot("1.5707963 0 1.5707963"))) == count


CAMERA = """<link name="eye"/><link name="{link}"/>
<joint name="j" type="fixed"><origin rpy="{rpy}"/><parent link="eye"/><child link="{link}"/></joint>
<gazebo reference="{reference}">
<sensor name="s" type="camera"><pose>{pose}</pose></sensor></gazebo>"""


@pytest.mark.parametrize(
    ("link", "rpy", "reference", "pose", "count"),
    [
        ("eye_optical", "-1.5708 0 -1.5708", "eye_optical", "0 0 0 0 0 0", 1),
        ("eye_optical", "-1.5708 0 -1.5708", "eye_optical", "0 0 0 0 -1.57 1.57", 0),
        ("eye_optical", "-1.5708 0 -1.5708", "eye", "0 0 0 0 0 0", 0),
        ("eye_optical", "0.3 0 0", "eye_optical", "0 0 0 0 0 0", 0),
        ("eye_frame", "-1.5708 0 -1.5708", "eye_frame", "0 0 0 0 0 0", 0),
    ],
)
def test_a_camera_on_an_optical_frame(
    link: str, rpy: str, reference: str, pose: str, count: int
) -> None:
    text = CAMERA.format(link=link, rpy=rpy, reference=reference, pose=pose)
    assert len(reported("JNT030", text)) == count


PLUGIN = '<plugin name="p" filename="libgazebo_ros_camera.so"><{0}>{1}</{0}></plugin>'


@pytest.mark.parametrize(
    ("inner", "count"),
    [
        (PLUGIN.format("frameName", "base"), 1),
        (PLUGIN.format("frame_name", "base"), 1),
        (PLUGIN.format("frame_name", "camera_optical_frame"), 0),
        ("<gz_frame_id>base</gz_frame_id>", 1),
        ("<gz_frame_id>tip</gz_frame_id>", 0),
        ("", 0),
    ],
)
def test_a_frame_that_is_the_cameras_own_link_looks_along_x(inner: str, count: int) -> None:
    assert len(findings("JNT030", "camera", inner)) == count
    assert findings("JNT030", "imu", inner) == []


@pytest.mark.parametrize(("frame", "count"), [("eye_optical", 0), ("base", 1)])
def test_an_optical_frame_for_the_images_alone(frame: str, count: int) -> None:
    inner = (
        "<gz_frame_id>base</gz_frame_id><camera><optical_frame_id>{}</optical_frame_id></camera>"
    )
    assert len(findings("JNT030", "rgbd_camera", inner.format(frame))) == count


def test_a_link_that_is_called_optical_is_meant() -> None:
    inner = PLUGIN.format("frameName", "base_optical")
    assert findings("JNT030", "camera", inner, reference="base_optical") == []


@pytest.mark.parametrize(("mount", "count"), [("-1.57 0 -1.57", 0), ("0 0 0", 1)])
def test_a_frame_on_a_camera_that_is_rotated_already(mount: str, count: int) -> None:
    """TurtleBot 3 with GPS: camera_depth_frame has the rotation of the optical frame."""
    text = "".join(f'<link name="{name}"/>' for name in ("base", "cam_frame", "cam_optical_frame"))
    for child, parent, rpy in (
        ("cam_frame", "base", mount),
        ("cam_optical_frame", "cam_frame", "0 0 0"),
    ):
        text += (
            f'<joint name="{child}" type="fixed"><origin rpy="{rpy}"/><parent link="{parent}"/>'
            f'<child link="{child}"/></joint>'
        )
    assert len(reported("JNT030", text)) == count


@pytest.mark.parametrize(
    ("rpy", "pose", "count"),
    [
        ("0 3.14159 1.5708", "", 1),
        ("0 3.14159 1.5708", "<pose>0 0 0 1.5708 -1.5708 0</pose>", 0),
        ("0 0 0", "", 0),  # x-forward, whatever its name
        ("3.14159 0 0", "", 0),  # as of OpenGL
        ("0 0.3 0.7", "", 0),  # tilted
    ],
)
def test_a_camera_of_gazebo_on_an_optical_frame_that_looks_down(
    rpy: str, pose: str, count: int
) -> None:
    sensor = f'<sensor name="s" type="camera">{pose}</sensor>'
    text = robot(rpy) + f'<gazebo reference="camera_optical_frame">{sensor}</gazebo>'
    found = [one for one in messages("JNT030", text) if one.startswith("sensor")]
    assert found == [naming("s", "camera_optical_frame")] * count
