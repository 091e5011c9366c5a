"""Draw the pictures of the documentation anew, of robots here and of a directory with real ones.

Usage: PYTHONPATH=. python docs/pictures.py --shared DIRECTORY (as ``benchmarks/bench.py`` has it)
"""

import argparse
import shutil
import sys
import tempfile
from pathlib import Path

from urdfkit.cli import main as urdfkit

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "models" / "gazebo_pkg"
DIRECTORY = ROOT / "docs" / "pictures"

UR5E = "Universal_Robots_ROS2_Description/urdf/ur.urdf.xacro"
POSE = ["shoulder_lift_joint=-1.9", "elbow_joint=1.9", "wrist_1_joint=-1.6", "wrist_2_joint=-1.6"]
SMALL, LARGE = ["--size", "480x360"], ["--size", "640x480"]


def drawn(name: str, robot: Path, *words: str, size: list[str] = SMALL) -> None:
    """One picture, by the command that readers would give."""
    if not robot.is_file():
        print(f"{name}: {robot} is not here", file=sys.stderr)
        return
    code = urdfkit(["render", str(robot), *words, *size, "-o", str(DIRECTORY / f"{name}.webp")])
    assert code == 0, name


def fixed(directory: Path) -> Path:
    """The robot of the quick start, after what the quick start does."""
    shutil.copytree(PACKAGE, directory / "mine")
    robot = directory / "mine" / "urdf" / "waking_robot_new.xacro"
    urdfkit(["fix", str(directory / "mine"), "--unsafe-fixes", "--generate-meshes"])
    return robot


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--shared", type=Path, default=ROOT.parent / "shared")
    corpus = parser.parse_args().shared / "corpus"
    mission = PACKAGE / "urdf" / "waking_robot_new.xacro"
    arm = [f"--joint={word}" for word in POSE]
    ur5e = ["ur_type:=ur5e", "name:=ur", *arm]
    with tempfile.TemporaryDirectory() as scratch:
        drawn("robot", fixed(Path(scratch)), size=LARGE)
    drawn("findings", mission, "--findings", size=LARGE)
    drawn("collision", mission, "--layers", "visual,collision,names")
    drawn("ur5e", corpus / UR5E, *ur5e)
    drawn("joints", corpus / UR5E, *ur5e, "--layers", "visual,joints,frames")
    anymal = corpus / "anymal_c_simple_description" / "urdf" / "anymal.urdf"
    drawn("anymal", anymal)
    drawn("sheet", anymal, "--view", "iso,front,left,top")
    create3 = "create3_sim/irobot_create_common/irobot_create_description/urdf/create3.urdf.xacro"
    drawn("create3", corpus / create3)


if __name__ == "__main__":
    main()
