from pathlib import Path

import pytest

from tests.conftest import MODELS
from tests.massive import MESH, inertial, joint, link, shape
from tests.naming import naming
from tests.reported import messages, reported
from urdfkit.core.installation import install_command
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.source import Source

BALL = shape("collision", '<sphere radius="0.05"/>')


def on_wheels(center: str, casters: str = "-0.15 0 0", more: str = "") -> str:
    text = link("base", inertial(3, (1, 1, 1), xyz=center), more)
    for name, y in (("left", 0.1), ("right", -0.1)):
        text += link(name, BALL) + joint("base", name, "continuous", f"0 {y} 0")
    return text + link("caster", BALL) + joint("base", "caster", xyz=casters)


def test_it_falls_forwards() -> None:
    (found,) = reported("DYN004", on_wheels("0.02 0 0.1"))
    assert found.message == naming("forwards", "0.02 m", "outside", "left", "right", "caster")
    assert len(found.related) == 3


@pytest.mark.parametrize("center", ["-0.01 0 0.1", "0 0 0.1", "0.0005 0 0.1"])
def test_it_stands(center: str) -> None:
    assert messages("DYN004", on_wheels(center)) == []


def test_what_thrusters_carry_stands_on_nothing() -> None:
    thrusters = "".join(
        link(f"thruster_{n}") + joint("base", f"thruster_{n}", "fixed", "0 0 1") for n in (1, 2)
    )
    assert messages("DYN004", on_wheels("0.02 0 0.1") + thrusters) == []


def test_two_wheels_balance() -> None:
    assert messages("DYN004", on_wheels("0.5 0 0", casters="-0.15 0 0.1")) == []


def test_legs_do_not_stand_at_zero() -> None:
    """A body on two pairs of legs of three joints each, far behind its centre of mass."""
    text = link("base", inertial(3, (1, 1, 1), xyz="1 0 0"))
    for name, y in (("left", 0.1), ("right", -0.1), ("back", 0.0)):
        for part, above, at in (("hip", "base", f"-0.1 {y} 0"), ("knee", "hip", "0 0 -0.2")):
            parent = above if above == "base" else f"{name}_{above}"
            text += link(f"{name}_{part}") + joint(parent, f"{name}_{part}", "revolute", at)
        foot = f"{name}_foot"
        text += link(foot, BALL) + joint(f"{name}_knee", foot, "revolute", "0 0 -0.2")
    text = text.replace('"-0.1 0.0 0"', '"-0.4 0.0 0"')
    assert messages("DYN004", text) == []
    wheels = text.replace('type="revolute"', 'type="continuous"')
    assert len(messages("DYN004", wheels)) == 1


def test_what_stands_on_its_base_is_bolted_down() -> None:
    box = shape("collision", '<box size="0.2 0.2 0.1"/>')
    arm = link("base", box, inertial(1, (1, 1, 1))) + link(
        "arm", inertial(5, (1, 1, 1), xyz="1 0 0")
    )
    fingers = link("f") + joint("arm", "f", "revolute") + link("g") + joint("arm", "g", "revolute")
    assert messages("DYN004", arm + joint("base", "arm", "revolute") + fingers) == []


def test_what_is_fixed_to_the_world_does_not_fall() -> None:
    text = link("world") + joint("world", "base") + on_wheels("0.5 0 0")
    assert messages("DYN004", text) == []


def test_a_mesh_that_is_not_there_may_reach_as_low() -> None:
    assert messages("DYN004", on_wheels("0.5 0 0", more=shape("collision", MESH))) == []


@pytest.mark.parametrize(("z", "found"), [("0.5", 1), ("-0.18", 0)])
def test_a_mesh_on_the_ground_or_above_it(z: str, found: int, tmp_path: Path) -> None:
    """The forearm of our arm, 0.25 m long, lies along x from 0 to the centre of mass."""
    pytest.importorskip("numpy")
    arm = MODELS / "good" / "two_link_arm" / "meshes" / "forearm.stl"
    (tmp_path / "forearm.stl").write_bytes(arm.read_bytes())
    mesh = shape("collision", '<mesh filename="forearm.stl"/>', xyz=f"0.05 0 {z}")
    robot = on_wheels("0.06 0 0", more=mesh)
    assert len(messages("DYN004", robot, str(tmp_path / "robot.urdf"))) == found


def test_without_the_readers_of_meshes_it_is_skipped_where_it_matters(
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    def lean(*_: object) -> None:
        raise ImportError("numpy")

    monkeypatch.setattr("urdfkit.robot.assets.triangles.Meshes.mesh", lean)
    mesh = tmp_path / "part.stl"
    mesh.write_bytes(b"what is in it is not read")
    part = shape("collision", f'<mesh filename="{mesh}"/>')
    sources = [
        Source("r.urdf", whole_robot(on_wheels(at, more=part)).encode())
        for at in ("-0.05 0 0", "0.5 0 0")
    ]
    reports = [engine.check(source, select=["DYN004"]) for source in sources]
    assert [len(report.skipped) for report in reports] == [0, 1]
    assert install_command("meshes") in reports[1].skipped[0].reason


def test_models_of_our_own_stand() -> None:
    for model in ("good/mobile_base/urdf/mobile_base.urdf.xacro",):
        assert engine.check(MODELS / model, select=["DYN004"]).diagnostics == ()
