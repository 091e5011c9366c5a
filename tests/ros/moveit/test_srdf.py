"""Finding an SRDF, and MoveIt's real ones."""

from pathlib import Path

import pytest

from tests.conftest import CORPUS, needs_corpus
from tests.documents import document
from tests.srdfs import ROBOT
from tests.workspaces import add_file, add_files
from urdfkit import check
from urdfkit.core import disk
from urdfkit.core.file_log import FileLog
from urdfkit.lint.context import Context
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.ros.moveit.srdf_reader import find
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.srdf_files import srdf_files


def test_it_is_found_in_the_package_and_in_the_moveit_package_made_for_the_robot(tmp_path):
    robots, moveit, other = (
        tmp_path / name for name in ("arm", "arm_moveit_config", "b_moveit_config")
    )
    for directory in (robots / "urdf", robots / "config", moveit / "config", other / "config"):
        directory.mkdir(parents=True)
    for package in (robots, moveit, other):
        (package / "package.xml").write_text(f"<package><name>{package.name}</name></package>")
    robot = robots / "urdf" / "r.urdf"
    robot.write_text(ROBOT)
    for place in (robots / "config", moveit / "config", other / "config"):
        (place / "r.srdf").write_text('<robot name="r"/>')
    setup = (
        "moveit_setup_assistant_config:\n  URDF:\n    package: {}\n    relative_path: urdf/r.urdf\n"
    )
    (moveit / ".setup_assistant").write_text(setup.format("arm"))
    (other / ".setup_assistant").write_text(setup.format("b"))
    assert srdf_files(str(robot), Resolver(environment={})) == [
        str(robots / "config" / "r.srdf"),
        str(moveit / "config" / "r.srdf"),
    ]


@pytest.mark.parametrize(
    ("text", "codes"), [("", ["SRD017"]), ("<robot", ["SRD017"]), ("<srdf/>", [])]
)
def test_what_cannot_be_read_is_no_srdf(tmp_path, text, codes):
    (tmp_path / "r.urdf").write_text(ROBOT)
    (tmp_path / "r.srdf").write_text(text)
    report = check(tmp_path / "r.urdf", select=["SRD"])
    assert [found.code for found in report.diagnostics] == codes


@pytest.mark.parametrize(
    ("names", "chosen"),
    [
        (["r"], "a.srdf"),
        (["other"], "a.srdf"),  # SRD011 tells that it has another name
        (["other", "r"], "b.srdf"),
        (["other", "another"], None),
        (["r", "r"], None),
        (["r", "other", "r"], None),
    ],
)
def test_of_several_the_one_with_the_name_of_the_robot_is_meant(tmp_path, names, chosen):
    robot = tmp_path / "r.urdf"
    robot.write_text(ROBOT)
    for letter, name in zip("abc", names, strict=False):
        (tmp_path / f"{letter}.srdf").write_text(f'<robot name="{name}"/>')
    resolver = Resolver(environment={})
    found = find(Context(Source.read(robot), resolver))
    assert (found and Path(found.path).name) == chosen


@pytest.mark.parametrize(
    ("file", "is_found"), [("part.xacro", True), ("r.urdf", True), ("other.xacro", False)]
)
def test_the_file_that_the_assistant_read(tmp_path: Path, file: str, is_found: bool) -> None:
    """A part, which a file with plugins and sensors includes, or the URDF that xacro made."""
    add_files(
        tmp_path,
        {
            "LICENSE": "",
            "arm/package.xml": "<package><name>arm</name></package>",
            "arm/urdf/part.xacro": ROBOT,
            "arm/urdf/r.urdf.xacro": '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
            '<xacro:include filename="part.xacro"/></robot>',
            "arm_moveit/package.xml": "<package><name>arm_moveit</name></package>",
            "arm_moveit/.setup_assistant": SETUP.replace("r.urdf", file).format(""),
            "arm_moveit/config/r/r.srdf": '<robot name="r"><passive_joint name="wrist"/></robot>',
        },
    )
    robot = Source.read(tmp_path / "arm" / "urdf" / "r.urdf.xacro")
    assert (find(Context(robot, Resolver(environment={}))) is not None) == is_found


def test_the_xacro_of_an_srdf(tmp_path: Path) -> None:
    robot = tmp_path / "r.urdf"
    robot.write_text(ROBOT)
    for name in ("panda.srdf", "panda.srdf.xacro"):
        (tmp_path / name).write_text('<robot name="r"><passive_joint name="wrist"/></robot>')
    found = find(Context(Source.read(robot), Resolver(environment={})))
    assert found
    assert Path(found.path).name == "panda.srdf.xacro"


def test_of_several_of_one_name_the_one_called_like_the_file_is_meant(tmp_path: Path) -> None:
    robot = tmp_path / "panda.urdf"
    robot.write_text(ROBOT)
    for name in ("panda", "panda_arm"):
        (tmp_path / f"{name}.srdf").write_text('<robot name="r"/>')
    resolver = Resolver(environment={})
    found = find(Context(Source.read(robot), resolver))
    assert found
    assert Path(found.path).name == "panda.srdf"


def srdf(text: str) -> Srdf:
    context = Context(Source("r.urdf", ROBOT.encode()), Resolver(environment={}))
    return Srdf("r.srdf", document(text).root, context.tree)


def test_of_very_many_only_those_with_the_name_of_the_robot_are_read(tmp_path: Path) -> None:
    """tiago_dual_moveit_config has 579 SRDFs of 200 kB, one for each pair of hands."""
    robot = tmp_path / "panda.urdf"
    robot.write_text(ROBOT)
    for name in ("panda", *(f"panda_{number}" for number in range(40))):
        (tmp_path / f"{name}.srdf").write_text('<robot name="r"/>')
    context = Context(Source.read(robot), Resolver(environment={}))
    log = FileLog()
    disk.log_to(log)
    try:
        found = find(context)
    finally:
        disk.log_to(None)
    assert found
    assert Path(found.path).name == "panda.srdf"
    read = {path for kind, path in log.answers if kind.startswith("r") and path.endswith(".srdf")}
    assert read == {found.path}


def test_a_way_goes_down_the_tree():
    robot = srdf("<robot name='r'/>")
    assert [joint.name for joint in robot.joints_between("base", "finger") or ()] == [
        "shoulder", "wrist", "knuckle",
    ]  # fmt: skip
    assert robot.joints_between("finger", "base") is None
    assert robot.joints_between("arm", "arm") == []


def test_the_links_of_a_group_come_from_all_its_parts():
    text = """<robot name='r'>
      <group name='a'><chain base_link='base' tip_link='arm'/><group name='b'/></group>
      <group name='b'><joint name='wrist'/><link name='finger'/><group name='a'/></group>
    </robot>"""
    assert srdf(text).links_of("a") == {"arm", "hand", "finger"}


@needs_corpus
@pytest.mark.parametrize(
    ("robot", "semantic"),
    [
        ("fanuc_description/urdf/fanuc.urdf", "fanuc_moveit_config/config/fanuc.srdf"),
        ("panda_description/urdf/panda.urdf", "panda_moveit_config/config/panda.srdf"),
    ],
)
def test_moveits_own_robots_are_calm(tmp_path: Path, robot: str, semantic: str):
    directory = CORPUS / "moveit_resources"
    copied = tmp_path / Path(robot).name
    copied.write_bytes((directory / robot).read_bytes())
    (tmp_path / "robot.srdf").write_bytes((directory / semantic).read_bytes())
    report = check(copied, select=["SRD"])
    assert report.diagnostics == ()
    context = Context(Source.read(copied), Resolver(environment={}))
    assert context.srdf is not None


def test_an_srdf_of_another_robot_in_the_package_is_not_the_robots(tmp_path):
    (tmp_path / "r.urdf").write_text(ROBOT)
    hand = "".join(f'<link name="finger_{i}"/>' for i in range(8))
    group = f'<robot name="hand"><group name="all">{hand}{{}}</group></robot>'
    (tmp_path / "hand.srdf").write_text(group.format(""))
    assert check(tmp_path / "r.urdf", select=["SRD"]).diagnostics == ()
    (tmp_path / "hand.srdf").write_text(group.format('<joint name="wrist"/>' * 8))
    codes = [found.code for found in check(tmp_path / "r.urdf", select=["SRD"]).diagnostics]
    assert sorted(codes) == ["SRD001"] * 8 + ["SRD011"]


SETUP = """\
moveit_setup_assistant_config:
  urdf:
    package: arm
    relative_path: urdf/r.urdf{}
  srdf:
    relative_path: config/r/r.srdf
"""
ARGUMENTS = "\n    xacro_args: side:=left"


@pytest.mark.parametrize(
    ("place", "setup", "srdf", "is_found"),
    [
        ("arm_moveit_config/config/r", SETUP.format(""), "", True),
        ("arm_moveit_config/config/r", SETUP.format(ARGUMENTS), "", True),
        ("arm_moveit_config/config/r", SETUP.replace("r.urdf", "s.urdf").format(""), "", False),
        # the file was moved after the assistant ran
        ("arm_moveit_config/config/r", SETUP.replace("r/r.srdf", "r.srdf").format(""), "", True),
        # the package was renamed after the assistant ran
        ("arm_moveit_config/config/r", SETUP.replace("arm", "leg").format(""), "", True),
        ("all_moveit/config/r", "", "", True),
        ("all_moveit_configs/arm_moveit_config/config", "", "", True),
        ("arm_moveit/srdf", "", "", True),
        ("arm_moveit/srdf", "", '<group name="a"><link name="bsae"/></group>', True),
        ("arm_moveit/srdf", "", '<group name="a"><link name="x"/><link name="y"/></group>', False),
        ("arm_planning/srdf", "", "", False),
        # in another repository of the workspace
        ("stack/arm_moveit_config/config/r", SETUP.format(""), "", True),
        ("stack/arm_moveit_config/config/r", SETUP.replace("arm", "leg").format(""), "", False),
        ("stack/arm_moveit_config/config/r", "", "", False),
    ],
)
def test_srdf_of_the_packages_of_moveit(tmp_path, place, setup, srdf, is_found):
    package = tmp_path / "arm"
    (package / "urdf").mkdir(parents=True)
    (tmp_path / "LICENSE").touch()
    robot = package / "urdf" / "r.urdf"
    robot.write_text(ROBOT)
    (tmp_path / place).mkdir(parents=True)
    first, second, *_ = place.split("/")
    home = tmp_path / first / second if "moveit" in second else tmp_path / first
    for directory in (package, home):
        (directory / "package.xml").write_text(f"<package><name>{directory.name}</name></package>")
    if setup:
        (home / ".setup_assistant").write_text(setup)
    known = "".join(f'<passive_joint name="{name}"/>' for name in ("shoulder", "wrist", "knuckle"))
    (tmp_path / place / "r.srdf").write_text(f'<robot name="r">{known}{srdf}</robot>')
    resolver = Resolver(environment={})
    found = find(Context(Source.read(robot), resolver))
    assert (found is not None) is is_found


@pytest.mark.parametrize(("loads", "is_found"), [("r.urdf", True), ("other.urdf", False)])
def test_srdf_that_a_launch_file_loads_with_the_robot(
    tmp_path: Path, loads: str, is_found: bool
) -> None:
    """Elfin's launch files read both files; the SRDF has the name of a shorter arm."""
    for name in ("arm", "arm_moveit"):
        add_file(
            tmp_path / name / "package.xml", b"<package><name>%b</name></package>" % name.encode()
        )
    robot = add_file(tmp_path / "arm" / "urdf" / "r.urdf", ROBOT.encode())
    home = tmp_path / "arm_moveit"
    add_file(home / "config" / "long.srdf", b'<robot name="short"><group name="a"/></robot>')
    texts = f'urdf, srdf = load("{loads}"), load("long.srdf")\n'
    add_file(home / "launch" / "demo.launch.py", texts.encode())
    found = find(Context(Source.read(robot), Resolver(environment={})))
    assert (found is not None) is is_found
