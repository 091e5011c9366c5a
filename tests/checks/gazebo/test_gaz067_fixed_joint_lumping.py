import pytest

from tests.gazebos import BASE, BODY, block, child
from tests.massive import shape
from tests.naming import naming, values
from tests.reported import fixed, messages, places
from tests.sensing import findings
from tests.xacros import reported as in_xacro
from urdfkit import Diagnostic

CAMERA = child("camera", "fixed")
OFF = "<turnGravityOff>true</turnGravityOff>"


@pytest.mark.parametrize(
    "tag",
    [
        OFF,
        '<turnGravityOff value="1"/>',
        "<gravity>false</gravity>",
        "<selfCollide>yes</selfCollide>",
        "<self_collide>1</self_collide>",
    ],
)
def test_a_flag_of_a_merged_link(tag: str) -> None:
    base = BASE.replace("</link>", shape("collision", '<sphere radius="0.1"/>') + "</link>")
    (message,) = messages("GAZ067", base + CAMERA + block(tag, "camera"))
    assert values(message)[-2:] == ["camera", "base"]


@pytest.mark.parametrize(
    ("tag", "reference", "more"),
    [
        (OFF, "base", ""),
        (OFF, "camera", block(OFF)),  # meant for both
        (OFF, "camera", block("<preserveFixedJoint>true</preserveFixedJoint>", "camera_joint")),
        *(
            (f"<{tag}>{value}</{tag}>", "camera", "")
            for tag in ("turnGravityOff", "selfCollide")
            for value in ("no", "0", "false")
        ),
        ("<gravity>true</gravity>", "camera", ""),
        *((f"<self_collide>{value}</self_collide>", "camera", "") for value in ("0", "false")),
        ("<gravity>1</gravity>", "camera", ""),
        ("<mu1>0.1</mu1>", "camera", ""),
    ],
)
def test_others_are_not_reported(tag: str, reference: str, more: str) -> None:
    assert messages("GAZ067", BASE + CAMERA + block(tag, reference) + more) == []


KEEP = block("<preserveFixedJoint>true</preserveFixedJoint>", "tip_joint")


@pytest.mark.parametrize("tag", ["preserveFixedJoint", "disableFixedJointLumping"])
def test_a_link_without_mass_is_dropped_all_the_same(tag: str) -> None:
    robot = BASE + child("tip", "fixed", inside="") + KEEP.replace("preserveFixedJoint", tag)
    assert messages("GAZ067", robot) == [
        f"<{tag}> of joint 'tip_joint' has no effect: Gazebo drops link 'tip', which has no mass"
    ]


@pytest.mark.parametrize(
    ("kind", "inside", "keep"),
    [
        ("fixed", BODY, KEEP),
        ("fixed", "", KEEP.replace("true", "false")),
        ("continuous", "", KEEP),  # INE004
        ("fixed", "", ""),
    ],
)
def test_others_are_not_reported_66(kind: str, inside: str, keep: str) -> None:
    assert messages("GAZ067", BASE + child("tip", kind, inside=inside) + keep) == []


def test_what_is_merged_into_the_link_gives_it_mass() -> None:
    robot = BASE + child("tip", "fixed", inside="") + child("end", "fixed", parent="tip")
    assert messages("GAZ067", robot + KEEP) == []


SHAPE = "<{0}{1}><geometry><sphere radius='0.1'/></geometry></{0}>"
MU = "<mu1>0.2</mu1>"


def wheel(kind: str, name: str, joint: str = "continuous", link: str = "wheel") -> str:
    named = f' name="{name}"' if name else ""
    return child(link, joint, inside=BODY + SHAPE.format(kind, named))


@pytest.mark.parametrize(
    ("kind", "tags", "listed"),
    [
        ("collision", MU, ["<mu1>"]),
        ("collision", "<mu1>1</mu1><kp>1</kp>", ["<mu1>", "<kp>"]),
        ("visual", "<material>Gazebo/Red</material>", ["<material>"]),
    ],
)
def test_a_shape_whose_name_is_its_own(kind: str, tags: str, listed: list[str]) -> None:
    robot = BASE + wheel(kind, "tyre") + block(tags, "wheel")
    (message,) = messages("GAZ067", robot)
    assert message == naming(*listed, "wheel", f"<{kind}>", "tyre")
    assert [text for _, text in places("GAZ067", robot)] == ["tyre"]
    assert f'<{kind} name="wheel_tyre">' in fixed("GAZ067", robot)


@pytest.mark.parametrize(
    ("kind", "name", "tags"),
    [
        ("collision", "", MU),
        ("collision", "wheel_tyre", MU),
        ("visual", "tyre", MU),
        ("collision", "tyre", "<material>Gazebo/Red</material>"),
        ("collision", "tyre", "<selfCollide>true</selfCollide>"),
    ],
)
def test_others_are_not_reported_68(kind: str, name: str, tags: str) -> None:
    assert messages("GAZ067", BASE + wheel(kind, name) + block(tags, "wheel")) == []


def test_a_merged_link_whose_name_begins_with_that_of_its_parent() -> None:
    robot = BASE + wheel("collision", "", "fixed", "base_wheel") + block(MU, "base_wheel")
    (message,) = messages("GAZ067", robot)
    assert message.startswith("Gazebo does not apply <mu1> of link 'base_wheel': ")


@pytest.mark.parametrize(("name", "count"), [("", 0), ("wheel", 0), ("wheel_tyre", 1), ("a", 1)])
def test_a_merged_link(name: str, count: int) -> None:
    robot = BASE + wheel("collision", name, "fixed") + block(MU, "wheel")
    assert len(messages("GAZ067", robot)) == count


OLD = block("<disableFixedJointLumping>true</disableFixedJointLumping>", "tip_joint")
TIP = child("tip", "fixed")


def test_the_older_tag_makes_a_joint_that_turns() -> None:
    assert messages("GAZ067", BASE + TIP + OLD) == [
        "<disableFixedJointLumping> makes joint 'tip_joint' a revolute joint in Gazebo"
    ]
    assert "<preserveFixedJoint>true</preserveFixedJoint>" in fixed("GAZ067", BASE + TIP + OLD)


@pytest.mark.parametrize(
    ("robot", "tags"),
    [
        (TIP, OLD.replace("true", "false")),
        (TIP, OLD + block("<preserveFixedJoint>true</preserveFixedJoint>", "tip_joint")),
        (child("tip"), OLD),
    ],
)
def test_others_are_not_reported_69(robot: str, tags: str) -> None:
    assert messages("GAZ067", BASE + robot + tags) == []


# --- force-torque sensors


def unmeasured(kind: str, *, reference: str, beside: str = "") -> list[Diagnostic]:
    found = findings("GAZ067", kind, reference=reference, beside=beside)
    return [one for one in found if "nothing is measured" in one.message]


KEPT = "<{0}>true</{0}>"


def test_a_merged_joint_has_no_sensor() -> None:
    (finding,) = unmeasured("force_torque", reference="wrist")
    assert finding.message == naming("s", "fixed", "wrist", "Gazebo", "nothing")


@pytest.mark.parametrize("tag", ["preserveFixedJoint", "disableFixedJointLumping"])
def test_a_joint_that_is_kept_has_one(tag: str) -> None:
    assert unmeasured("force_torque", reference="wrist", beside=KEPT.format(tag)) == []


def test_a_joint_that_is_kept_below_a_link_of_another_package() -> None:
    """JRL-CARI-CNR-UNIBS/elastoplastic_test: its parent is in a package that is not found."""
    absent = '<xacro:include filename="$(find absent)/a.xacro"/>'
    joint = '<joint name="j" type="fixed"><parent link="ft"/><child link="base"/></joint>'
    sensor = '<sensor name="s" type="force_torque"><topic>t</topic></sensor>'
    kept = block(KEPT.format("preserveFixedJoint") + sensor, "j")
    assert len(in_xacro("XAC011", absent + BASE + joint + kept)) == 1
    assert in_xacro("GAZ067", absent + BASE + joint + kept) == []
    assert len(in_xacro("GAZ067", absent + BASE + joint + block(sensor, "j"))) == 1


@pytest.mark.parametrize(("text", "count"), [("true", 1), ("yes", 1), ("false", 0)])
def test_feedback_of_a_merged_joint(text: str, count: int) -> None:
    feedback = f"<provideFeedback>{text}</provideFeedback>"
    found = unmeasured("imu", reference="wrist", beside=feedback)
    assert [finding.span.text for finding in found] == ["<provideFeedback>"] * count


def test_one_joint_is_reported_once() -> None:
    feedback = "<provideFeedback>true</provideFeedback>"
    assert len(unmeasured("force_torque", reference="wrist", beside=feedback)) == 1


def test_the_old_form_keeps_a_joint() -> None:
    keep = '<preserveFixedJoint value="true"/>'
    assert unmeasured("force_torque", reference="wrist", beside=keep) == []


def test_other_sensors_need_no_joint() -> None:
    assert unmeasured("imu", reference="wrist") == []
