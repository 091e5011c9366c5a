from pathlib import Path

import pytest

from tests.srdfs import findings

GROUP = '<group name="arm"><link name="arm"/></group>'


@pytest.mark.parametrize(
    ("solver", "suggested"),
    [
        ("kdl_kinematics_plugin/KDLKinematicPlugin", "kdl_kinematics_plugin/KDLKinematicsPlugin"),
        ("KDLKinematicsPlugin", "kdl_kinematics_plugin/KDLKinematicsPlugin"),
        ("trac_ik_kinematics_plugin/TRACIKKinematicsPlugin", None),
        ("kdl_kinematics_plugin/KDLKinematicsPlugin", ""),
        ("ur_kinematics/UR5eKinematicsPlugin", ""),
        ("my_arm/IKFastKinematicsPlugin", ""),
        ("my_solvers/Mine", ""),
    ],
)
def test_misspelt_solvers(tmp_path: Path, solver: str, suggested: str | None) -> None:
    (tmp_path / "kinematics.yaml").write_text(f"arm:\n  kinematics_solver: {solver}\n")
    found = findings(tmp_path, GROUP, "SRD001")
    assert len(found) == (suggested != "")
    for one in found:
        assert one.span.text == solver
        assert suggested is None or one.help == f"write {suggested}"
