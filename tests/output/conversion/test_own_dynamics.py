"""Our own dynamics equal Pinocchio's, and prove what Pinocchio cannot take."""

from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings

from tests.output.conversion.test_mjcf import INERTIAL, LIMIT
from urdfkit import convert, read
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.text.source import Source

np = pytest.importorskip("numpy")
pytest.importorskip("mujoco")
pytest.importorskip("pinocchio")

from tests.physics.dynamics.test_against_pinocchio import robots
from urdfkit.output.conversion.own_dynamics import OwnDynamics
from urdfkit.physics.dynamics.robot import MAX_JOINTS


@settings(suppress_health_check=list(HealthCheck), derandomize=True)
@given(robots())
def test_random_trees(text: str) -> None:
    robot = read(Source("r.urdf", text.encode()))
    own, pinocchio = OwnDynamics(robot.tree), robot.dynamics
    random = np.random.default_rng(0)
    pose = {name: random.uniform(-1, 1) for name in own.columns}
    columns = [pinocchio.columns.index(name) for name in own.columns]
    for name, matrix in pinocchio.placements(pose).items():
        assert own.placements(pose)[name] == pytest.approx(matrix, abs=1e-9)
    ours, theirs = own.mass_matrix(pose), pinocchio.mass_matrix(pose)[np.ix_(columns, columns)]
    assert ours == pytest.approx(theirs, rel=1e-9, abs=1e-9)
    assert own.gravity(pose) == pytest.approx(pinocchio.gravity(pose)[columns], rel=1e-9, abs=1e-9)


def chain(count: int) -> Context:
    """A robot with so many joints in a row."""
    links = "".join(f'<link name="l{number}">{INERTIAL}</link>' for number in range(count + 1))
    joints = "".join(
        f'<joint name="j{number}" type="revolute"><parent link="l{number}"/>'
        f'<child link="l{number + 1}"/><origin xyz="0 0.01 0.02"/>{LIMIT}</joint>'
        for number in range(count)
    )
    return read(Source("r.urdf", f'<robot name="r">{links}{joints}</robot>'.encode()))


def test_a_robot_with_too_many_joints_for_pinocchio(tmp_path: Path) -> None:
    found = convert(chain(MAX_JOINTS + 1), tmp_path / "o")
    assert found.proof.holds
    assert found.proof.agreed.startswith("MuJoCo and urdfkit agree")


def test_a_robot_with_too_many_joints_to_compare(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("urdfkit.output.conversion.mjcf_proof.MAX_OWN", MAX_JOINTS)
    error = f"^r.urdf:1:1: {MAX_JOINTS + 1} joints move; MJCF is verified for up to {MAX_JOINTS}; "
    with pytest.raises(UrdfkitError, match=error):
        convert(chain(MAX_JOINTS + 1), tmp_path / "o")
    assert not (tmp_path / "o").exists()
