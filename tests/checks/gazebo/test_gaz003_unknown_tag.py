import pytest

from tests.gazebos import BASE, block
from tests.naming import naming
from tests.reported import fixed, messages, reported
from tests.sensing import findings
from urdfkit.ros.catalog.extensions import extensions, suggested


@pytest.mark.parametrize(("wrong", "right"), [*suggested().items(), ("selfcollide", "selfCollide")])
def test_typos_are_fixed(wrong: str, right: str) -> None:
    text = BASE + block(f"<{wrong}>1</{wrong}>")
    assert messages("GAZ003", text) == [naming("unknown", f"<{wrong}>", "<gazebo>", "ignored")]
    assert f"<{right}>1</{right}>" in fixed("GAZ003", text)


@pytest.mark.parametrize(("kind", "count"), [("continuous", 0), ("fixed", 1)])
def test_a_robot_with_joints_is_not_made_static(kind: str, count: int) -> None:
    """RealMan's arms have <is_static>true</is_static>, which Gazebo ignores, and controllers."""
    arm = '<link name="a"/><joint name="j" type="{}"><parent link="base"/><child link="a"/></joint>'
    text = BASE + arm.format(kind) + "<gazebo><is_static>true</is_static></gazebo>"
    (found,) = reported("GAZ003", text)
    assert (found.fix is not None, "mean <static>" in found.help) == (count, count)


def test_one_finding_for_a_name_that_nothing_is_like() -> None:
    assert messages("GAZ003", BASE + block("<stopKp>1</stopKp>")) == [
        naming("unknown", "<stopKp>", "<gazebo>", "ignored")
    ]
    text = BASE + block("<stopKp>1</stopKp>") + block("<stopKp>2</stopKp>")
    (found,) = reported("GAZ003", text)
    assert found.message == naming("unknown", "<stopKp>", "<gazebo>", "ignored", "2")
    assert [note.span.text for note in found.related] == ["<stopKp>"]
    assert found.fix is None
    (found,) = reported("GAZ003", BASE + 9 * block("<stopKp>1</stopKp>"))
    assert found.message.endswith("(9 times)")
    assert len(found.related) == 4


def test_known_tags() -> None:
    known = [*extensions(), "gravity", "sensor", "plugin", "vendor:tag"]
    assert reported("GAZ003", BASE + "".join(block(f"<{tag}>1</{tag}>") for tag in known)) == []


def test_what_belongs_into_the_robot_is_reported() -> None:
    hardware = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    control = block(f'<ros2_control name="c" type="system">{hardware}</ros2_control>', "")
    (found,) = reported("GAZ003", BASE + control)
    assert found.help == naming("<ros2_control>", "<gazebo>", "<robot>")
    assert messages("GAZ010", BASE + control) == []


def test_the_nearest_name_is_suggested():
    (finding,) = findings("GAZ003", "imu", "<updaterate>1</updaterate>")
    assert finding.message == naming(
        "s", "unknown", "<updaterate>", "<sensor>", "ignored", "update_rate"
    )
    assert finding.span.line == 10


@pytest.mark.parametrize("tag", ["update_rate", "ray", "camera", "plugin", "gz_frame_id", "my:tag"])
def test_what_sensors_have_is_not_reported(tag):
    assert findings("GAZ003", "ray", f"<{tag}/>") == []


def test_a_typo_deep_in_the_settings():
    inner = "<camera><image>\n<widht>640</widht></image></camera>"
    (finding,) = findings("GAZ003", "camera", inner)
    assert finding.message == naming("s", "unknown", "<widht>", "<image>", "ignored", "width")
    assert (finding.span.line, finding.span.text) == (11, "<widht>")
    assert finding.fix


def test_what_is_in_an_unknown_tag_is_not_reported_as_well():
    inner = "<camera><imaeg><widht>640</widht></imaeg></camera>"
    assert len(findings("GAZ003", "camera", inner)) == 1


@pytest.mark.parametrize(
    "inner",
    [
        "<camera><noise><type>gaussian</type><mean>0</mean><stddev>1</stddev></noise></camera>",
        "<ray><scan><vertical><samples>16</samples></vertical></scan></ray>",
        (
            "<imu><angular_velocity><x><noise type='none'><bias_mean>0</bias_mean></noise></x>"
            "</angular_velocity></imu>"
        ),
    ],
)
def test_what_sdf_knows_is_not_reported(inner):
    assert findings("GAZ003", "camera", inner) == []


@pytest.mark.parametrize(("tag", "instead"), [("origin", "<pose>"), ("noise", "<ray>")])
def test_what_belongs_elsewhere_is_reported(tag, instead):
    (finding,) = findings("GAZ003", "ray", f"<{tag}/>")
    assert finding.message == naming("s", "unknown", f"<{tag}>", "<sensor>", "ignored")
    assert instead in finding.help


def test_the_parent_is_not_suggested_for_its_own_child():
    """tauv: the fix made <distortionModel> a <distortion> in the <distortion>."""
    inner = "<camera><distortion><distortionModel>plumb_bob</distortionModel></distortion></camera>"
    (finding,) = findings("GAZ003", "camera", inner)
    message = naming("s", "unknown", "<distortionModel>", "<distortion>", "ignored")
    assert (finding.message, finding.help, finding.fix) == (message, "remove it", None)


def test_a_setting_beside_its_block() -> None:
    """swarm_description has <optical_frame_id> beside <camera>."""
    (found,) = findings("GAZ003", "camera", "<camera/><optical_frame_id>base</optical_frame_id>")
    assert found.message == naming("s", "unknown", "<optical_frame_id>", "<sensor>", "ignored")
    assert found.help == "move it into <camera>"
