"""What MuJoCo rejects has an error with ``--target mujoco``, and what it takes has none."""

from collections.abc import Mapping
from pathlib import Path

import pytest

from tests.consumers.reading import read
from tests.mesh import made
from tests.meshed import SOUND, mesh
from urdfkit.lint import engine
from urdfkit.mesh.samples import box, stl
from urdfkit.text.diagnostic import Severity

BOX = '<geometry><box size="1 1 1"/></geometry>'
COLLISION = f"<collision>{BOX}</collision>"
SQUARE, FLAT = BOX.replace("1 1 1", "1 1"), BOX.replace("1 1 1", "0 1 1")
BOUNDED = '<compiler boundmass="1e-3" boundinertia="1e-6"/>'
PLATE = stl([[(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0), (0, 1, 0)]])
NUMBER = "URD005"
STRIPPED = '<mujoco><compiler strippath="true"/></mujoco>'


def link(name: str, mass: object = 1, moments: str = "1 1 1", more: str = "") -> str:
    ixx, iyy, izz = moments.split()
    tensor = f'ixx="{ixx}" iyy="{iyy}" izz="{izz}" ixy="0" ixz="0" iyz="0"'
    return (
        f'<link name="{name}"><inertial><mass value="{mass}"/><inertia {tensor}/></inertial>'
        f"{more}</link>"
    )


def arm(child: str, kind: str = "continuous", more: str = "", base: str = link("base")) -> str:
    """A base, and a link ``arm`` that a joint holds."""
    joint = f'<joint name="j" type="{kind}"><parent link="base"/><child link="arm"/>{more}</joint>'
    return base + child + joint


def fixed(child: str) -> str:
    """A link ``tool`` that is fixed to a moving one."""
    joint = '<joint name="k" type="fixed"><parent link="arm"/><child link="tool"/></joint>'
    return arm(link("arm")) + child + joint


def told(text: str) -> str:
    """What MuJoCo alone reads of a robot, before the rest of it."""
    return f"<mujoco>{text}</mujoco>"


#: The inside of a robot, and the rule whose error says why MuJoCo rejects it; none if it does not.
CASES = {
    "sound": (arm(link("arm")), ""),
    "equal limits": (arm(link("arm"), "revolute", '<limit lower="1" upper="1"/>'), ""),
    "no mass": (arm('<link name="arm"/>'), "INE004"),
    "mass from a collision": (arm(f'<link name="arm">{COLLISION}</link>'), ""),
    "mass from a fixed link": (
        arm('<link name="arm"/>')
        + f'<link name="tool">{COLLISION}</link><joint name="k" type="fixed">'
        '<parent link="arm"/><child link="tool"/></joint>',
        "",
    ),
    "mass of 0": (arm(link("arm", 0, "0 0 0", COLLISION)), "INE001"),
    "no mass anywhere": (arm('<link name="arm"/>', base='<link name="base"/>'), "INE004"),
    "mass that is given": (told(BOUNDED) + arm('<link name="arm"/>'), ""),
    "no inertia": (arm(link("arm", 1, "0 0 0")), "INE005"),
    "moment of 0": (arm(link("arm", 1, "1 1 0")), "INE005"),
    "moment of 0, fixed": (fixed(link("tool", 1, "1 1 0")), "INE005"),
    "moment of 0 without mass": (fixed(link("tool", 0, "1 1 0")), "INE005"),
    "no inertia, fixed": (fixed(link("tool", 1, "0 0 0")), ""),
    "small moments": (arm(link("arm", 1, "1e-13 1e-13 1e-13")), ""),
    "too small moments": (arm(link("arm", 1, "3e-15 3e-15 3e-15")), "INE005"),
    "thin plate": (arm(link("arm", 1, "0.1 0.2 0.3")), ""),
    "rounded plate": (arm(link("arm", 1, "0.1 0.2 0.3001")), "INE003"),
    "triangle inequality": (arm(link("arm", 1, "0.1 0.2 0.5")), "INE003"),
    "moments that are balanced": (
        told('<compiler balanceinertia="true"/>') + arm(link("arm", 1, "0.1 0.2 0.5")),
        "",
    ),
    "two geometries": (f'<link name="a"><collision>{BOX}{BOX}</collision></link>', "URD007"),
    "two geometries in a visual": (f'<link name="a"><visual>{BOX}{BOX}</visual></link>', ""),
    "two materials": (
        f'<link name="a"><visual>{BOX}<material name="x"/><material name="x"/></visual></link>',
        "URD007",
    ),
    "two origins": (arm(link("arm"), "fixed", "<origin/><origin/>"), "URD007"),
    "two limits": (arm(link("arm"), "continuous", "<limit/><limit/>"), "URD007"),
    "two limits, fixed": (arm(link("arm"), "fixed", "<limit/><limit/>"), ""),
    "two calibrations": (arm(link("arm"), "continuous", "<calibration/><calibration/>"), ""),
    "two settings": (told("") + told("") + link("a"), "URD007"),
    "visual without a size": (f'<link name="a"><visual>{SQUARE}</visual></link>', ""),
    "collision without a size": (f'<link name="a"><collision>{SQUARE}</collision></link>', NUMBER),
    "visual of size 0": (f'<link name="a"><visual>{FLAT}</visual></link>', ""),
    "collision of size 0": (f'<link name="a"><collision>{FLAT}</collision></link>', "GEO001"),
    "two roots": (link("a") + link("b"), ""),
    "limits the wrong way round": (
        arm(link("arm"), "revolute", '<limit lower="1" upper="-1"/>'),
        "",
    ),
    "one joint twice": (arm(link("arm")) + arm("", base=""), "NAM001"),
    "a mimic of nothing": (arm(link("arm"), "continuous", '<mimic joint="k"/>'), ""),
    "hexadecimal": (link("a", more=COLLISION.replace("1 1 1", "0x1p-3 1 1")), ""),
    "white space": (arm(link("arm", " 1 ")), ""),
    "endless limits": (arm(link("arm"), "revolute", '<limit lower="-inf" upper="inf"/>'), ""),
    "floating": (arm(link("arm"), "floating"), ""),
    "floating on a fixed link": (
        '<link name="root"/><joint name="i" type="fixed"><parent link="root"/><child link="base"/>'
        "</joint>" + arm(link("arm"), "floating"),
        "",
    ),
    "floating on a fixed link that is not merged": (
        told('<compiler fusestatic="false"/>') + arm(link("arm"), "floating"),
        "JNT045",
    ),
    "floating on a moving link": (
        arm(link("arm")) + link("tool") + '<joint name="k" type="floating"><parent link="arm"/>'
        '<child link="tool"/></joint>',
        "JNT045",
    ),
    "ball joint": (arm(link("arm"), "spherical", '<limit lower="0" upper="1"/>'), ""),
    "ball joint to both sides": (
        arm(link("arm"), "spherical", '<limit lower="-1" upper="1"/>'),
        "JNT045",
    ),
    "ball joint with a lower limit": (arm(link("arm"), "spherical", '<limit lower="-1"/>'), ""),
    "range without autolimits": (
        told('<compiler autolimits="false"/>')
        + arm(link("arm"), "planar", '<limit lower="-1" upper="1"/>'),
        "JNT045",
    ),
    "effort without autolimits": (
        told('<compiler autolimits="false"/>') + arm(link("arm"), more='<limit effort="1"/>'),
        "JNT045",
    ),
    "no range without autolimits": (
        told('<compiler autolimits="false"/>')
        + arm(link("arm"), more='<limit lower="-1" upper="1"/>'),
        "",
    ),
    "colour of three numbers": (
        '<material name="m"><color rgba="1 1 1"/></material>' + link("a"),
        NUMBER,
    ),
}  # fmt: skip

#: The same of robots with the mesh ``a``.
MESHES: dict[str, tuple[str, str, bytes, str]] = {
    "STL": ("", "a.stl", SOUND, ""),
    "ASCII STL": ("", "a.stl", made.ascii_stl(), "MSH007"),
    "COLLADA": ("", "a.dae", made.collada(), "MSH007"),
    "package": ("", "package://arm/a.stl", SOUND, "MSH039"),
    "package that is stripped": (STRIPPED, "package://arm/a.stl", SOUND, ""),
    "another directory": (told('<compiler meshdir="meshes"/>'), "a.stl", SOUND, "MSH039"),
    "flat": ("", "a.stl", PLATE, "MSH015"),
    "tiny": ("", 'a.stl" scale="1e-5 1e-5 1e-5', SOUND, "MSH015"),
    "200 000 triangles": ("", "a.stl", stl(box((0, 0, 0), (1, 1, 1)), copies=16667), "MSH019"),
}  # fmt: skip


def errors(robot: str, folder: Path, files: Mapping[str, bytes]) -> set[str]:
    for name, data in files.items():
        folder.joinpath(name).write_bytes(data)
    path = folder / "robot.urdf"
    path.write_text(robot, encoding="utf-8")
    report = engine.check(path, targets=["mujoco"])
    assert report.crashed == ()
    return {one.code for one in report.diagnostics if one.severity is Severity.ERROR}


def whole(inside: str) -> str:
    return f'<robot name="r">{inside}</robot>'


@pytest.mark.parametrize("case", CASES)
def test_errors(case: str, tmp_path: Path) -> None:
    robot, code = CASES[case]
    assert errors(whole(robot), tmp_path, {}) == ({code} if code else set())


@pytest.mark.parametrize("case", CASES)
def test_refusals(case: str, tmp_path: Path) -> None:
    pytest.importorskip("mujoco")
    robot, code = CASES[case]
    assert isinstance(read("mujoco", whole(robot).encode(), tmp_path), str) == bool(code)


@pytest.mark.parametrize("case", MESHES)
def test_meshes(case: str, tmp_path: Path) -> None:
    settings, name, data, code = MESHES[case]
    robot = whole(settings + link("base", more=mesh(name)))
    file = name.rpartition("/")[2].partition('"')[0]
    files = {"package.xml": b"<package><name>arm</name></package>", file: data}
    found = errors(robot, tmp_path, files)
    assert code in found if code else found == set()


@pytest.mark.parametrize("case", MESHES)
def test_refusals_of_meshes(case: str, tmp_path: Path) -> None:
    mujoco = pytest.importorskip("mujoco")
    settings, name, data, code = MESHES[case]
    file = name.rpartition("/")[2].partition('"')[0]
    tmp_path.joinpath(file).write_bytes(data)
    path = tmp_path / "robot.urdf"
    path.write_text(whole(settings + link("base", more=mesh(name))), encoding="utf-8")
    if code:
        with pytest.raises(ValueError, match=r"\w"):
            mujoco.MjModel.from_xml_path(str(path))
    else:
        mujoco.MjModel.from_xml_path(str(path))


@pytest.mark.parametrize(("scale", "code"), [("1 1 1", ""), ("1e-5 1e-5 1e-5", "MSH015")])
@pytest.mark.parametrize("is_kept", [True, False])
def test_visuals_that_are_kept(scale: str, code: str, is_kept: bool, tmp_path: Path) -> None:
    settings = told('<compiler discardvisual="false"/>') if is_kept else ""
    visual = mesh("a.stl", "visual", f' scale="{scale}"')
    robot = whole(settings + link("base", more=visual))
    found = errors(robot, tmp_path, {"a.stl": SOUND})
    assert found == ({code} if code and is_kept else set())
    flat = whole(settings + link("base", more=mesh("flat.stl", "visual")))
    assert errors(flat, tmp_path, {"flat.stl": PLATE}) == ({"MSH015"} if is_kept else set())
