"""Robots that behave and robots that do not, in MuJoCo."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.conftest import MODELS
from urdfkit import read
from urdfkit.output.simulation import simulate
from urdfkit.text.source import Source

for library in ("mujoco", "numpy", "trimesh"):
    pytest.importorskip(library)

HERE = Path(__file__).parents[2]
ROVER = HERE / "carriers" / "rover" / "urdf" / "rover.urdf.xacro"
PICKER = HERE / "carriers" / "picker" / "urdf" / "picker.urdf"


def link(name: str, at: str = "0 0 0", mass: float = 1.0) -> str:
    """A box of 0.1 m, whose centre is at a place."""
    moment = mass / 600
    return (
        f'<link name="{name}"><inertial><origin xyz="{at}"/><mass value="{mass}"/>'
        f'<inertia ixx="{moment}" ixy="0" ixz="0" iyy="{moment}" iyz="0" izz="{moment}"/>'
        f'</inertial>\n<collision><origin xyz="{at}"/><geometry><box size="0.1 0.1 0.1"/>'
        "</geometry></collision></link>\n"
    )


def joint(name: str, parent: str, at: str, kind: str = "revolute", effort: float = 100) -> str:
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{name}"/>'
        f'<origin xyz="{at}"/><axis xyz="0 1 0"/>'
        f'<limit lower="-3" upper="3" effort="{effort}" velocity="1"/></joint>\n'
    )


def robot(*parts: str) -> Source:
    return Source(
        "r.urdf", f'<robot name="r">\n<link name="world"/>{"".join(parts)}</robot>'.encode()
    )


def failures(source: Source | Path, base: str = "auto") -> dict[str, tuple[str, ...]]:
    found = simulate(read(source), base=base)
    return {one.test: one.names for one in found.verdicts if not one.passes}


@pytest.mark.parametrize(
    "path", [ROVER, PICKER, *sorted((MODELS / "good").rglob("*.urdf"))], ids=lambda path: path.stem
)
def test_sound_robots_behave(path: Path) -> None:
    assert failures(path) == {}


def test_links_in_one_another_push_each_other_away() -> None:
    pair = robot(
        link("a"), joint("a", "world", "0 0 0"), link("b"), joint("b", "world", "0.05 0 0")
    )
    found = {one.test: one for one in simulate(read(pair)).verdicts}
    assert found["overlap"].value == pytest.approx(0.05)
    assert found["overlap"].names == ("a", "b")
    assert found["overlap"].span is not None
    assert found["overlap"].span.line == 3
    assert found["energy"].value > found["energy"].bound


def test_neighbours_of_what_is_welded_collide_in_mujoco() -> None:
    inside = robot(
        link("base"),
        joint("base", "world", "0 0 0", "fixed"),
        link("a"),
        joint("a", "base", "0 0 0"),
    )
    assert failures(inside)["overlap"] == ("a", "base")
    (overlap,) = [one for one in simulate(read(inside)).verdicts if one.test == "overlap"]
    assert overlap.message.endswith("since the parent is welded to the world")
    floating = Source("r.urdf", inside.data.replace(b'"world"', b'"root"'))
    assert "overlap" not in failures(floating, base="free"), "there MuJoCo leaves the pair out"


@pytest.mark.parametrize(("effort", "holds"), [(4.8, False), (5.0, True)])
def test_a_joint_holds_with_its_effort(effort: float, holds: bool) -> None:
    """A mass of 1 kg at 0.5 m needs 4.905 N·m."""
    arm = robot(link("arm", at="0.5 0 0"), joint("arm", "world", "0 0 0", effort=effort))
    (verdict,) = [one for one in simulate(read(arm)).verdicts if one.test == "hold"]
    assert verdict.passes is holds
    if not holds:
        assert "needs 4.91 N·m, its effort is 4.8 N·m" in verdict.message


def test_what_follows_starts_where_its_leader_takes_it() -> None:
    """From zero it would be thrown there: a gain of 14 J."""
    follower = joint("b", "world", "0 2 0").replace(
        "</joint>", '<mimic joint="a" multiplier="1" offset="0.8"/></joint>'
    )
    arms = link("a", at="0.5 0 0"), joint("a", "world", "0 0 0"), link("b", at="0.5 0 0"), follower
    assert failures(robot(*arms)) == {}


def test_a_joint_starts_within_its_range() -> None:
    arm = robot(link("arm", at="0.5 0 0"), joint("arm", "world", "0 0 0"))
    lifted = Source("r.urdf", arm.data.replace(b'lower="-3"', b'lower="1"'))
    assert failures(lifted) == {}


@pytest.mark.parametrize(("step", "test"), [(0.02, "energy"), (0.1, "stability")])
def test_steps_that_are_too_coarse_are_blamed(
    step: float, test: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from urdfkit.output.simulation import running

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(running, "STEP", step)
    pendulum = robot(
        link("a", at="0.5 0 0"), joint("a", "world", "0 0 0", "continuous"),
        link("b", at="0.5 0 0"), joint("b", "a", "1 0 0", "continuous"),
    )  # fmt: skip
    (failure,) = [one for one in simulate(read(pendulum)).verdicts if not one.passes]
    assert failure.test == test
    assert failure.message.endswith("but not with steps of 0.5 ms")
    assert failure.names == (("a",) if test == "stability" else ())
    assert list(tmp_path.iterdir()) == [], "MuJoCo writes no log"


def test_a_robot_on_wheels_stands_on_a_floor() -> None:
    assert simulate(ROVER).is_free
    assert not simulate(ROVER, base="fixed").is_free
