"""COL001: see the rule."""

import sys
from pathlib import Path

import pytest

from tests.naming import naming
from tests.physics.collision.robots import box, cube, cylinder, joint, link, mesh, revolute, sphere
from tests.reported import messages, places, reported
from urdfkit.core.installation import install_command
from urdfkit.lint import engine
from urdfkit.lint.config import Config
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source


def severities(text: str) -> list[str]:
    return [found.severity.value for found in reported("COL001", text)]


SWING = revolute(-2, 2, "0 1 0")


def bent(depth: float, limits: str = SWING, between: str = box(0.05, 0.05, 0.4)) -> str:
    """A ball on an arm that reaches so deep into the base where it hangs down."""
    return "\n".join(
        (
            link("base", box(0.2, 0.2, 0.2)),
            link("upper", f"{between}@0 0 0.35"),
            link("tool", f"{sphere(0.05)}@0 0 {-0.35 - depth}"),
            joint("base", "upper", "revolute", "0 0 0.1", revolute(-1, 1, "0 1 0")),
            joint("upper", "tool", "revolute", "0 0 0.4", limits),
        )
    )


@pytest.fixture(autouse=True)
def _needs_coal(request: pytest.FixtureRequest) -> None:
    if "without" not in request.node.name:
        pytest.importorskip("coal")


@pytest.mark.parametrize("kind", ["floating", "planar"])
def test_what_no_joint_binds_is_nowhere(kind: str) -> None:
    """Neither the trees of two roots nor what floats stands at the origin of the other."""
    arm = bent(0.004)
    assert messages("COL001", arm)
    assert not messages("COL001", arm.replace("revolute", kind, 1))
    assert not messages("COL001", arm.partition("<joint")[0])


@pytest.mark.parametrize(("depth", "count"), [(0.0009, 0), (0.0011, 1)])
def test_a_millimetre_is_deep(depth: float, count: int) -> None:
    assert len(messages("COL001", bent(depth))) == count


def test_the_depth_and_the_smaller_body() -> None:
    text = bent(0.004)
    assert messages("COL001", text) == [naming("tool", "base", "4 mm", "zero")]
    assert severities(text) == ["warning"]
    ((line, what),) = places("COL001", text)
    assert (line, what) == (4, "<collision>")


@pytest.mark.parametrize("depth", [-0.1, 0, 0.0005])
def test_less_than_a_millimetre_is_no_matter(depth: float) -> None:
    assert messages("COL001", bent(depth)) == []


def test_the_configured_depth() -> None:
    robot = Source("r.urdf", whole_robot(bent(0.004)).encode())
    for depth, count in [(0.0039, 1), (0.0041, 0)]:
        config = Config(options={"COL001": {"depth": depth}})
        assert len(engine.check(robot, select=["COL001"], config=config).diagnostics) == count


def test_a_joint_that_begins_elsewhere() -> None:
    assert messages("COL001", bent(0.02, revolute(1, 2, "0 1 0"))) == []


def test_links_that_collide_in_every_pose_are_an_info() -> None:
    stiff = bent(0.02).replace('lower="-2" upper="2"', 'lower="0" upper="0"')
    assert severities(stiff) == ["info"]


def test_rigidly_connected_links_are_not_reported() -> None:
    arm = link("base", box(0.2, 0.2, 0.2)) + link("arm", box(0.2, 0.2, 0.2))
    assert severities(arm + joint("base", "arm", "continuous")) == ["info"]
    sensor = link("mid", box(0.1, 0.1, 0.1)) + link("eye", box(0.1, 0.1, 0.1))
    fixed = joint("base", "arm", origin="9 0 0") + joint("arm", "mid") + joint("mid", "eye")
    assert messages("COL001", arm + sensor + fixed) == []


def test_without_coal_closed_forms_are_checked_and_the_rest_is_skipped(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "coal", None)
    closed, open_ = (
        bent(0.02),
        bent(0.02).replace('<sphere radius="0.05"/>', '<capsule radius="0.05" length="0.01"/>'),
    )
    for text, codes, skipped in ((closed, ["COL001"], []), (open_, [], ["COL001"])):
        source = Source("r.urdf", whole_robot(text).encode())
        report = engine.check(source, select=["COL001"])
        assert [one.code for one in report.diagnostics] == codes
        assert [one.code for one in report.skipped] == skipped
        assert all(install_command("dynamics") in one.reason for one in report.skipped)


def test_the_arm_of_moveit_folds_into_itself_only_at_the_end_of_its_range(corpus: Path) -> None:
    panda = corpus / "moveit_resources" / "panda_description" / "urdf" / "panda.urdf"
    found = engine.check(panda, select=["COL001"]).diagnostics
    assert [one for one in found if one.severity is Severity.WARNING] == []


@pytest.mark.parametrize(("lower", "count"), [(-0.4, 1), (-0.05, 0), (0, 1)])
def test_zero_next_to_the_end_of_a_joint_between(lower: float, count: int) -> None:
    elbow = bent(0.004)
    assert elbow.count('lower="-2"') == 1
    assert len(messages("COL001", elbow.replace('lower="-2"', f'lower="{lower}"'))) == count


@pytest.mark.parametrize(("limits", "count"), [(revolute(1, 2), 0), (revolute(-1, 2), 1)])
def test_a_joint_above_both_that_cannot_be_at_zero(limits: str, count: int) -> None:
    below = bent(0.004) + link("stand") + joint("stand", "base", "revolute", more=limits)
    assert len(messages("COL001", below)) == count


NECK = '<axis xyz="0 0 1"/>'


def body(head: str, more: str = NECK, kind: str = "continuous") -> str:
    """A leg that begins 0.12 m from the axis of the head and ends 0.15 m above its middle."""
    return "\n".join(
        (
            link("body", cylinder(0.2, 0.6)),
            link("leg", box(0.1, 0.2, 0.6)),
            link("head", head),
            joint("body", "leg", origin="0 0.22 0.15"),
            joint("body", "head", kind, "0 0 0.3", more),
        )
    )


def test_a_ball_that_turns_in_place_overlaps_in_every_pose() -> None:
    (message,) = (one for one in messages("COL001", body(sphere(0.2))) if "'leg'" in one)
    assert message == naming("head", "leg", "80 mm", "zero")
    assert float(message.split()[9]) == pytest.approx(80, abs=0.1)
    assert set(severities(body(sphere(0.2)))) == {"info"}


@pytest.mark.parametrize(
    ("head", "more", "kind", "is_always"),
    [
        (box(0.1, 0.3, 0.2), NECK, "continuous", False),
        (sphere(0.2), revolute(0, 0.5), "prismatic", False),
        (sphere(0.2), revolute(0, 0.05), "prismatic", True),
    ],
)
def test_a_pose_that_separates_them(head: str, more: str, kind: str, is_always: bool) -> None:
    found = messages("COL001", body(head, more, kind))
    assert ["every pose" in message for message in found if "'leg'" in message].count(True) == (
        is_always
    )


def wheel(inside: float, shape: str = box(0.2, 0.04, 0.2), kind: str = "continuous") -> str:
    """A wheel 0.04 m wide, as far inside a chassis 0.4 m wide, and lower than it."""
    return "\n".join(
        (
            link("chassis", box(0.6, 0.4, 0.1)),
            link("wheel", shape),
            joint("chassis", "wheel", kind, f"0.2 {0.22 - inside} -0.05"),
        )
    )


def test_a_wheel_deep_in_its_chassis() -> None:
    assert messages("COL001", wheel(0.035)) == [naming("wheel", "chassis", "35 mm", "88%")]
    assert severities(wheel(0.035)) == ["info"]
    assert places("COL001", wheel(0.035)) == [(3, "<collision>")]


@pytest.mark.parametrize("inside", [-0.01, 0.0, 0.01, 0.02])
def test_half_a_wheel_in_the_chassis_is_not_reported(inside: float) -> None:
    assert messages("COL001", wheel(inside)) == []


def test_a_fixed_wheel_is_not_reported() -> None:
    assert messages("COL001", wheel(0.035, kind="fixed")) == []


def test_the_depth_of_surfaces_is_not_trusted(tmp_path: Path) -> None:
    here = str(tmp_path / "robot.urdf")
    solid = mesh(cube(tmp_path / "solid.stl", 0.02))
    assert len(messages("COL001", wheel(0.035, solid).replace("-0.05", "-0.04"), here)) == 1
    hollow = mesh(cube(tmp_path / "hollow.stl", 0.02, 5))
    assert messages("COL001", wheel(0.035, hollow).replace("-0.05", "-0.04"), here) == []


def heavy(*parts: str) -> str:
    """Links with a mass, which Gazebo keeps, and joints."""
    moments = 'ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"'
    inertial = f'<inertial><mass value="1"/><inertia {moments}/></inertial>'
    return "\n".join(parts).replace("</link>", f"{inertial}</link>")


@pytest.mark.parametrize(
    "flag",
    [
        '<gazebo reference="tool"><selfCollide>true</selfCollide></gazebo>',
        '<gazebo reference="base"><self_collide>1</self_collide></gazebo>',
        "<gazebo><self_collide>true</self_collide></gazebo>",
    ],
)
def test_self_collide_makes_an_overlap_in_every_pose_a_warning(flag: str) -> None:
    """A tool that turns about its own axis in the base, behind a thin link."""
    text = heavy(
        link("base", box(0.2, 0.2, 0.2)),
        link("upper", f"{sphere(0.02)}@0 0 0.2"),
        link("tool", sphere(0.1)),
        joint("base", "upper", "revolute", "0 0 0.15", revolute(-1, 1, "0 0 1")),
        joint("upper", "tool", "revolute", "0 0 0", revolute(-1, 1, "0 0 1")),
    )
    assert severities(text) == ["info"]
    (found,) = reported("COL001", text + flag)
    assert found.severity is Severity.WARNING
    assert found.message.endswith("<self_collide> makes Gazebo push them apart")
    assert severities(text + flag.replace("true", "false").replace(">1<", ">0<")) == ["info"]
    beside = '<gazebo reference="upper"><selfCollide>true</selfCollide></gazebo>'
    assert severities(text + beside) == ["info"]


def test_gazebo_merges_fixed_links_and_ignores_those_with_a_joint() -> None:
    """A shoulder that is fixed to the hip, in which the thigh turns; as on Unitree's A1."""
    text = heavy(
        link("hip", f"{sphere(0.02)}@0 0 0.5"),
        link("shoulder", sphere(0.1)),
        link("thigh", sphere(0.1)),
        joint("hip", "shoulder", "fixed", "0 0 0"),
        joint("hip", "thigh", "revolute", "0.05 0 0", revolute(-1, 1, "1 0 0")),
    )
    flag = '<gazebo reference="thigh"><selfCollide>true</selfCollide></gazebo>'
    assert severities(text) == ["info"]
    assert severities(text + flag) == ["info"]
    kept = "<disableFixedJointLumping>true</disableFixedJointLumping>"
    lumping_off = f'<gazebo reference="hip_shoulder">{kept}</gazebo>'
    assert severities(text + flag + lumping_off) == ["warning"]


@pytest.mark.parametrize(
    ("names", "severity"),
    [(("left_wheel", "right_wheel"), "warning"), (("front_wheel", "rear_wheel"), "info")],
)
def test_two_wheels_in_one_place(names: tuple[str, str], severity: str) -> None:
    """A width of 0.2 for 0.02 m; wheels of one side may be a track."""
    robot = link("base")
    for name, y in zip(names, (0.05, -0.05), strict=True):
        robot += link(name, box(0.1, 0.2, 0.1))
        robot += joint("base", name, "continuous", f"0.3 {y} 0", '<axis xyz="0 1 0"/>')
    assert severities(robot) == [severity]
