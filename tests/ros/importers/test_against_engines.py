"""Orders, masses and tensors are those of the programs themselves."""

from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.consumers.comparison import robots, with_absolute_paths
from tests.ros.importers.engines import SCRIPTS, loaded
from urdfkit.errors import Unavailable
from urdfkit.lint import engine
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.lint.options import Options
from urdfkit.text.source import Source

LIMIT = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
KINDS = ("fixed", "revolute", "continuous", "prismatic", "planar", "floating")
#: Where a program is not compared: MuJoCo takes a free joint at the top alone, PyBullet welds it.
WITHOUT = {"mujoco": ("floating",), "pinocchio": (), "pybullet": ("floating", "planar")}


def compare(robot: Context, name: str, expected: dict[str, Any]) -> None:
    found = robot.imported(name)
    names = [(one.names[0], one.q, one.v) for one in found.joints]
    ends = ("_TY", "_RZ")  # the second and third joint that MuJoCo makes of a planar one
    assert names == [joint for joint in expected["joints"] if not joint[0].endswith(ends)]
    bodies = {one.name: one for one in found.bodies if one.name in expected["bodies"]}
    assert set(bodies) == set(expected["bodies"])
    for body, values in expected["bodies"].items():
        properties = bodies[body].properties
        assert properties is not None
        mass, *rest = values
        assert properties.mass == pytest.approx(mass, rel=1e-6, abs=1e-9)
        if rest and mass:
            xx, xy, xz, yy, yz, zz = properties.tensor
            tensor = (xx, xy, xz, xy, yy, yz, xz, yz, zz)
            assert properties.center == pytest.approx(rest[:3], abs=1e-6)
            assert tensor == pytest.approx(rest[3:], abs=1e-5 * max(map(abs, tensor)) + 1e-12)


@pytest.mark.parametrize(("path", "arguments"), robots())
@pytest.mark.parametrize("name", SCRIPTS)
def test_a_real_robot(name: str, path: Path, arguments: dict[str, str], tmp_path: Path) -> None:
    robot = next(iter(engine.contexts(Options(arguments=arguments).resolved(), [path])), None)
    if robot is None:
        pytest.skip("not a whole robot")
    try:
        text = with_absolute_paths(robot)
    except (Unavailable, SyntaxError):
        pytest.skip("it does not expand here")
    expected = loaded(name, text, tmp_path)
    if expected is None:
        pytest.skip(f"{name} rejects it")
    compare(read(Source(str(tmp_path / "robot.urdf"), text), trust=True), name, expected)


def link(name: str, mass: float) -> str:
    moment = f'ixx="{mass}" iyy="{mass}" izz="{mass}" ixy="0" ixz="0" iyz="0"'
    origin = f'<origin xyz="0 {mass / 9} 0"/>'
    return (
        f'<link name="{name}"><inertial>{origin}<mass value="{mass}"/><inertia {moment}/>'
        "</inertial></link>"
    )


@st.composite
def trees(draw: st.DrawFn, without: tuple[str, ...]) -> str:
    """A branched robot whose links and joints are written in any order, under odd names."""
    names = draw(
        st.lists(st.text("aAbB19_-.", min_size=1, max_size=3), min_size=2, max_size=9, unique=True)
    )
    kinds = [kind for kind in KINDS if kind not in without]
    links = [link(f"l{name}", 1 + index) for index, name in enumerate(names)]
    joints = []
    for index, name in enumerate(names[1:], 1):
        parent = names[draw(st.integers(0, index - 1))]
        kind = draw(st.sampled_from(kinds))
        mimic = f'<mimic joint="j{names[1]}"/>' if kind == "revolute" and index > 1 else ""
        turn = '<origin xyz="1 2 3" rpy="0.1 0.2 0.3"/>'
        joints.append(
            f'<joint name="j{name}" type="{kind}"><parent link="l{parent}"/>'
            f'<child link="l{name}"/>{turn}<axis xyz="0 0 1"/>{LIMIT}{mimic}</joint>'
        )
    parts = draw(st.permutations([*links, *joints]))
    return f'<robot name="r">{"".join(parts)}</robot>'


@pytest.mark.parametrize("name", ["mujoco", "pinocchio"])
def test_random_trees(name: str, tmp_path: Path) -> None:
    # Each tree starts a process.
    fewer = settings(max_examples=settings().max_examples // 8)

    @settings(fewer, suppress_health_check=[HealthCheck.function_scoped_fixture])
    @given(trees(WITHOUT[name]))
    def runs(text: str) -> None:
        expected = loaded(name, text.encode(), tmp_path)
        if expected is not None:  # a mimic of a joint of another kind may be rejected
            compare(read(Source("r.urdf", text.encode())), name, expected)

    runs()
