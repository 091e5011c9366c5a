import pytest

from tests.gazebos import BASE, block, plugin
from tests.naming import naming
from tests.reported import messages, reported
from tests.sensing import findings, scan


@pytest.mark.parametrize(
    ("tag", "message"),
    [
        (
            "<mu1>high</mu1>",
            "<mu1> is 'high', not a number: Gazebo's URDF converter ends with an exception",
        ),
        (
            "<kp/>",
            "<kp> is empty, not a number: Gazebo's URDF converter ends with an exception",
        ),
        ("<mu1>0,5</mu1>", "<mu1> is '0,5', which Gazebo reads as 0"),
        ('<mu1 value="0,5"/>', "<mu1> is '0,5', which Gazebo reads as 0"),
        ("<kp>1.2.3</kp>", "<kp> is '1.2.3', which Gazebo reads as 1.2"),
        ("<kp>1.2.</kp>", "<kp> is '1.2.', which Gazebo reads as 1.2"),
        ("<minDepth>1 mm</minDepth>", "<minDepth> is '1 mm', which Gazebo reads as 1"),
        ("<kd>nan</kd>", "<kd> is 'nan': the simulation spreads it to all links"),
        (
            "<mu1>-1</mu1>",
            "<mu1> is '-1', must be >= 0: contacts pull or the simulation becomes unstable",
        ),
        ("<fdir1>a b c</fdir1>", "<fdir1> is 'a b c', not 3 numbers"),
        ("<selfCollide>on</selfCollide>", "<selfCollide> is 'on', which Gazebo reads as false"),
        (
            "<turnGravityOff>off</turnGravityOff>",
            "<turnGravityOff> is 'off', which Gazebo reads as true",
        ),
        (
            "<gravity>yes</gravity>",
            "<gravity> is 'yes', must be true or false: gz-sim rejects the model",
        ),
    ],
)
def test_what_gazebo_makes_of_it(tag: str, message: str) -> None:
    assert messages("GAZ004", BASE + block(tag)) == [message]


@pytest.mark.parametrize(("text", "severity"), [("1.2.", "warning"), ("1.2.3", "error")])
def test_a_point_behind_a_number(text: str, severity: str) -> None:
    """bumperbot-ros2-core: Gazebo reads 0.1. as intended."""
    (found,) = reported("GAZ004", BASE + block(f"<mu2>{text}</mu2>"))
    assert found.severity.value == severity


@pytest.mark.parametrize(
    "tag",
    [
        "<mu1>0.5</mu1>",
        "<mu1> .5 </mu1>",
        '<mu1 value="0.5"/>',
        '<mu1 value=" 0.5 "/>',
        "<mu1>inf</mu1>",
        "<kp>@STIFFNESS@</kp>",
        "<kp>1e6 N/m</kp>",
        "<kp>1e6</kp>",
        "<kp>+1000000.0</kp>",
        "<maxContacts>5.5</maxContacts>",
        "<selfCollide>True</selfCollide>",
        "<selfCollide>yes</selfCollide>",
        "<selfCollide>0</selfCollide>",
        "<turnGravityOff>no</turnGravityOff>",
        "<gravity>1</gravity>",
        "<material>Gazebo/Red</material>",
        "<unknown>word</unknown>",
    ],
)
def test_good_values(tag: str) -> None:
    assert reported("GAZ004", BASE + block(tag)) == []


def test_a_switch_on_the_wrong_kind_is_reported_by_gaz005() -> None:
    robot = BASE + block("<implicitSpringDamper>3</implicitSpringDamper>")
    assert messages("GAZ004", robot) == []
    assert len(messages("GAZ005", robot)) == 1


# --- plugins

DRIVE = "libgazebo_ros_diff_drive.so"
IMU = "libgazebo_ros_imu.so"


@pytest.mark.parametrize(
    ("file", "tag", "said"),
    [
        (DRIVE, "<wheelDiameter>0,2</wheelDiameter>", ["<wheelDiameter>", "0,2", "0"]),
        (DRIVE, "<wheelDiameter>big</wheelDiameter>", ["<wheelDiameter>", "big", "number"]),
        (DRIVE, "<wheelDiameter/>", ["<wheelDiameter>", "empty", "number"]),
        (DRIVE, "<publishTf>yes</publishTf>", ["<publishTf>", "yes", "false"]),
        (DRIVE, "<publishTf>1.0</publishTf>", ["<publishTf>", "1.0", "false"]),
        (
            DRIVE,
            "<wheelDiameter>20 cm</wheelDiameter>",
            ["<wheelDiameter>", "20 cm", "20"],
        ),
        (
            DRIVE,
            "<odometrySource>encoders</odometrySource>",
            ["<odometrySource>", "encoders", "encoder or world", "encoder"],
        ),
        (
            "libgazebo_ros_range.so",
            "<radiation>SONAR</radiation>",
            ["<radiation>", "SONAR", "ultrasound or infrared", "as infrared"],
        ),
        (IMU, "<xyzOffset>0 x 1</xyzOffset>", ["<xyzOffset>", "0 x 1", "3"]),
        (IMU, "<xyzOffset>0,0,0</xyzOffset>", ["<xyzOffset>", "0,0,0", "3"]),
        (IMU, "<xyzOffset>0 0</xyzOffset>", ["<xyzOffset>", "0 0", "3"]),
    ],
)
def test_what_a_plugin_reads(file: str, tag: str, said: list[str]) -> None:
    assert messages("GAZ004", BASE + plugin(file, tag)) == [naming("p", file, *said)]


@pytest.mark.parametrize(("text", "count"), [("cmd_vel=robot/cmd_vel", 1), ("a:=b", 0)])
def test_a_remapping_has_two_names(text: str, count: int) -> None:
    tags = f"<ros><remapping>{text}</remapping></ros><left_joint>a</left_joint>"
    assert len(reported("GAZ004", BASE + plugin(DRIVE, tags))) == count


@pytest.mark.parametrize(
    ("file", "tag"),
    [
        (DRIVE, "<wheelDiameter> 2e-1 </wheelDiameter>"),
        (DRIVE, "<wheelDiameter>.2</wheelDiameter>"),
        (DRIVE, "<wheelDiameter>-2.</wheelDiameter>"),
        (DRIVE, "<wheelDiameter>0.2 m</wheelDiameter>"),  # reads as 0.2
        (DRIVE, "<publishTf>True</publishTf>"),
        (DRIVE, "<publishTf>0</publishTf>"),
        (DRIVE, "<publishTf>no</publishTf>"),
        (IMU, "<xyzOffset>0 0.5 -1e-3</xyzOffset>"),
        # A quaternion is read from roll, pitch and yaw.
        ("libhector_gazebo_ros_imu.so", "<rpyOffset>0 0 -0.7</rpyOffset>"),
        (DRIVE, "<unknown>big</unknown>"),
        ("libvendor.so", "<wheelDiameter>big</wheelDiameter>"),
    ],
)
def test_good_values_of_plugins(file: str, tag: str) -> None:
    assert reported("GAZ004", BASE + plugin(file, tag)) == []


# --- sensors

CAMERA = "<camera><image><width>{}</width><height>480</height><format>{}</format></image></camera>"


@pytest.mark.parametrize(
    ("type", "inner", "wanted"),
    [
        (
            "imu",
            "<update_rate>often</update_rate>",
            naming("s", "<update_rate>", "often", "number", "rejects"),
        ),
        (
            "imu",
            "<update_rate>0,5</update_rate>",
            naming("s", "<update_rate>", "0,5", "Gazebo", "0"),
        ),
        (
            "imu",
            "<always_on>yes</always_on>",
            naming("s", "<always_on>", "yes", "true or false", "rejects"),
        ),
        (
            "imu",
            "<pose>0 0 1</pose>",
            naming("s", "<pose>", "0 0 1", "6", "rejects"),
        ),
        (
            "camera",
            "<camera><clip><near>near</near></clip></camera>",
            naming("s", "<near>", "near", "number", "rejects"),
        ),
        (
            "camera",
            "<camera><clip><far>50 cm</far></clip></camera>",
            naming("s", "<far>", "50 cm", "Gazebo", "50"),
        ),
        (
            "camera",
            "<camera><horizontal_fov>1,2</horizontal_fov></camera>",
            naming("s", "<horizontal_fov>", "1,2", "Gazebo", "1"),
        ),
        (
            "camera",
            "<camera><save enabled='yes'><path>/tmp</path></save></camera>",
            naming("s", "enabled", "yes", "true or false", "rejects"),
        ),
        (
            "camera",
            CAMERA.format("1e3", "L8"),
            naming("s", "<width>", "1e3", "Gazebo", "1"),
        ),
        (
            "imu",
            "<imu><linear_acceleration><z><noise type='normal'/></z></linear_acceleration></imu>",
            naming("s", "type", "normal", "gaussian", "gaussian_quantized", "none"),
        ),
        (
            "camera",
            CAMERA.format(0, "L8"),
            naming("s", "<width>", "0", ">= 1"),
        ),
        (
            "camera",
            CAMERA.format(640, "r8g8b8"),
            naming("s", "<format>", "r8g8b8", "unknown", "rejects", "R8G8B8"),
        ),
        (
            "ray",
            "<ray><noise><type>normal</type></noise><range/></ray>",
            naming("s", "<type>", "normal", "gaussian", "gaussian_quantized", "none"),
        ),
        (
            "imu",
            (
                "<imu><angular_velocity><x><noise type='gaussian'><stddev>-1</stddev></noise></x>"
                "</angular_velocity></imu>"
            ),
            naming("s", "<stddev>", "-1", ">= 0", "rejects"),
        ),
    ],
)
def test_what_sdf_rejects(type: str, inner: str, wanted: str) -> None:
    (finding,) = findings("GAZ004", type, inner)
    assert finding.message == wanted
    assert finding.span.line == 10


@pytest.mark.parametrize(
    "inner",
    [
        "<visualize>__lidar_visualize__</visualize>",  # velmwheel: a node replaces it
        "<update_rate> 30 Hz </update_rate>",  # read as 30
        "<always_on>TRUE</always_on>",
        "<camera><horizontal_fov>60</horizontal_fov></camera>",  # GAZ047
        "<pose>0 0 0 0 0 0</pose>",
        "<ray><range><min>0.1</min><max>inf</max></range></ray>",
        CAMERA.format(640, "R8G8B8"),
        CAMERA.format("640.0", "R8G8B8"),
    ],
)
def test_good_values_of_sensors(inner: str) -> None:
    assert findings("GAZ004", "camera", inner) == []


def test_beams_that_a_quotient_left_are_cut_to_a_whole_number() -> None:
    text = "<ray><scan><horizontal><samples>{}</samples></horizontal></scan><range/></ray>"
    assert findings("GAZ004", "ray", text.format("666.518518519")) == []
    assert len(findings("GAZ004", "ray", text.format("6.6e2"))) == 1


@pytest.mark.parametrize(
    ("least", "most", "count"), [(10, 0.1, 1), (1, 1, 1), (0.1, 10, 0), (0, 0.5, 0)]
)
def test_the_least_must_be_below_the_greatest(least: float, most: float, count: int) -> None:
    found = findings("GAZ004", "ray", scan(-1, 1, least=least, most=most))
    assert len(found) == count
    assert all(finding.span.text == "<min>" for finding in found)


@pytest.mark.parametrize(
    ("first", "last", "samples", "count"),
    [(2, -2, 360, 1), (2, 2, 360, 1), (0, 0, 1, 0), (-2, 2, 360, 0)],
)
def test_the_first_beam_must_be_before_the_last(
    first: float, last: float, samples: int, count: int
) -> None:
    found = findings("GAZ004", "ray", scan(first, last, samples))
    assert len(found) == count
    assert all(finding.span.text == "<min_angle>" for finding in found)


def test_without_a_range_nothing_is_seen() -> None:
    (finding,) = findings("GAZ004", "ray", "<ray><scan/></ray>")
    assert finding.message == naming("s", "<ray>", "<range>", "0 m")


@pytest.mark.parametrize(
    ("kind", "targets", "count"),
    [
        ("ray", ("classic-ros1",), 0),
        ("gpu_ray", ("classic-ros1",), 1),
        ("ray", ("classic-ros2", "gz-harmonic"), 1),
    ],
)
def test_rays_of_classic_may_sweep_backwards(
    kind: str, targets: tuple[str, ...], count: int
) -> None:
    assert len(findings("GAZ004", kind, scan(2, -2), targets=targets)) == count
    assert len(findings("GAZ004", kind, scan(2, 2), targets=targets)) == count


def test_no_beam_is_shorter_than_nothing() -> None:
    (finding,) = findings("GAZ004", "ray", scan(-1, 1, least=-0.1))
    assert finding.message == naming("s", "-0.1 m", ">= 0")


@pytest.mark.parametrize(("near", "far", "count"), [(1, 0.5, 1), (1, 1, 1), (0.02, 300, 0)])
def test_near_must_be_below_far(near: float, far: float, count: int) -> None:
    clip = f"<camera><clip><near>{near}</near><far>{far}</far></clip></camera>"
    found = findings("GAZ004", "camera", clip)
    assert len(found) == count
    assert all(finding.span.text == "<near>" for finding in found)


@pytest.mark.parametrize("near", [0, -0.05])
def test_near_must_be_above_zero(near: float) -> None:
    (finding,) = findings("GAZ004", "camera", f"<camera><clip><near>{near}</near></clip></camera>")
    assert finding.message == naming("s", f"{near:g} m", "> 0")


@pytest.mark.parametrize(
    ("target", "severity"), [("classic-ros1", "warning"), ("gz-harmonic", "error")]
)
def test_what_gz_rejects_in_a_robot_for_gazebo_classic(target: str, severity: str) -> None:
    """jsk_aerial_robot's camera has the <format> RGB, for which Classic takes its default."""
    image = "<width>640</width><height>480</height><format>RGB</format>"
    text = (
        '<link name="eye"/><gazebo reference="eye"><sensor name="eye" type="camera"><camera>'
        f"<image>{image}</image></camera></sensor></gazebo>"
    )
    (found,) = reported("GAZ004", text, targets=(target,))
    assert found.severity.value == severity
