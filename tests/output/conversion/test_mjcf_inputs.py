"""Options and actuators of MuJoCo that stand in the URDF."""

from pathlib import Path

import pytest

from urdfkit import convert, read
from urdfkit.errors import UrdfkitError

mujoco = pytest.importorskip("mujoco")
from tests.output.conversion.test_mjcf import INERTIAL, LIMIT, arm, loaded
from urdfkit.output.conversion import mjcf_inputs


def test_options_of_mujoco_in_the_urdf(tmp_path: Path) -> None:
    """Gravity does not point along the axis of the joint, and flags change what is computed."""
    block = (
        '<mujoco><compiler balanceinertia="true" autolimits="true"/>'
        '<option timestep="0.004" gravity="0 -3 1"><flag contact="disable" gravity="disable"/>'
        '</option><size memory="10M" nuserdata="3"/></mujoco><mujoco_inputs><raw_inputs>'
        '<option integrator="implicitfast"/><sensor/></raw_inputs></mujoco_inputs>'
    )
    outwards = INERTIAL.replace("<inertial>", '<inertial><origin xyz="0.3 0 0"/>')
    model, parts = loaded(
        arm('<axis xyz="0 1 0"/>' + LIMIT, tip=outwards, more=block), tmp_path / "o"
    )
    assert model.opt.gravity.tolist() == [0, -3, 1]
    assert (model.opt.timestep, model.narena) == (0.004, 10 * 2**20)
    assert model.opt.integrator == mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    assert model.opt.disableflags == (
        mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_GRAVITY
    )
    masses = "lost: the conversion writes the masses of the robot"
    assert parts["mujoco/compiler@balanceinertia"] == masses
    assert parts["mujoco/compiler@autolimits"] == "lost: urdfkit does not convert it"
    assert parts["mujoco/option@gravity"] == "kept: option"
    assert parts["mujoco/size@nuserdata"] == "lost: urdfkit does not convert it"
    assert parts["mujoco_inputs/raw_inputs/option"] == "kept: option"
    merged = "lost: mujoco_ros2_control merges it into the MJCF; urdfkit does not"
    assert parts["mujoco_inputs/raw_inputs/sensor"] == merged


def inputs(actuators: str) -> str:
    return (
        f"<mujoco_inputs><raw_inputs><actuator>{actuators}</actuator></raw_inputs></mujoco_inputs>"
    )


def test_actuators_of_mujoco_in_the_urdf(tmp_path: Path) -> None:
    """They are those that MuJoCo itself reads from the same text, and replace our own."""
    text = (
        '<position joint="turn" kp="30" dampratio="1" ctrlrange="-1 1" forcerange="-5 5"/>'
        '<velocity joint="turn" kv="2"/><general tendon="t"/>'
    )
    model, parts = loaded(arm(LIMIT, more=inputs(text)), tmp_path / "o")
    expected = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><body><joint name="turn"/><geom size="1"/></body></worldbody>'
        f"<actuator>{text.partition('<general')[0]}</actuator></mujoco>"
    )
    assert [model.actuator(number).name for number in range(model.nu)] == ["turn", "turn_velocity"]
    for field in "gainprm gaintype biastype ctrlrange forcerange ctrllimited gear".split():
        ours, theirs = (getattr(one, f"actuator_{field}") for one in (model, expected))
        assert ours.tolist() == theirs.tolist()
    assert model.actuator("turn").biasprm[1] == -30
    block = "mujoco_inputs/raw_inputs/actuator"
    assert parts[f"{block}/position@kp"] == "kept: position"
    assert parts[f"{block}/general"].startswith("lost: only actuators of joints")


def test_all_fields_of_an_actuator_are_copied() -> None:
    """But what belongs to its specification, and what actuators of joints do not use."""
    own = "classname compiler id info name plugin signature target trntype type userdata".split()
    of_sites = ["refsite", "slidersite"]
    actuator = mujoco.MjSpec().add_actuator()
    fields = {name for name in dir(actuator) if not name.startswith("_")}
    values = {name for name in fields if not callable(getattr(actuator, name))}
    assert values - {*own, *of_sites} == set(mjcf_inputs._ACTUATOR_FIELDS)


@pytest.mark.parametrize(
    ("actuator", "message"),
    [
        ('<position joint="trun"/>', "<position> is for an unknown joint 'trun'; correct it"),
        ('<position joint="turn" kpp="1"/>', "unrecognized attribute: 'kpp'; correct it"),
        ('<servo joint="turn"/>', "MuJoCo rejects <servo>"),
    ],
)
def test_a_wrong_actuator_of_mujoco_is_an_error(
    actuator: str, message: str, tmp_path: Path
) -> None:
    with pytest.raises(UrdfkitError, match=message):
        convert(read(arm(LIMIT, more=inputs(actuator))), tmp_path / "o")


def test_an_option_that_mujoco_rejects_is_an_error(tmp_path: Path) -> None:
    block = '<mujoco><option step="1"/></mujoco>'
    with pytest.raises(UrdfkitError, match="unrecognized attribute: 'step'; correct it"):
        convert(read(arm(LIMIT, more=block)), tmp_path / "o")
