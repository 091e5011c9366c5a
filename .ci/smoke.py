"""The installed wheel does its main job in an environment without any extra.

Usage: smoke.py MODELS, with the Python of that environment, outside the checkout.
"""

import importlib.metadata
import importlib.util
import json
import os
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path

BIN = Path(sysconfig.get_path("scripts"))
HEAVY = ("numpy", "trimesh", "manifold3d", "pinocchio", "coal", "yourdfpy")


def run(command: str, *arguments: str | Path, code: int = 0) -> str:
    """The standard output of an installed command that must end with this exit code."""
    result = subprocess.run(
        [BIN / command, *arguments], capture_output=True, text=True, encoding="utf-8", check=False
    )
    reported = f"{command} {' '.join(map(str, arguments))}: exit {result.returncode}\n"
    assert result.returncode == code, reported + result.stdout + result.stderr
    assert "Traceback" not in result.stderr, reported + result.stderr
    return result.stdout


def main() -> None:
    models = Path(sys.argv[1])
    mission = models / "gazebo_pkg" / "urdf" / "waking_robot_new.xacro"
    present = [name for name in HEAVY if importlib.util.find_spec(name)]
    assert not present, f"the lean environment holds {present}"
    spec = importlib.util.find_spec("urdfkit")
    assert spec is not None
    assert not str(spec.origin).startswith(str(models.parent) + os.sep), spec.origin

    version = importlib.metadata.version("urdfkit")
    assert version in run("urdfkit", "--version")
    assert (Path(str(spec.origin)).parent / "py.typed").is_file()

    report = json.loads(run("urdfkit", "check", "--format", "json", mission, code=1))
    codes = {diagnostic["code"] for diagnostic in report["diagnostics"]}
    assert {"MSH001", "TRE008", "URD001", "URD008", "XAC004", "XAC007", "XAC014"} <= codes, codes
    assert report["crashed"] == []

    with tempfile.TemporaryDirectory() as directory:
        run("urdfkit", "new", "started", "--kind", "arm", "-o", directory)
        run("urdfkit", "check", directory)

    for name in ("gripper.urdf", "two_link_arm/urdf/two_link_arm.urdf"):
        run("urdfkit", "check", models / "good" / name)
    run("urdfkit", "check", models / "good" / "mobile_base" / "urdf" / "mobile_base.urdf.xacro")
    assert "error" in run("urdfkit", "check", models / "bad" / "broken_meshes.urdf", code=1)

    assert run("urdfkit", "expand", mission) == run("xacro", mission)
    assert "MSH001" in run("urdfkit", "explain", "MSH001")
    run("urdfkit", "lsp", code=2)  # it says which extra to install
    run("urdfkit", "mcp", code=2)
    assert run("urdfkit", "rules").count("MSH") >= 12

    example = models.parent / "examples" / "own_rule"
    assert "ACM001  warning  fix  joint-too-fast" in run("urdfkit", "rules")
    assert run("urdfkit", "explain", "joint-too-fast").startswith("ACM001 ")
    arm = example / "robots" / "arm.urdf"
    assert "ACM001" not in run("urdfkit", "check", "--isolated", "--exit-zero", arm)
    assert "ACM001" in run("urdfkit", "check", "--isolated", "--rules", "acme", arm, code=1)
    run("urdfkit", "check", arm, code=2)  # names a module, and was not named itself

    print(f"urdfkit {version} from the wheel: {len(codes)} kinds of findings in {mission.name}")


main()
