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
SMALL, LARGE, WIDE = (["--size", size] for size in ("480x360", "640x480", "720x405"))

ANYMAL = "anymal_c_simple_description"
#: What is wrong in the copy of ANYmal C: links, and texts in them before and after.
MISTAKES = (
    ("LF_thigh_fixed", 'mass value="1.03"', 'mass value="0.00103"'),
    ("LH_thigh_fixed", 'ixx="0.018644469"', 'ixx="18.644469"'),
    ("RF_KFE", 'xyz="-0.063 7e-05', 'xyz="-0.63 7e-05'),
    ("RF_FOOT", 'iyy="', 'iyy="-'),
)


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


def broken(package: Path, directory: Path) -> Path:
    """A copy of ANYmal C with `MISTAKES` and without the mesh of its lidar."""
    if not package.is_dir():
        return package
    copy = shutil.copytree(package, directory / ANYMAL)
    (copy / "meshes" / "lidar.dae").unlink()
    robot = copy / "urdf" / "anymal.urdf"
    text = robot.read_text(encoding="utf-8")
    for link, old, new in MISTAKES:
        before, name, rest = text.partition(f'<link name="{link}">')
        own, end, after = rest.partition("</link>")
        assert old in own, link
        text = before + name + own.replace(old, new) + end + after
    robot.write_text(text, encoding="utf-8")
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
        mistaken = broken(corpus / ANYMAL, Path(scratch))
        drawn("anymal-findings", mistaken, "--findings", size=WIDE)
    drawn("findings", mission, "--findings", size=LARGE)
    drawn("collision", mission, "--layers", "visual,collision,names")
    drawn("ur5e", corpus / UR5E, *ur5e)
    drawn("joints", corpus / UR5E, *ur5e, "--layers", "visual,joints,frames")
    anymal = corpus / ANYMAL / "urdf" / "anymal.urdf"
    drawn("anymal", anymal)
    drawn("sheet", anymal, "--view", "iso,front,left,top")
    create3 = "create3_sim/irobot_create_common/irobot_create_description/urdf/create3.urdf.xacro"
    drawn("create3", corpus / create3)


if __name__ == "__main__":
    main()
