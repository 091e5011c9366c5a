"""What urdfkit and other programs say about small robots with one defect each.

Usage: python benchmarks/defects.py [--peers PYTHON]; PYTHON has drake and mujoco. A program that is
not installed is left out. The table of docs/comparison.md was made by this.
"""

import argparse
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

_LINK = (
    '<link name="{}"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0"'
    ' izz="1"/></inertial><collision><geometry><box size="1 1 1"/></geometry></collision></link>'
)
_JOINT = (
    '<joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>'
    '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
)
SOUND = f'<robot name="r">{_LINK.format("a")}{_LINK.format("b")}{_JOINT}</robot>'

_PLUGIN = (
    '<gazebo><plugin name="p" filename="libgazebo_ros_diff_drive.so"><leftJoint>x</leftJoint>'
    "<rightJoint>j</rightJoint></plugin></gazebo>"
)

#: By name: the code of urdfkit's finding, what is replaced where it comes last, and by what.
DEFECTS = {
    "a mesh file is missing": ("MSH001", '<box size="1 1 1"/>', '<mesh filename="no.obj"/>'),
    "a mass below zero": ("INE001", 'mass value="1"', 'mass value="-1"'),
    "an inertia that no body has": ("INE003", 'izz="1"', 'izz="3"'),
    "lower limit above upper": ("JNT003", 'lower="-1" upper="1"', 'lower="1" upper="-1"'),
    "limits in degrees": ("JNT010", 'lower="-1" upper="1"', 'lower="-90" upper="90"'),
    "a misspelt attribute": ("URD002", "velocity=", "velocty="),
    "mimic of an unknown joint": ("REF001", "</joint>", '<mimic joint="x"/></joint>'),
    "an axis of length zero": ("JNT006", 'axis xyz="0 0 1"', 'axis xyz="0 0 0"'),
    "links in a circle": (
        "TRE003",
        "</robot>",
        _JOINT.replace('"j"', '"k"')
        .replace('"a"', '"c"')
        .replace('"b"', '"a"')
        .replace('"c"', '"b"')
        + "</robot>",
    ),
    "friction inside a link": ("URD008", "</link>", "<mu1>0.5</mu1></link>"),
    "a plugin names a joint that is not there": (
        "GAZ021",
        "</robot>",
        _PLUGIN + "</robot>",
    ),
}

_DRAKE = """
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant
plant = MultibodyPlant(0.0)
Parser(plant).AddModels({!r})
plant.Finalize()
"""
_MUJOCO = "import mujoco; mujoco.MjModel.from_xml_path({!r})"


def verdict(command: list[str]) -> str:
    """``refuses``, ``warns`` or ``silent``, by exit code and what is written to standard error."""
    try:
        done = subprocess.run(command, check=False, capture_output=True, text=True, timeout=20)
    except subprocess.TimeoutExpired:
        return "hangs"
    if done.returncode:
        return "refuses"
    return "warns" if done.stderr.strip() else "silent"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--peers", default=sys.executable, help="a Python with drake and mujoco")
    python = parser.parse_args().peers
    programs = {}
    for name, module, program in (("Drake", "pydrake", _DRAKE), ("MuJoCo", "mujoco", _MUJOCO)):
        if verdict([python, "-c", f"import {module}"]) != "refuses":
            programs[name] = [python, "-c", program]
    if checker := shutil.which("check_urdf"):
        programs = {"check_urdf": [checker, "{!s}"], **programs}
    print("|", " | ".join(["defect", *programs, "urdfkit"]), "|")
    for name, (code, old, new) in DEFECTS.items():
        assert old in SOUND, name
        with tempfile.TemporaryDirectory() as directory:
            file = Path(directory, "robot.urdf")
            file.write_text(new.join(SOUND.rsplit(old, 1)), encoding="utf-8")
            reported = [
                verdict([word.format(str(file)) if "{!" in word else word for word in words])
                for words in programs.values()
            ]
            check = [sys.executable, "-m", "urdfkit", "check", "--isolated", "--select", code]
            found = subprocess.run([*check, str(file)], check=False, capture_output=True, text=True)
            reported.append(code if code in found.stdout else "silent")
        print("|", " | ".join([name, *reported]), "|")


if __name__ == "__main__":
    main()
