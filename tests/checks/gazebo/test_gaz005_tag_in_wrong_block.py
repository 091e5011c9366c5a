import pytest

from tests.gazebos import BASE, block, child
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit.text.diagnostic import Severity

ROBOT = BASE + child("cam", "fixed") + child("arm")


def heard(tag: str, reference: str) -> list[tuple[str, str]]:
    found = reported("GAZ005", ROBOT + block(f"<{tag}>1</{tag}>", reference))
    return [(one.message, one.help) for one in found]


def test_a_joint_tag_at_a_link() -> None:
    assert heard("preserveFixedJoint", "cam") == [
        (
            "<preserveFixedJoint> is for a joint, but 'cam' is a link (ignored)",
            naming("move", '<gazebo reference="cam_joint">'),
        )
    ]


def test_a_link_tag_at_a_joint() -> None:
    assert heard("mu1", "arm_joint") == [
        (
            "<mu1> is for a link, but 'arm_joint' is a joint (ignored)",
            naming("move", '<gazebo reference="arm">'),
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


@pytest.mark.parametrize(
    ("tag", "owner"),
    [
        ("mu1", "link"),
        ("material", "link"),
        ("selfCollide", "link"),
        ("turnGravityOff", "link"),
        ("sensor", "link"),
        ("preserveFixedJoint", "joint"),
        ("provideFeedback", "joint"),
    ],
)
def test_tags_of_links_and_joints(tag: str, owner: str) -> None:
    (found,) = reported("GAZ005", BASE + block(f"<{tag}>1</{tag}>", ""))
    is_harmless = tag in ("material", "preserveFixedJoint")
    assert found.severity is (Severity.WARNING if is_harmless else Severity.ERROR)
    assert found.message == (
        f"<{tag}> in a <gazebo> without a reference (ignored): it is for a {owner}"
    )


@pytest.mark.parametrize("tag", ["plugin", "static", "self_collide", "link", "pose", "xyz"])
def test_what_a_model_has_or_nobody_knows(tag: str) -> None:
    assert reported("GAZ005", BASE + block(f"<{tag}>1</{tag}>", "")) == []


@pytest.mark.parametrize(
    ("tag", "value", "count"),
    [
        ("gravity", "1", 0),  # OpenMower
        ("gravity", "true", 0),
        ("gravity", "0", 1),
        ("turnGravityOff", "false", 0),
        ("kinematic", "false", 0),
        ("provideFeedback", "0", 0),
        ("kinematic", "true", 1),
        ("mu1", "0", 1),
    ],
)
def test_a_value_that_holds_without_the_tag(tag: str, value: str, count: int) -> None:
    assert len(reported("GAZ005", BASE + block(f"<{tag}>{value}</{tag}>", ""))) == count


def test_with_a_reference_all_is_well() -> None:
    assert reported("GAZ005", BASE + block("<mu1>1</mu1>")) == []


@pytest.mark.parametrize("name", ["refernce", "link"])
def test_a_reference_by_another_name_is_reported_once(name: str) -> None:
    tags = "<mu1>1</mu1><mu2>1</mu2>"
    (found,) = reported("GAZ005", BASE + f'<gazebo {name}="base">{tags}</gazebo>')
    assert found.message.startswith(f'unknown attribute {name}="base" in <gazebo>')
    assert found.help == 'write reference="base"'


def test_the_physics_of_a_world_are_for_no_joint() -> None:
    physics = '<physics type="ode"><max_step_size>0.001</max_step_size></physics>'
    (found,) = reported("GAZ005", BASE + block(physics, ""))
    assert found.severity is Severity.WARNING
    assert found.help == naming("write", "<world>")
    assert "for a joint" in reported("GAZ005", BASE + block("<physics/>", ""))[0].message


def test_a_block_is_reported_once() -> None:
    tags = "<mu1>1</mu1><mu2>1</mu2><kp>1</kp><kd>1</kd><mu1>1</mu1>"
    robot = BASE + block(f"{tags}<static>1</static>", "")
    (message,) = messages("GAZ005", robot)
    assert message.startswith("<mu1>, <mu2>, <kp>, <kd> in a <gazebo> without a reference")
    assert places("GAZ005", robot)[0][1] == "<gazebo>"
    longer = BASE + block(f"{tags}<selfCollide>1</selfCollide>", "")
    assert " <kd> and others in " in messages("GAZ005", longer)[0]


def test_a_joint_by_another_name_of_the_reference() -> None:
    flag = '<gazebo joint="arm_joint"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'
    (found,) = reported("GAZ005", BASE + child("arm", "fixed") + flag)
    assert found.help == 'write reference="arm_joint"'
