"""Pairs that may collide: the SRDF states it, or MoveIt checks another pair that collides first."""

from pathlib import Path

import pytest

pytest.importorskip("coal")

from tests.physics.collision.robots import joint, link, revolute, sphere
from urdfkit import check
from urdfkit.lint.options import Options
from urdfkit.lint.rule_examples import whole_robot

TURN = revolute(-3, 3, "0 1 0")


def messages(directory: Path, robot: str, *disabled: tuple[str, str]) -> list[str]:
    pairs = [f'<disable_collisions link1="{a}" link2="{b}" reason="Never"/>' for a, b in disabled]
    (directory / "r.urdf").write_text(whole_robot(robot))
    (directory / "r.srdf").write_text(f'<robot name="example">{"".join(pairs)}</robot>')
    found = check(directory / "r.urdf", select=["SRD009"], options=Options(cache=False))
    assert found.crashed == ()
    return [one.message.partition(" overlap")[0] for one in found.diagnostics]


def arm(guard: str) -> str:
    """A hand that may hit the base; a guard on the hand is around it."""
    return "".join(
        (
            link("base", sphere(0.2)),
            link("upper", f"{sphere(0.05)}@0 0 0.5"),
            link("hand", f"{sphere(0.1)}@0 0 0.5"),
            link("guard", guard),
            joint("base", "upper", "revolute", more=TURN),
            joint("upper", "hand", "revolute", "0 0 0.7", TURN),
            joint("hand", "guard"),
        )
    )


def test_a_pose_that_a_checked_pair_forbids_does_not_count(tmp_path: Path) -> None:
    robot = arm(f"{sphere(0.12)}@0 0 0.5")
    held = ("hand", "guard")  # nor does a joint move these
    assert messages(tmp_path, robot, ("hand", "base"), held) == []
    assert messages(tmp_path, robot, ("hand", "base"), ("guard", "base"), held) == [
        "'hand' and 'base'",
        "'guard' and 'base'",
    ]
    assert messages(tmp_path, robot, ("hand", "base"), ("guard", "base")) == []


def test_a_checked_pair_that_is_elsewhere_does_not_matter(tmp_path: Path) -> None:
    """A second arm may collide with anything in most poses, but need not."""
    robot = arm(f"{sphere(0.01)}@0 0 0.9") + "".join(
        (
            link("tail", f"{sphere(0.3)}@0 0 -0.55"),
            joint("base", "tail", "revolute", "0 0 -0.05", more=TURN),
        )
    )
    held = (("hand", "guard"), ("guard", "base"))
    assert messages(tmp_path, robot, ("hand", "base"), *held)[:1] == ["'hand' and 'base'"]


def test_a_robot_for_tests_has_no_srdf_of_the_package(tmp_path: Path) -> None:
    """Talos: test/calibration/displaced.urdf, whose legs are displaced on purpose."""
    (tmp_path / "package.xml").write_text("<package><name>r</name></package>")
    (tmp_path / "srdf").mkdir()
    (tmp_path / "srdf" / "r.srdf").write_text('<robot name="r"><group_state name="s"/></robot>')
    counts = []
    for directory in ("urdf", "test/calibration"):
        (tmp_path / directory).mkdir(parents=True)
        file = tmp_path / directory / "r.urdf"
        file.write_text('<robot name="r"><link name="a"/></robot>')
        counts.append(len(check(file, select=["SRD"]).diagnostics))
    assert counts[0] > 0 == counts[1]


@pytest.mark.parametrize("is_between", [True, False])
def test_links_that_a_joint_connects(tmp_path: Path, is_between: bool) -> None:
    """KUKA iiwa: base_link and link_1, disabled as Adjacent and, by a copied line, as Never."""
    robot = "".join(
        (
            link("base", sphere(0.2)),
            link("upper", *[sphere(0.2)] * is_between),
            link("hand", f"{sphere(0.1)}@0 0 0.5"),
            joint("base", "upper", "revolute", more=TURN),
            joint("upper", "hand", "revolute", "0 0 0.6", TURN),
        )
    )
    assert messages(tmp_path, robot, ("base", "upper"), ("upper", "hand")) == []
    hits = ["'base' and 'hand'"] if is_between else []  # else nothing lies between the two
    assert messages(tmp_path, robot, ("base", "hand"), ("base", "upper"), ("upper", "hand")) == hits


def test_a_pair_that_is_disabled_for_another_reason_as_well(tmp_path: Path) -> None:
    robot = arm(f"{sphere(0.01)}@0 0 0.9")
    assert messages(tmp_path, robot, ("hand", "base")) != []
    (tmp_path / "r.srdf").write_text(
        '<robot name="example"><disable_collisions link1="hand" link2="base" reason="Never"/>'
        '<disable_collisions link1="base" link2="hand" reason="User"/></robot>'
    )
    assert check(tmp_path / "r.urdf", select=["SRD009"]).diagnostics == ()


@pytest.mark.parametrize("names", [("r",), ("long", "short")])  # of a robot, of its variants
@pytest.mark.parametrize(("disabled", "count"), [("base", 0), ("upper", 1)])
def test_an_overlap_that_the_srdf_allows(
    tmp_path: Path, disabled: str, count: int, names: tuple[str, ...]
) -> None:
    """Fetch's bellows are inside its base and inside one another."""
    robot = link("base", sphere(0.2)) + link("upper", f"{sphere(0.05)}@0 0 0.5")
    robot += link("hand", f"{sphere(0.1)}@0 0 -0.6")
    robot += joint("base", "upper", "revolute", more=TURN)
    robot += joint("upper", "hand", "revolute", "0 0 0.7", TURN)
    (tmp_path / "r.urdf").write_text(whole_robot(robot))
    pair = f'<disable_collisions link1="{disabled}" link2="hand" reason="Default"/>'
    for name in names:
        (tmp_path / f"{name}.srdf").write_text(f'<robot name="example">{pair}</robot>')
    found = check(tmp_path / "r.urdf", select=["COL001"], options=Options(cache=False))
    assert len(found.diagnostics) == count


@pytest.mark.parametrize(("geometry", "severity"), [(sphere(0.1), "warning"), ("", "info")])
def test_a_link_without_geometry_is_not_adjacent(
    tmp_path: Path, geometry: str, severity: str
) -> None:
    """Motoman's SDA10F: its base_link is only a frame, and cannot collide."""
    robot = (link("base", geometry) if geometry else '<link name="base"/>') + "".join(
        (
            link("upper", f"{sphere(0.05)}@0 0 0.5"),
            link("hand", f"{sphere(0.1)}@0 0 0.5"),
            joint("base", "upper", "revolute", more=TURN),
            joint("upper", "hand", "revolute", "0 0 0.7", TURN),
        )
    )
    (tmp_path / "r.urdf").write_text(whole_robot(robot))
    pair = '<disable_collisions link1="base" link2="hand" reason="Adjacent"/>'
    (tmp_path / "r.srdf").write_text(f'<robot name="example">{pair}</robot>')
    report = check(tmp_path / "r.urdf", select=["SRD010"], options=Options(cache=False))
    found = [one for one in report.diagnostics if "not adjacent" in one.message]
    assert [one.severity.value for one in found] == [severity]
