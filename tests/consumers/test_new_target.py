"""A target is added by its file alone."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import urdfkit

FACTS = {
    "title": "Strict Sim",
    "rejects_repeated": True,
    "least_moment": 0.5,
    "severities": {"TRE002": "info", "TRE007": "error"},
}
INERTIAL = (
    '<inertial><mass value="1"/>'
    '<inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>'
)
ROBOTS = {
    "two.urdf": '<robot name="r"><link name="a"/><link name="b"/></robot>',
    "arm.urdf": f'<robot name="r"><link name="a">{INERTIAL}{INERTIAL}</link></robot>',
}


def test_a_file_is_a_target(tmp_path: Path) -> None:
    package = tmp_path / "urdfkit"
    shutil.copytree(Path(urdfkit.__file__).parent, package)
    facts = package / "ros" / "catalog" / "targets" / "strict.json"
    facts.write_text(json.dumps(FACTS), encoding="utf-8")
    for name, text in ROBOTS.items():
        tmp_path.joinpath(name).write_text(text, encoding="utf-8")
    run = subprocess.run(
        [sys.executable, "-m", "urdfkit", "check", *ROBOTS, "--no-cache", "--format=json",
         "--target=strict"],
        cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(tmp_path)}, capture_output=True,
        check=False,
    )  # fmt: skip
    found = {one["code"]: one for one in json.loads(run.stdout)["diagnostics"]}
    severities = {code: one["severity"] for code, one in found.items()}
    assert severities["TRE002"] == "info"
    assert severities["INE005"] == severities["URD007"] == "error"
    assert "Strict Sim rejects" in found["URD007"]["message"]
    assert found["INE005"]["targets"] == ["strict"]
