import pytest

from tests.gazebos import BASE, plugin, sensor
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit.text.diagnostic import Severity
from urdfkit.text.editing.apply import apply_edits

MOVE = "libgazebo_ros_planar_move.so"
TYPO = BASE + plugin(MOVE, "<robotBaseFrme>base</robotBaseFrme><odometryFrame>o</odometryFrame>")


def test_a_tag_that_is_not_read() -> None:
    text = BASE + plugin(MOVE, "<odometryFrame>odom</odometryFrame><enableYAxis>1</enableYAxis>")
    (found,) = reported("GAZ016", text)
    assert (found.message, found.severity) == (
        naming("p", MOVE, "unknown", "<enableYAxis>", "ignored"),
        Severity.INFO,
    )
    assert places("GAZ016", text) == [(4, "<enableYAxis>")]


def test_a_block_is_reported_once_with_its_path() -> None:
    wheel = '<wheel link_name="base"><wheel_normal_force>1</wheel_normal_force><a><b/></a></wheel>'
    text = BASE + plugin("libWheelSlipPlugin.so", wheel)
    assert messages("GAZ016", text) == [
        naming("p", "libWheelSlipPlugin.so", "unknown", "<a>", "<wheel>", "ignored")
    ]


def test_free_form_blocks_and_patterns() -> None:
    harness = plugin("libgazebo_ros_harness.so", "<joint name='j'><parent>x</parent></joint>")
    assert reported("GAZ016", BASE + harness) == []
    water = plugin("gz-sim-hydrodynamics-system", "<link_name>base</link_name><xDotU>1</xDotU>")
    assert reported("GAZ016", BASE + water) == []
    qos = "<ros><qos><topic name='a'><subscription><depth>1</depth></subscription></topic></qos>"
    ros = plugin(MOVE, f"{qos}</ros><odometry_frame>o</odometry_frame>")
    assert reported("GAZ016", BASE + ros) == []


@pytest.mark.parametrize(
    ("text", "targets"),
    [
        (plugin(MOVE, "<alwaysOn>true</alwaysOn>"), ()),  # of the shipped examples
        (plugin("libvendor.so", "<anything/>"), ()),
        (plugin(MOVE, "<enableYAxis>1</enableYAxis>"), ("gz-harmonic",)),  # GAZ012
        (plugin(MOVE, "<odometryRate>9</odometryRate>"), ()),  # the tags tell the generation
        (plugin(MOVE, "<publish_rate>9</publish_rate>"), ()),
    ],
)
def test_no_finding(text: str, targets: tuple[str, ...]) -> None:
    assert reported("GAZ016", BASE + text, targets=targets) == []


def of_other_generation(tags: str, target: str = "classic-ros2") -> list[tuple[str, str]]:
    found = reported("GAZ016", BASE + plugin(MOVE, tags), targets=(target,))
    assert {one.severity for one in found} <= {Severity.WARNING}
    return [(one.message, one.help) for one in found]


@pytest.mark.parametrize(
    ("old", "help"),
    [
        ("odometryFrame", naming("<odometry_frame>")),
        ("odometryRate", naming("<publish_rate>")),
        ("robotNamespace", naming("<ros>", "<namespace>...</namespace>", "</ros>")),
        ("commandTopic", naming("<ros>", "<remapping>FROM:=TO</remapping>", "</ros>")),
        ("cmdTimeout", naming("remove")),
    ],
)
def test_names_of_ros1(old: str, help: str) -> None:
    message = naming("p", MOVE, f"<{old}>", "ROS 1", "ROS 2")
    assert of_other_generation(f"<{old}>x</{old}>") == [(message, help)]
    assert of_other_generation(f"<{old}>x</{old}>", "classic-ros1") == []


def test_names_of_ros2() -> None:
    ((_, help),) = of_other_generation("<odometry_frame>x</odometry_frame>", "classic-ros1")
    assert help == "write <odometryFrame>"
    assert len(of_other_generation("<ros><namespace>x</namespace></ros>", "classic-ros1")) == 1


def test_only_a_pure_rename_is_fixed() -> None:
    text = BASE + plugin(MOVE, "<odometryRate>9</odometryRate><commandTopic>c</commandTopic>")
    found, other = reported("GAZ016", text, targets=("classic-ros2",))
    assert found.fix is not None
    assert other.fix is None
    edited = apply_edits(found.span.source.data, found.fix.edits)
    assert b"<publish_rate>9</publish_rate><commandTopic>c</commandTopic>" in edited


def test_the_tags_of_another_generation_are_one_finding_of_a_plugin() -> None:
    """And those that have no other name here are another one, for no fix writes them."""
    tags = "<odometryRate>9</odometryRate><commandTopic>c</commandTopic><robotBaseFrame>b"
    text = BASE + plugin(MOVE, f"{tags}</robotBaseFrame>")
    found, other = reported("GAZ016", text, targets=("classic-ros2",))
    assert "<odometryRate> and <robotBaseFrame>" in found.message
    assert found.related[0].message.endswith("write <robot_base_frame>")
    assert "<commandTopic>" in other.message


def test_no_second_tag_of_one_name() -> None:
    both = "<odometryRate>9</odometryRate><publish_rate>9</publish_rate>"
    (found,) = reported("GAZ016", BASE + plugin(MOVE, both), targets=("classic-ros2",))
    assert found.fix is None


def test_a_typo_is_fixed() -> None:
    (found,) = reported("GAZ016", TYPO)
    assert found.severity is Severity.WARNING
    assert found.help == naming("<robotBaseFrame>")
    assert "<robotBaseFrame>base</robotBaseFrame>" in fixed("GAZ016", TYPO)
    assert reported("GAZ016", TYPO.replace(MOVE, "libvendor.so")) == []


def has_suggestion(text: str) -> bool:
    return any("did you mean" in found.help for found in reported("GAZ016", text))


def test_what_is_no_typo() -> None:
    """Taken for <hackBaseline>, <baseline> would move the second camera of a stereo pair."""
    given = TYPO.replace("<odometryFrame>", "<robotBaseFrame>base</robotBaseFrame><odometryFrame>")
    assert not has_suggestion(given)
    left = plugin("libgazebo_ros_diff_drive.so", "<frontLeftJoint>a</frontLeftJoint>")
    assert not has_suggestion(BASE + left)
    camera = '<plugin name="c" filename="libgazebo_ros_camera.so"><{0}>0.2</{0}></plugin>'
    assert not has_suggestion(BASE + sensor("camera", camera.format("baseline")))
    assert has_suggestion(BASE + sensor("camera", camera.format("hackBaselin")))


@pytest.mark.parametrize(
    ("value", "severity"), [("0.0", "info"), ("0", "info"), ("0.1", "warning")]
)
def test_a_misspelt_tag_with_the_default(value: str, severity: str) -> None:
    """`<distortion_k2>0.0</distortion_k2>`, as older tutorials have it."""
    tag = f"<distortion_k2>{value}</distortion_k2>"
    (found,) = reported("GAZ016", BASE + plugin("libgazebo_ros_openni_kinect.so", tag))
    assert found.severity.value == severity
