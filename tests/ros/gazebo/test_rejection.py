"""Robots that Gazebo rejects, as libsdformat 12.3 says where it is installed."""

import subprocess
from pathlib import Path

import pytest

from tests.gazebos import BASE, BODY, block, child
from tests.gz_sdf import program
from urdfkit.lint.context import Context
from urdfkit.lint.runner import run_rules
from urdfkit.ros.gazebo.conversion import NEW, OLD, Converter, SdfConversion
from urdfkit.ros.gazebo.rejection import CODES, rejections
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

ARM = child("arm", "revolute")
WITHOUT_MASS = '<link name="base"/>'


def inertia(ixx: float, rest: float) -> str:
    return (
        f'<inertial><mass value="1"/><inertia ixx="{ixx}" iyy="{rest}" izz="{rest}" '
        'ixy="0" ixz="0" iyz="0"/></inertial>'
    )


def sdf_joint(parent: str, called: str = "x") -> str:
    ends = f"<parent>{parent}</parent><child>hand</child>"
    return f'<gazebo><joint name="{called}" type="fixed">{ends}</joint></gazebo>'


FIXED = child("arm", "fixed") + child("hand", "revolute", parent="arm")

LIGHT = child("arm", "revolute", inside="") + child("hand", "fixed", parent="arm", inside="")

#: Parts of a robot, and the codes for which newer versions reject it.
ROBOTS = {
    "sound": (BASE + ARM, []),
    "no number": (BASE + ARM + block("<mu1>abc</mu1>"), ["GAZ004"]),
    "reserved link": (BASE.replace("base", "__b__"), ["NAM004"]),
    "reserved joint": (BASE + ARM.replace("arm_joint", "__j__"), ["NAM004"]),
    "joint called world": (BASE + ARM.replace("arm_joint", "world"), ["NAM004"]),
    "child called world": (BASE + child("world", "revolute"), ["NAM004"]),
    "root called world": (BASE.replace("base", "world") + ARM.replace("base", "world"), []),
    "one name": (BASE + ARM.replace("arm_joint", "arm"), ["NAM003"]),
    "one name, merged": (BASE + child("arm", "fixed").replace("arm_joint", "arm"), ["NAM003"]),
    "name of a merged link": (BASE + FIXED.replace("hand_joint", "arm"), ["NAM003"]),
    "merged into what is dropped": (BASE + LIGHT, ["INE004"]),
    "flat beyond a disk": (BASE + child("arm", "revolute", inside=inertia(1, 0.1)), ["INE003"]),
    "negative moment": (BASE + child("arm", "revolute", inside=inertia(-1, 1)), ["INE003"]),
    "disk": (BASE + child("arm", "revolute", inside=inertia(0.2, 0.1)), []),
    "merged": (BASE + child("arm", "fixed", inside=inertia(1, 0.1)), ["INE003"]),
    "negative mass": (
        BASE + child("arm", "revolute", inside=BODY.replace('value="1"', 'value="-1"')),
        ["INE001"],
    ),
    "no mass": (WITHOUT_MASS, ["INE004"]),
    "merged frames without mass": (
        BASE
        + child("arm", "fixed", inside=BODY.replace('value="1"', 'value="0"'))
        + child("hand", "fixed", parent="arm", inside=BODY.replace('value="1"', 'value="0"')),
        ["INE004"],
    ),
    "a merged frame without mass": (
        BASE + child("arm", "fixed", inside=BODY.replace('value="1"', 'value="0"')),
        [],
    ),
    "joint of a merged link": (BASE + FIXED + sdf_joint("arm"), []),
    "joint of a link": (BASE + FIXED + sdf_joint("base"), []),
    "joint twice": (BASE + FIXED + sdf_joint("base", "hand_joint"), [""]),
    "floating": (BASE + child("arm", "floating"), ["JNT022"]),
    "frame of the name": (BASE + block('<frame name="base"/>', ""), [""]),
    "unknown leader": (BASE + ARM.replace("<limit", '<mimic joint="none"/><limit'), []),
}


#: The first version with frames of merged links.
FRAMES = (12, 7, 0)
#: The codes of versions without frames of merged links, where they differ.
BEFORE = {
    "one name, merged": [],
    "name of a merged link": [],
    "merged into what is dropped": [],
    "joint of a merged link": ["GAZ067"],
}


@pytest.mark.parametrize("converter", [OLD, NEW])
@pytest.mark.parametrize("name", ROBOTS)
def test_the_reason_of_a_rejection(name: str, converter: Converter) -> None:
    parts, codes = ROBOTS[name]
    source = Source("r.urdf", f'<robot name="r">{parts}</robot>'.encode())
    context = Context(source, Resolver())
    diagnostics = run_rules(context, sorted(CODES)).diagnostics
    found = rejections(diagnostics, SdfConversion(context.tree, converter))
    assert sorted({one.code for one in found}) == (codes if converter is NEW else _old(name))


def test_the_massless_link_is_named() -> None:
    arm = '<robot name="r"><link name="mount"/>' + child("arm", "revolute", parent="mount")
    context = Context(Source("r.urdf", f"{arm}</robot>".encode()), Resolver())
    (found,) = rejections([], context.gazebo)
    assert found.message.startswith("link 'mount' has no mass")


def _old(name: str) -> list[str]:
    return BEFORE.get(name, ROBOTS[name][1])


@pytest.mark.parametrize("name", ROBOTS)
def test_libsdformat_agrees(name: str, tmp_path: Path) -> None:
    path, version = program()
    parts = ROBOTS[name][0]
    codes = _old(name) if version < FRAMES else ROBOTS[name][1]
    file = tmp_path / "r.urdf"
    file.write_text(f'<robot name="r">{parts}</robot>')
    done = subprocess.run(
        [path, "sdf", "-k", str(file)], capture_output=True, text=True, check=False
    )
    assert ("Valid." in done.stdout) is not bool(codes)
