"""What urdfdom refuses, or reads with a hole in it, has an error; what it reads whole has none.

Every case is given to ``check_urdf``, so the verdicts are urdfdom's and not ours. Where urdfkit
differs on purpose, the reason stands beside the case.
"""

from pathlib import Path

import pytest

from tests.conftest import CorpusRobot, manifest, model_id, needs_corpus
from tests.urdfdom import needs_check_urdf, urdfdom
from urdfkit.lint import engine
from urdfkit.lint.context import Context
from urdfkit.text.diagnostic import Severity
from urdfkit.text.schema import JOINT_TYPES
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

INERTIA = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
SHAPE = '<geometry><box size="1 1 1"/></geometry>'


def robot(content: str, attributes: str = 'name="r"') -> str:
    return f"<robot {attributes}>{content}</robot>"


def visual(content: str) -> str:
    return robot(f'<link name="a"><visual>{content}</visual></link>')


def shape(content: str) -> str:
    return visual(f"<geometry>{content}</geometry>")


def inertial(content: str) -> str:
    return robot(f'<link name="a"><inertial>{content}</inertial></link>')


def joint(content: str = "", attributes: str = 'name="j" type="continuous"') -> str:
    ends = '<parent link="a"/><child link="b"/>'
    return robot(f'<link name="a"/><link name="b"/><joint {attributes}>{ends}{content}</joint>')


def revolute(**limits: str) -> str:
    values = {"lower": "-1", "upper": "1", "effort": "1", "velocity": "1", **limits}
    attributes = " ".join(f'{name}="{value}"' for name, value in values.items())
    return joint(f"<limit {attributes}/>", 'name="j" type="revolute"')


def joints(links: str, *pairs: str) -> str:
    text = "".join(f'<link name="{name}"/>' for name in links.split())
    for number, pair in enumerate(pairs):
        parent, child = pair.split()
        text += f'<joint name="j{number}" type="fixed"><parent link="{parent}"/>'
        text += f'<child link="{child}"/></joint>'
    return robot(text)


COLOUR = '<material name="m"><color rgba="{}"/></material>'

CASES = {
    "whole robot": joint('<origin xyz="0 0 1" rpy="0 0 0"/><axis xyz="0 0 1"/>'),
    "no name": robot('<link name="a"/>', ""),
    "version": robot('<link name="a"/>', 'name="r" version="1.0"'),
    "version with zeros": robot('<link name="a"/>', 'name="r" version="01.00"'),
    "version 2.0": robot('<link name="a"/>', 'name="r" version="2.0"'),
    "version without a point": robot('<link name="a"/>', 'name="r" version="1"'),
    "no version": robot('<link name="a"/>', 'name="r" version=""'),
    "no link": robot(""),
    "another format": '<sdf version="1.6"><model name="m"/></sdf>',
    "misspelt robot": '<robt name="r"><link name="a"/></robt>',
    "link without a name": robot("<link/>"),
    "joint without a name": joint("", 'type="fixed"'),
    "joint without a type": joint("", 'name="j"'),
    "joint without a parent": joint().replace('<parent link="a"/>', ""),
    "joint without a child": joint().replace('<child link="b"/>', ""),
    "parent without a link": joint().replace('parent link="a"', "parent"),
    "visual without a geometry": visual(""),
    "collision without a geometry": visual("").replace("visual", "collision"),
    "misspelt geometry": visual("<geometri/>"),
    "empty geometry": shape(""),
    "comment in a geometry": shape('<!-- box --><box size="1 1 1"/>'),
    "two shapes": shape('<box size="1 1 1"/><sphere radius="1"/>'),
    "misspelt shape": shape('<bx size="1 1 1"/>'),
    "capsule": shape('<capsule radius="1" length="1"/>'),
    "material in a geometry": shape('<box size="1 1 1"/><material name="m"/>'),
    "material before the shape": shape('<material name="m"/><box size="1 1 1"/>'),
    "box without a size": shape("<box/>"),
    "cylinder without a length": shape('<cylinder radius="1"/>'),
    "mesh without a filename": shape("<mesh/>"),
    **{
        f"size {text!r}": shape(f'<box size="{text}"/>')
        for text in (
            *("1 1", "1 1 1 1", "1, 1, 1", "0,5 1 1", "a b c", "nan 1 1", "inf 1 1", ""),
            *("1e400 1 1", "0x10 1 1", "+1 1. .5", "1e-400 1 1", " 1  1 1 ", "1\t1 1", "1 \t1 1"),
            *("1\n1\n1", "1.0f 1 1", "1_0 1 1", "1\u00a01 1", "1&#9;1 1"),
        )
    },
    **{
        f"radius {text!r}": shape(f'<sphere radius="{text}"/>')
        for text in (
            "1",
            " 1",
            "1 ",
            "1E+05",
            "1d5",
            "--1",
            "1 2",
            "",
            "1_0",
            "nan",
            "1.",
            "\u0661",
        )
    },
    **{
        f"scale {text!r}": shape(f'<mesh filename="package://p/a.stl" scale="{text}"/>')
        for text in ("1 1 1", "1", "1 1", "a", "")
    },
    **{
        f"xyz {text!r}": joint(f'<origin xyz="{text}"/>')
        for text in ("0 0 0", "0 0", "0 0 0 0", "0 0 a", "0,5 0 0", "")
    },
    **{f"axis {text!r}": joint(f'<axis xyz="{text}"/>') for text in ("0 0 1", "0 1", "", "0 0 z")},
    "origin without numbers": visual("<origin/>" + SHAPE),
    **{
        f"{kind} with {limit or 'nothing'}": joint(limit, f'name="j" type="{kind}"')
        for kind in (*JOINT_TYPES, "Revolute", "spherical")
        for limit in (
            "",
            '<limit lower="-1" upper="1" effort="1" velocity="1"/>',
            '<limit effort="1" velocity="1"/>',
            '<limit lower="-1" upper="1" effort="1"/>',
            '<limit lower="-1" upper="1" velocity="1"/>',
        )
    },
    "two origins": joint('<origin xyz="0 0 0"/><origin xyz="1 0 0"/>'),
    "dynamics without numbers": joint("<dynamics/>"),
    "damping": joint('<dynamics damping="x"/>'),
    "friction": joint('<dynamics friction="1"/>'),
    "mimic without a joint": joint("<mimic/>"),
    "multiplier": joint('<mimic joint="j" multiplier="x"/>'),
    "calibration": joint('<calibration rising="x"/>'),
    "calibration without numbers": joint("<calibration/>"),
    "reference position": joint('<calibration reference_position="x"/>'),
    "safety controller": joint('<safety_controller k_velocity="1"/>'),
    "safety controller without k_velocity": joint('<safety_controller k_position="1"/>'),
    "inertial": inertial(f'<mass value="1"/>{INERTIA}'),
    "inertial without a mass": inertial(INERTIA),
    "inertial without an inertia": inertial('<mass value="1"/>'),
    "mass without a value": inertial(f"<mass/>{INERTIA}"),
    "mass with a comma": inertial(f'<mass value="0,5"/>{INERTIA}'),
    "mass is not a number": inertial(f'<mass value="nan"/>{INERTIA}'),
    "inertia without ixy": inertial('<mass value="1"/>' + INERTIA.replace('ixy="0" ', "")),
    "two inertials": inertial(f'<mass value="1"/>{INERTIA}').replace(
        "</link>", f'<inertial><mass value="1"/>{INERTIA}</inertial></link>'
    ),
    "material without a name": visual(SHAPE + '<material><color rgba="1 1 1 1"/></material>'),
    "material with an empty name": visual(SHAPE + '<material name=""/>'),
    "colour": visual(SHAPE + COLOUR.format("1 1 1 1")),
    "colour in words": visual(SHAPE + COLOUR.format("a b c d")),
    "material twice": robot(COLOUR.format("1 1 1 1") * 2 + '<link name="a"/>'),
    "material in two visuals": visual(SHAPE + COLOUR.format("1 1 1 1")).replace(
        "</link>", f"<visual>{SHAPE}{COLOUR.format('0 1 1 1')}</visual></link>"
    ),
    "tree": joints("a b c d", "a b", "a c", "c d"),
    "link twice": robot('<link name="a"/><link name="a"/>'),
    "joint twice": joints("a b c", "a b", "a c").replace("j1", "j0"),
    "link and joint share a name": joint("", 'name="a" type="fixed"'),
    "two roots": joints("a b"),
    "cycle": joints("a b", "a b", "b a"),
    "cycle below the root": joints("r a b", "r a", "a b", "b a"),
    "joint to itself": joints("a b", "a b", "b b"),
    "unknown parent": joints("a b", "z b"),
    "unknown child": joints("a b", "a z"),
    "world is not declared": joints("b", "world b"),
    "world is declared": joints("world b", "world b"),
    "unknown elements": robot('<link name="a"><foo/></link><bar/>'),
    "unknown attribute": robot('<link name="a" foo="1"/>'),
    "white space in a name": robot('<link name="a b"/>'),
}

#: Errors on what urdfdom reads without a word, because of another mainstream reader.
STRICTER = {
    "axis of a fixed joint": (
        joint('<axis xyz="0 0 z"/>', 'name="j" type="fixed"'),
        "MuJoCo and yourdfpy refuse the file",
    ),
    "colour of three": (
        visual(SHAPE + COLOUR.format("1 1 1")),
        "black; MuJoCo and Drake refuse it",
    ),
    "colour without rgba": (
        visual(SHAPE + '<material name="m"><color/></material>'),
        "MuJoCo refuses it",
    ),
    "empty name of a link": (robot('<link name=""/>'), "TF, Drake and PyBullet refuse it"),
    "empty name of a joint": (joint("", 'name="" type="fixed"'), "PyBullet crashes"),
    "axis without xyz": (joint("<axis/>"), "read as 0 0 0; MuJoCo refuses it"),
    "zero axis": (joint('<axis xyz="0 0 0"/>'), "MuJoCo and Drake refuse it, Gazebo too"),
    "inverted limits": (revolute(lower="1", upper="-2"), "Drake ends, Gazebo swaps them"),
    "negative effort": (revolute(effort="-1"), "Pinocchio refuses it"),
    "negative velocity": (revolute(velocity="-1"), "Pinocchio refuses it, Drake ends"),
    "negative damping": (joint('<dynamics damping="-1"/>'), "Drake refuses it"),
    "negative friction": (joint('<dynamics friction="-1"/>'), "Pinocchio refuses it"),
    "a joint that mimics itself": (joint('<mimic joint="j"/>'), "MuJoCo and Drake refuse it"),
    "unknown leader": (joint('<mimic joint="z"/>'), "Drake refuses it, MoveIt drops it"),
    "loose cycle": (joints("r a b", "a b", "b a"), "lost; MuJoCo and Drake refuse it"),
    "two parents": (joints("a b c", "a b", "a c", "b c"), "MuJoCo refuses it, PyBullet crashes"),
    "misspelt inertial": (robot('<link name="a"><inertal/></link>'), "Gazebo leaves the link out"),
}

#: What this release of urdfdom refuses and newer ones read: a warning.
MILDER = {
    f"version {version}": robot('<link name="a"/>', f'name="r" version="{version}"')
    for version in ("1.1", "1.2")
}


def urdfdom_objects(text: str, directory: Path) -> bool:
    """True if urdfdom refuses the robot, logs an error about a part of it, or does not end."""
    code, words = urdfdom(text, directory)
    return code != 0 or "Error:" in words


def errors(text: str) -> list[str]:
    """The errors of the rules that look at the description alone."""
    report = engine.check(Source("robot.urdf", text.encode()), ignore=["MSH", "XAC011"])
    assert report.crashed == ()
    return [found.code for found in report.diagnostics if found.severity is Severity.ERROR]


@needs_check_urdf
@pytest.mark.parametrize("case", CASES)
def test_an_error_where_urdfdom_objects_and_none_elsewhere(case: str, tmp_path: Path) -> None:
    found = errors(CASES[case])
    assert bool(found) == urdfdom_objects(CASES[case], tmp_path), found


@needs_check_urdf
@pytest.mark.parametrize("case", STRICTER)
def test_stricter_where_another_reader_suffers(case: str, tmp_path: Path) -> None:
    text, _reason = STRICTER[case]
    assert not urdfdom_objects(text, tmp_path)
    assert len(errors(text)) == 1


@pytest.mark.parametrize("case", MILDER)
def test_milder_where_newer_releases_read_it(case: str) -> None:
    assert errors(MILDER[case]) == []


PLAIN = [entry for entry in manifest() if entry.facts["kind"] == "urdf"]


@needs_corpus
@pytest.mark.parametrize("entry", PLAIN, ids=model_id)
def test_the_corpus_has_errors_where_urdfdom_objects(entry: CorpusRobot) -> None:
    path = str(entry.path)
    context = Context(Source.read(path), Resolver())
    if context.reading.document and context.is_part:
        pytest.skip("made for another file to include, and no robot by itself")
    files = ["MSH", "XAC011"]  # of meshes and packages, which check_urdf does not open
    report = engine.check(path, ignore=[*files, "INE", "GEO", "JNT", "GAZ", "RCT", "SRD"])
    found = {one.code for one in report.diagnostics if one.severity is Severity.ERROR}
    assert bool(found) == (entry.facts["expect"]["check_urdf"] != "ok"), found
