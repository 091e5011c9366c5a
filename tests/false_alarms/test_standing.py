"""A robot stands on what collides; a visual holds nothing, and all commands say the same."""

import json
from pathlib import Path

import pytest

from tests.conftest import ARM
from tests.massive import inertial, joint, link, shape
from tests.naming import naming
from tests.output.test_overview import of
from tests.reported import messages, reported
from urdfkit.cli import main
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.output.report.document import describe
from urdfkit.robot.stability import standing_verdict
from urdfkit.text.diagnostic import Severity

BALL = '<sphere radius="0.05"/>'
BOTH = shape("visual", BALL) + shape("collision", BALL)


def on_wheels(caster: str = shape("visual", BALL), wheel: str = BOTH, base: str = "") -> str:
    """Two wheels and a caster behind them, with the centre of mass between."""
    text = link("base", inertial(3, (1, 1, 1), xyz="-0.05 0 0.1"), base)
    for name, y in (("left", 0.1), ("right", -0.1)):
        text += link(name, wheel) + joint("base", name, "continuous", f"0 {y} 0")
    return text + link("caster", caster) + joint("base", "caster", xyz="-0.15 0 0")


def test_a_caster_without_collision_holds_nothing() -> None:
    robot = of(on_wheels())
    found = standing_verdict(robot)
    assert (found.verdict, found.links, found.visual_only) == (
        "no-area",
        ("left", "right"),
        ("caster",),
    )
    counted = standing_verdict(robot, visuals=True)
    assert (counted.verdict, counted.visual_only) == ("stands", ("caster",))
    assert standing_verdict(of(on_wheels(BOTH))).verdict == "stands"


def test_a_caster_without_collision_is_a_warning() -> None:
    (found,) = reported("GEO002", on_wheels())
    assert found.severity is Severity.WARNING
    assert found.message == naming("caster", "visual", "collision", "without")


def test_so_are_the_wheels_under_a_base_with_collision() -> None:
    box = '<box size="0.3 0.2 0.02"/>'
    base = shape("visual", box) + shape("collision", box)
    found = reported("GEO002", on_wheels(BOTH, wheel=shape("visual", BALL), base=base))
    assert [one.severity for one in found] == [Severity.WARNING] * 2


@pytest.mark.parametrize(
    "text",
    [
        on_wheels(BOTH, base=shape("visual", BALL)),  # which is not needed
        on_wheels().replace('"continuous"', '"fixed"'),  # bolted down
        link("world") + joint("world", "base") + on_wheels(),
    ],
)
def test_what_holds_nothing_up_is_an_info(text: str) -> None:
    (found,) = reported("GEO002", text)
    assert found.severity is Severity.INFO


def test_nothing_is_said_of_a_robot_that_stands_on_visuals_alone() -> None:
    """DYN004 let it fall off shapes that touch nothing."""
    assert messages("DYN004", on_wheels(wheel=shape("visual", BALL)).replace("-0.05", "0.5")) == []


@pytest.mark.parametrize(("lift", "falls"), [("0.004", False), ("0.03", True)])
def test_wheels_that_differ_by_millimetres_tilt_the_robot_a_little(lift: str, falls: bool) -> None:
    """AWS's DeepRacer: the rear wheels are 4 mm higher, and it rests on them 1.4 degrees lower."""
    broad = shape("collision", '<box size="0.04 0.04 0.1"/>')
    robot = on_wheels(BOTH, wheel=broad).replace('"-0.15 0 0"', f'"-0.15 0 {lift}"')
    assert len(messages("DYN004", robot)) == falls


@pytest.mark.parametrize(
    "verdict", ["fixed", "no-area", "tips-unless-bolted", "stands", "no-mass", "unknown", "carried"]
)
def test_the_report_and_the_command_say_the_same(
    verdict: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("pinocchio")
    tray = shape("collision", '<box size="0.2 0.2 0.1"/>')
    text = {
        "fixed": link("world") + joint("world", "base") + on_wheels(),
        "no-area": on_wheels(),
        "tips-unless-bolted": link("base", tray, inertial(1, (1, 1, 1), xyz="1 0 0")),
        "stands": on_wheels(BOTH),
        "no-mass": link("base", tray),
        "unknown": link("base", shape("collision", '<mesh filename="missing.stl"/>')),
        # the WAM-V of VRX, whose propellers are below its hull
        "carried": link("base", inertial(1, (1, 1, 1)))
        + "".join(
            link(f"{side}_blade", tray, inertial(0.1, (1e-3, 1e-3, 1e-3)))
            + joint("base", f"{side}_blade", "continuous", f"-1 {y} -0.5").replace(
                'name="', 'name="propeller_', 1
            )
            for side, y in (("left", 0.3), ("right", -0.3))
        ),
    }[verdict]
    path = tmp_path / "robot.urdf"
    path.write_text(whole_robot(text), encoding="utf-8")
    assert main(["statics", "--format", "json", str(path)]) == 0
    stability = json.loads(capsys.readouterr().out)["stability"]
    page = json.loads(json.dumps(describe(str(path))[0]["standing"]))
    assert page == stability
    assert page["verdict"] == verdict


def test_an_arm_on_the_world_is_fixed_in_its_report(tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_text(ARM.read_text(encoding="utf-8").replace('"mount"', '"world"'))
    assert describe(str(path))[0]["standing"]["verdict"] == "fixed"


@pytest.mark.parametrize(
    ("name", "severity"), [("base_footprint", Severity.INFO), ("skid", Severity.WARNING)]
)
def test_a_mark_on_the_ground_holds_nothing(name: str, severity: Severity) -> None:
    """diffbot-ros2: a small box shows where base_footprint is; what lacks is a caster."""
    text = on_wheels(shape("visual", '<box size="0.01 0.01 0.1"/>')).replace("caster", name)
    (found,) = reported("GEO002", text)
    assert found.severity is severity


@pytest.mark.parametrize(
    ("plugin", "severity"),
    [("planar_move", Severity.INFO), ("diff_drive", Severity.WARNING)],
)
def test_wheels_of_a_robot_that_slides_are_for_the_eye(plugin: str, severity: Severity) -> None:
    """A target whose box lies on the ground; gazebo_ros_planar_move moves the model."""
    box = '<box size="0.3 0.2 0.08"/>'
    base = shape("visual", box) + shape("collision", box)
    wheels = on_wheels(BOTH, wheel=shape("visual", BALL), base=base)
    text = f'<gazebo><plugin name="p" filename="libgazebo_ros_{plugin}.so"/></gazebo>'
    assert {one.severity for one in reported("GEO002", wheels + text)} == {severity}
