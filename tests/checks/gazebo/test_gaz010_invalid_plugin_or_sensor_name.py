import pytest

from tests.gazebos import BASE, BODY, child, plugin, sensor
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit.lint.rule_examples import whole_robot


@pytest.mark.parametrize(
    ("attributes", "expected"),
    [
        ('filename="libx.so"', [naming("libx.so", "no name", "Gazebo", "rejects")]),
        ('filename="libx.so" name=" "', [naming("libx.so", "no name", "Gazebo", "rejects")]),
        ('name="x"', [naming("x", "no filename", "Gazebo", "rejects")]),
        (
            "",
            [
                naming("<plugin>", "no filename", "Gazebo", "rejects"),
                naming("<plugin>", "no name", "Gazebo", "rejects"),
            ],
        ),
        ('name="x" filename="libx.so"', []),
    ],
)
def test_both_are_required(attributes: str, expected: list[str]) -> None:
    assert messages("GAZ010", BASE + f"<gazebo><plugin {attributes}/></gazebo>") == expected


def test_the_hardware_plugin_of_ros2_control_has_neither() -> None:
    hardware = "<hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>"
    text = f'{BASE}<ros2_control name="c" type="system">{hardware}</ros2_control>'
    assert reported("GAZ010", text) == []


def test_a_plugin_is_named_after_its_library() -> None:
    text = BASE + '<gazebo><plugin filename="libgazebo_ros_x.so"/></gazebo>'
    assert '<plugin name="gazebo_ros_x" filename="libgazebo_ros_x.so"/>' in fixed("GAZ010", text)


@pytest.mark.parametrize(
    "plugins",
    [
        '<plugin name="" filename="libx.so"/>',  # a second attribute of that name would be no XML
        '<plugin filename="libx.so"/><plugin name="x" filename="liby.so"/>',  # taken
        '<plugin filename="gz-sim-imu-system"/>',  # no name of a ROS node
        '<plugin name="x"/>',
    ],
)
def test_no_fix(plugins: str) -> None:
    assert [one.fix for one in reported("GAZ010", f"{BASE}<gazebo>{plugins}</gazebo>")] == [None]


MOVE = "libgazebo_ros_planar_move.so"
NEW = "<odometry_frame>odom</odometry_frame>"


@pytest.mark.parametrize(
    ("name", "good"),
    [("a-b", "a_b"), ("a b", "a_b"), ("/a/b", "_a_b"), ("2wd", "_2wd"), ("räder", "r_der")],
)
def test_names_that_ros2_rejects(name: str, good: str) -> None:
    text = BASE + plugin(MOVE, NEW, name)
    (message,) = messages("GAZ010", text)
    assert "valid ROS 2" in message
    assert places("GAZ010", text) == [(4, name)]
    assert f'<plugin name="{good}"' in fixed("GAZ010", text)


def test_a_plugin_that_gazebo_does_not_read_is_not_rejected() -> None:
    """In a block of a link it is an unknown element, which is copied without a look at it."""
    text = BASE + '<gazebo reference="base"><plugin name="x"/></gazebo>'
    assert reported("GAZ010", text) == []
    assert len(reported("GAZ014", text)) == 1


@pytest.mark.parametrize("name", ["a", "A_b2", "_2wd", "camera${suffix}"])
def test_names_that_ros2_takes(name: str) -> None:
    assert reported("GAZ010", BASE + plugin(MOVE, NEW, name)) == []


def test_other_plugins_are_no_nodes_of_that_name() -> None:
    text = BASE + plugin(MOVE, "<odometryFrame>odom</odometryFrame>", "a-b")
    assert reported("GAZ010", text) == []
    assert (
        reported("GAZ010", BASE + plugin("gz-sim-imu-system", name="gz::sim::systems::Imu")) == []
    )
    assert reported("GAZ010", BASE + plugin("libvendor.so", name="a-b")) == []


def test_a_sensor_without_a_name() -> None:
    for name in ("", ' name=""', ' name=" "'):
        text = BASE + sensor("imu", "").replace(' name="s"', name)
        assert messages("GAZ010", text) == [naming("imu", "base", "no name", "Gazebo", "rejects")]
        ((_, at),) = places("GAZ010", text)
        assert at.startswith("<sensor")


def test_a_sensor_with_one_is_not_reported() -> None:
    assert messages("GAZ010", BASE + sensor("imu", "")) == []


# --- duplicate names

P3D = "libgazebo_ros_p3d.so"
POSE = "<body_name>base</body_name>"


def pair(first: str = "<publish_rate>1</publish_rate>", second: str = "") -> str:
    return BASE + plugin(MOVE, first) + plugin(P3D, POSE + second)


def test_two_nodes_of_one_name() -> None:
    assert messages("GAZ010", pair()) == [naming("p", P3D, "p", MOVE)]
    assert places("GAZ010", pair()) == [(7, "p")]


def test_namespaces_keep_them_apart() -> None:
    space = "<ros><namespace>{}</namespace></ros>"
    assert reported("GAZ010", pair(space.format("/a"), space.format("/b"))) == []
    assert len(reported("GAZ010", pair(space.format("/a"), space.format("a")))) == 1


def test_other_names_and_other_generations() -> None:
    assert reported("GAZ010", BASE + plugin(MOVE, name="a") + plugin(P3D, POSE, name="b")) == []
    assert reported("GAZ010", pair(), targets=("classic-ros1",)) == []
    assert reported("GAZ010", BASE + 2 * plugin("libvendor.so")) == []


LUMPED = BASE + child("tip", "fixed", inside=BODY)


def test_two_on_one_link() -> None:
    assert messages("GAZ010", BASE + sensor("imu", "") + sensor("camera", "")) == [
        naming("duplicate", "s", "base", "rejects")
    ]


def test_two_on_links_that_gazebo_merges() -> None:
    assert messages("GAZ010", LUMPED + sensor("imu", "") + sensor("imu", "", "tip")) == [
        naming("duplicate", "s", "tip", "base", "rejects")
    ]


def test_other_names_and_other_links_are_not_reported() -> None:
    other = sensor("imu", "").replace('"s"', '"t"')
    assert messages("GAZ010", BASE + sensor("imu", "") + other) == []
    apart = BASE + child("tip", inside=BODY) + sensor("imu", "") + sensor("imu", "", "tip")
    assert messages("GAZ010", apart) == []


@pytest.mark.parametrize(("right", "wrong"), [("name", "nmae"), ("filename", "filname")])
def test_a_misspelt_attribute_is_renamed(right: str, wrong: str) -> None:
    text = BASE + plugin("libgazebo_ros_laser.so")
    misspelt = text.replace(f' {right}="', f' {wrong}="').replace(f"link {wrong}", f"link {right}")
    assert fixed("GAZ010", misspelt) == whole_robot(text)


CAMERA = '<gazebo><plugin name="{}" filename="libgazebo_ros_camera.so">{}</plugin></gazebo>'


@pytest.mark.parametrize(
    ("front", "rear", "count"),
    [
        ("<camera_name>eye</camera_name>", "<camera_name>eye</camera_name>", 1),
        ("<camera_name>eye</camera_name>", "<camera_name>ear</camera_name>", 0),
        ("<camera_name>eye</camera_name>", "", 0),
        (
            "<camera_name>eye</camera_name>",
            "<ros><remapping>eye/image_raw:=rear</remapping></ros><camera_name>eye</camera_name>",
            0,
        ),
        (
            "<camera_name>eye</camera_name>",
            "<ros><namespace>rear</namespace></ros><camera_name>eye</camera_name>",
            0,
        ),
    ],
)
def test_cameras_of_one_name(front: str, rear: str, count: int) -> None:
    text = BASE + CAMERA.format("front", front) + CAMERA.format("rear", rear)
    both = [one for one in messages("GAZ010", text) if "publish on 'eye/image_raw'" in one]
    assert len(both) == count
