"""RCT024: see the rule."""

import pytest

from tests.controls import NEXT, ROBOT, control, driven, plugin, transmission
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit.text.diagnostic import Severity

SOUND = ROBOT + transmission("swing")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "SimpleTransmission",
            "SimpelTransmission",
            naming(
                "t",
                "transmission_interface/SimpelTransmission",
                "unknown",
                "transmission_interface/SimpleTransmission",
            ),
        ),
        (">1<", ">0<", naming("t", "mechanicalReduction", "0", "number", "0")),
        (
            ">1<",
            ">1:50<",
            naming("t", "mechanicalReduction", "1", ":50", "number", "0"),
        ),
        (
            "mechanicalReduction",
            "mechanicalReducton",
            naming("t", "unknown", "<mechanicalReducton>", "mechanicalReduction"),
        ),
    ],
)
def test_an_invalid_type_or_ratio(old: str, new: str, message: str) -> None:
    assert messages("RCT024", SOUND.replace(old, new)) == [message]


def test_a_misspelt_joint_is_not_missing_as_well() -> None:
    misspelt = transmission("swing").replace("<joint", "<jont").replace("</joint", "</jont")
    assert messages("RCT024", ROBOT + misspelt) == [naming("t", "unknown", "<jont>", "joint")]


def test_typos_are_fixed() -> None:
    assert fixed("RCT024", SOUND.replace("SimpleT", "SimpelT")) == fixed("RCT024", SOUND)


@pytest.mark.parametrize(
    ("old", "new"), [(">1<", ">-50.5<"), ("Simple", "HalfDifferential"), ("Simple", "acme/Worm")]
)
def test_valid_elements(old: str, new: str) -> None:
    assert messages("RCT024", SOUND.replace(old, new)) == []


def test_a_type_without_its_package() -> None:
    text = SOUND.replace("transmission_interface/Simple", "Simple")
    assert messages("RCT024", text) == [naming("t", "SimpleTransmission")]
    assert fixed("RCT024", text) == fixed("RCT024", SOUND)


@pytest.mark.parametrize(
    ("kind", "joints", "actuators", "wrong"),
    [
        ("Simple", 2, 1, "<joint>"),
        ("Simple", 1, 2, "<actuator>"),
        ("Differential", 2, 1, "<actuator>"),
        ("FourBarLinkage", 1, 2, "<joint>"),
        ("Differential", 2, 2, ""),
        ("HalfDifferential", 3, 1, ""),
    ],
)
def test_each_type_has_its_number_of_joints(
    kind: str, joints: int, actuators: int, wrong: str
) -> None:
    how = "<hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>"
    parts = [f'<joint name="{name}">{how}</joint>' for name in ("swing", "slide", "follow")]
    ratio = "<mechanicalReduction>1</mechanicalReduction>"
    motors = [f'<actuator name="m{number}">{ratio}</actuator>' for number in range(actuators)]
    text = (
        f'<transmission name="t"><type>transmission_interface/{kind}Transmission</type>'
        f"{''.join(parts[:joints])}{''.join(motors)}</transmission>"
    )
    found = messages("RCT024", ROBOT + text)
    assert [wrong in message for message in found] == ([True] if wrong else [])


EMPTY = ROBOT + transmission("swing", " ")
PR2 = '<transmission name="t" type="pr2_mechanism_model/SimpleTransmission">{}</transmission>'


def test_a_joint_without_interface() -> None:
    assert messages("RCT024", EMPTY) == [naming("t", "swing", "<hardwareInterface>")]
    assert places("RCT024", EMPTY) == [(NEXT + 1, '<joint name="swing">')]


def test_interface_in_the_actuator_is_ignored() -> None:
    old = "<hardwareInterface>EffortJointInterface</hardwareInterface></actuator>"
    assert messages("RCT024", EMPTY.replace("</actuator>", old)) == [
        naming("t", "swing", "<hardwareInterface>", "<actuator>", "ignored")
    ]


TWO = ROBOT + transmission("swing") + transmission("slide").replace('"t"', '"u"')


def test_one_finding_for_all() -> None:
    text = TWO + control(driven("swing"))
    assert messages("RCT024", text) == [naming("t", "1", "ROS 2")]
    assert places("RCT024", text) == [(NEXT, '<transmission name="t">')]
    (found,) = reported("RCT024", text)
    assert found.severity is Severity.INFO
    assert [one.message for one in found.related] == ["transmission 'u'"]


def test_readers_of_transmissions() -> None:
    assert reported("RCT024", TWO) == [], "nothing says that it is for ROS 2"
    assert reported("RCT024", TWO + plugin("libgazebo_ros_control.so")) == []
    assert reported("RCT024", TWO, targets=("ros1", "ros2")) == []
    (found,) = reported("RCT024", TWO.replace(">1<", ">0<"), targets=("gz-jetty",))
    assert found.severity is Severity.INFO
    inner = '<transmission name="t"><plugin>p/C</plugin></transmission>'
    assert reported("RCT024", ROBOT + control(driven("swing"), inner)) == []


TYPE = "<type>transmission_interface/SimpleTransmission</type>"
ACTUATOR = '<actuator name="m"><mechanicalReduction>1</mechanicalReduction></actuator>'


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (TYPE, "", ["t", "<type>"]),
        (TYPE, "<type/>", ["t", "<type>"]),
        (
            f'name="t">{TYPE}',
            'name="t" type="SimpleTransmission">',
            ["t", "<type>", "ignored"],
        ),
        ('name="t"', "", ["no name"]),
        (ACTUATOR, "", ["t", "<actuator>"]),
        ('<actuator name="m">', "<actuator>", ["t", "no name", "<actuator>"]),
        (
            TYPE,
            "</transmission><transmission>",
            ["t", "<type>", "<joint>", "<actuator>"],
        ),
    ],
)
def test_missing_parts(old: str, new: str, message: list[str]) -> None:
    found = messages("RCT024", SOUND.replace(old, new))
    assert found[0] == naming(*message)
    assert places("RCT024", SOUND.replace(old, new))[0][0] == NEXT


def test_complete_transmissions_and_those_of_the_pr2() -> None:
    assert reported("RCT024", SOUND) == []
    assert reported("RCT024", ROBOT + PR2.format('<joint name="swing"/>')) == []


@pytest.mark.parametrize(
    ("targets", "severity"),
    [((), Severity.WARNING), (("ros1",), Severity.ERROR), (("drake",), Severity.WARNING)],
)
def test_severity_by_target(targets: tuple[str, ...], severity: Severity) -> None:
    (finding, *_) = reported("RCT024", SOUND.replace(TYPE, ""), targets=targets)
    assert finding.severity is severity


@pytest.mark.parametrize(
    ("old", "new", "is_read"),
    [
        ("transmission_interface/Simple", "Simple", False),
        ("Simple", "Simpel", False),
        (">1<", ">1:50<", False),
        ("mechanicalReduction", "mechanicalReducton", False),
        ("</actuator>", '</actuator><actuator name="n"/>', False),
        ("hardwareInterface", "hardwareInterfac", True),
        ("<actuator", '<joint name="slide"/><actuator', True),
    ],
)
def test_unread_by_gazebo_is_a_warning(old: str, new: str, is_read: bool) -> None:
    """DefaultRobotHWSim reads the joint and its first interface, whatever the type."""
    targets = ("ros1", "classic-ros1")
    found = reported("RCT024", SOUND.replace(old, new), targets=targets)
    severity = Severity.ERROR if is_read else Severity.WARNING
    assert {one.severity for one in found} == {severity}
    hardware = reported("RCT024", SOUND.replace(old, new), targets=("ros1",))
    assert {one.severity for one in hardware} == {Severity.ERROR}


FIRST = transmission("swing")


def test_copied_transmission_of_the_same_joint() -> None:
    text = ROBOT + FIRST + transmission("swing").replace('name="t"', 'name="u"')
    assert messages("RCT024", text) == [naming("swing", "already")]
    assert places("RCT024", text) == [(NEXT + 3, "swing")]
    (found,) = reported("RCT024", text)
    assert [note.span.line for note in found.related] == [NEXT + 1]


def test_duplicate_name() -> None:
    text = ROBOT + FIRST + transmission("slide")
    assert messages("RCT024", text) == [naming("duplicate", "t")]


def test_joint_with_two_interfaces() -> None:
    other = transmission("swing", "hardware_interface/PositionJointInterface")
    assert reported("RCT024", ROBOT + FIRST + other.replace('name="t"', 'name="u"')) == []


@pytest.mark.parametrize(
    ("simulation", "joint", "count"),
    [
        ("franka_gazebo/FrankaHWSim", "swing", 0),
        ("franka_gazebo/FrankaHWSim", "slide", 1),
        ("gazebo_ros_control/DefaultRobotHWSim", "swing", 1),
    ],
)
def test_one_name_for_the_interfaces_of_a_joint(simulation: str, joint: str, count: int) -> None:
    """Franka's hardware simulation reads them all."""
    other = transmission(joint, "hardware_interface/PositionJointInterface")
    gazebo = plugin("libgazebo_ros_control.so", f"<robotSimType>{simulation}</robotSimType>")
    assert len(messages("RCT024", ROBOT + FIRST + other + gazebo)) == count


@pytest.mark.parametrize(("targets", "count"), [(("drake",), 0), (("drake", "ros1"), 1)])
def test_what_drake_reads(targets: tuple[str, ...], count: int) -> None:
    """Drake's PR2 has the type as an attribute, and no interfaces."""
    text = '<transmission name="t" type="SimpleTransmission"><actuator name="m"/>'
    text += '<joint name="swing"/></transmission>'
    assert len(reported("RCT024", ROBOT + text, targets=targets)) == count
    missing = text.replace(' type="SimpleTransmission"', "")
    assert len(reported("RCT024", ROBOT + missing, targets=targets)) == 1


@pytest.mark.parametrize("targets", [("genesis",), ("ros2", "genesis"), ("ros1", "genesis")])
def test_what_genesis_rejects(targets: tuple[str, ...]) -> None:
    """Its reader needs the text of `<type>`, even of a PR2, a joint and an actuator."""
    of_pr2 = '<transmission name="t" type="pr2_mechanism_model/SimpleTransmission">'
    of_pr2 += '<actuator name="m"/><joint name="swing"/></transmission>'
    (found, *_) = reported("RCT024", ROBOT + of_pr2, targets=targets)
    assert found.severity is Severity.ERROR
    assert "no <type>" in found.message


def test_genesis_reads_no_interfaces() -> None:
    whole = '<transmission name="t"><type>any</type><joint name="swing"/><actuator name="m"/>'
    assert not reported("RCT024", ROBOT + whole + "</transmission>", targets=("genesis",))
