"""RCT024: see the rule."""

import pytest

from tests.controls import ROBOT, transmission
from tests.reported import fixed, messages, reported

SOUND = ROBOT + transmission("swing")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "SimpleTransmission",
            "SimpelTransmission",
            (
                "transmission 't': type 'transmission_interface/SimpelTransmission' is nearly "
                "'transmission_interface/SimpleTransmission'"
            ),
        ),
        (">1<", ">0<", "transmission 't': mechanicalReduction is 0, not a number other than 0"),
        (
            ">1<",
            ">1:50<",
            "transmission 't': mechanicalReduction is 1:50, not a number other than 0",
        ),
        (
            "mechanicalReduction",
            "mechanicalReducton",
            (
                "transmission 't': unknown element <mechanicalReducton>; did you mean "
                "'mechanicalReduction'?"
            ),
        ),
    ],
)
def test_what_is_refused(old: str, new: str, message: str) -> None:
    assert messages("RCT024", SOUND.replace(old, new)) == [message]


def test_slips_are_mended() -> None:
    assert fixed("RCT024", SOUND.replace("SimpleT", "SimpelT")) == fixed("RCT024", SOUND)


@pytest.mark.parametrize(
    ("old", "new"), [(">1<", ">-50.5<"), ("Simple", "HalfDifferential"), ("Simple", "acme/Worm")]
)
def test_what_is_read_or_of_others(old: str, new: str) -> None:
    assert messages("RCT024", SOUND.replace(old, new)) == []


def test_ros2_passes_over_it_whatever_it_says() -> None:
    assert reported("RCT024", SOUND.replace(">1<", ">0<"), targets=("ros2",)) == []


def test_a_type_without_its_package() -> None:
    text = SOUND.replace("transmission_interface/Simple", "Simple")
    assert messages("RCT024", text) == [
        "transmission 't': type 'SimpleTransmission' lacks its package"
    ]
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
