"""SRD009: see the rule."""

import re
from collections.abc import Sequence
from pathlib import Path

import pytest

pytest.importorskip("coal")

from tests.naming import values
from tests.physics.collision.robots import joint, link, revolute, sphere
from urdfkit import Diagnostic, check
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.mesh.io.load import load
from urdfkit.mesh.samples import box, stl
from urdfkit.mesh.writers import encode
from urdfkit.physics.collision.sampled_poses import SampledPoses

TURN = revolute(-3, 3, "0 1 0")
ARM = whole_robot(
    "\n".join(
        (
            link("base", sphere(0.2)),
            link("upper", f"{sphere(0.05)}@0 0 0.5"),
            link("hand", f"{sphere(0.1)}@0 0 0.5"),
            link("frame"),
            joint("base", "upper", "revolute", more=TURN),
            joint("upper", "hand", "revolute", "0 0 0.7", TURN),
            joint("hand", "frame"),
        )
    )
)


def reported(directory: Path, matrix: str, robot: str = ARM) -> list[Diagnostic]:
    (directory / "r.urdf").write_text(robot)
    (directory / "r.srdf").write_text(f'<robot name="example">\n{matrix}\n</robot>\n')
    return list(check(directory / "r.urdf", select=["SRD009"]).diagnostics)


def pair(first: str, second: str, reason: str = "Never") -> str:
    return f'<disable_collisions link1="{first}" link2="{second}" reason="{reason}"/>'


def test_the_depth_and_the_pose(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, pair("hand", "base"))
    assert values(found.message)[:2] == ["hand", "base"]
    assert "upper_hand " in found.message
    assert found.span.source.path == str(tmp_path / "r.srdf")
    assert found.span.line == 2


def test_a_pair_that_is_listed_twice(tmp_path: Path) -> None:
    """As in the SRDF of HyQ, whose second entry names the links in the other order."""
    found = reported(tmp_path, f"{pair('hand', 'base')}\n{pair('base', 'hand')}")
    assert [one.span.line for one in found] == [2, 3]


@pytest.mark.parametrize(
    "matrix",
    [
        pair("hand", "base", "User"),
        pair("hand", "base", "Default"),
        pair("hand", "frame"),  # no collision geometry
        pair("hand", "nothing"),
        pair("hand", "hand"),
        "",
    ],
)
def test_matrix_that_is_accepted(tmp_path: Path, matrix: str) -> None:
    assert reported(tmp_path, matrix) == []


def test_collision_outside_the_limits_is_accepted(tmp_path: Path) -> None:
    short = ARM.replace('lower="-3" upper="3"', 'lower="-2" upper="2"')
    assert reported(tmp_path, pair("hand", "base"), short) == []


def test_the_matrix_of_a_real_arm(corpus: Path) -> None:
    """Confirmed by hand: see docs/commands/collisions.md."""
    file = corpus / "moveit_resources" / "panda_moveit_config" / "config" / "panda.urdf.xacro"
    found = check(file, select=["SRD009"]).diagnostics
    assert {one.message.partition(" overlap")[0] for one in found} <= {
        "'panda_link2' and 'panda_link6'"
    }


def test_a_long_matrix_gets_fewer_samples(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The two hands of a humanoid have 2000 pairs."""
    asked: list[tuple[int, int]] = []

    def colliding(
        _: SampledPoses, pairs: Sequence[tuple[str, str]], samples: int, is_checked: object
    ) -> list[None]:
        asked.append((len(pairs), samples))
        return [None] * len(pairs)

    monkeypatch.setattr(SampledPoses, "colliding", colliding)
    reported(tmp_path, pair("hand", "base"))
    reported(tmp_path, pair("hand", "base") * 1000)
    assert asked == [(1, 2000), (1000, 400)]


@pytest.mark.parametrize(("meter", "count"), [("1", 1), ("0.001", 0)])
def test_a_mesh_in_another_unit_is_not_what_moveit_reads(
    tmp_path: Path, meter: str, count: int
) -> None:
    """myCobot's gripper is 48 m long for MoveIt: MSH013 reports its unit."""
    pytest.importorskip("lxml")
    (tmp_path / "hand.stl").write_bytes(stl(box((-0.1, -0.1, -0.1), (0.1, 0.1, 0.1))))
    data = encode(load(tmp_path / "hand.stl"), "hand.dae")["hand.dae"]
    unit = re.sub(rb'meter="[^"]*"', f'meter="{meter}"'.encode(), data)
    (tmp_path / "hand.dae").write_bytes(unit)
    hand = link("hand", f"{sphere(0.1)}@0 0 0.5")
    mesh = re.sub("<sphere[^>]*>", '<mesh filename="hand.dae"/>', hand)
    robot = ARM.replace(hand, mesh)
    assert robot != ARM
    assert len(reported(tmp_path, pair("base", "hand"), robot)) == count
