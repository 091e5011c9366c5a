"""Entry points by the include graph, and the robots that a changed file is part of."""

import tracemalloc
from pathlib import Path

import pytest

from urdfkit import check
from urdfkit.errors import UnreadableFile
from urdfkit.lint.config import Config, RobotEntry
from urdfkit.lint.discovery import affected, discover
from urdfkit.lint.options import Options
from urdfkit.text import source
from urdfkit.workspace.resolve import Resolver

HEAD = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'


def write(directory: Path, name: str, body: str) -> str:
    path = directory / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"{HEAD}\n{body}\n</robot>\n")
    return str(path)


CART = """<link name="base"/><link name="wheel"/>
<joint name="axle" type="continuous"><parent link="base"/><child link="wheel"/></joint>"""
LAUNCH = """<launch>
<param name="robot_description" command="xacro $(find pkg)/urdf/cart.xacro"/>
<rosparam file="$(find pkg)/c.yaml"/>
</launch>"""


def include(name: str) -> str:
    return f'<xacro:include filename="{name}"/>'


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """Two robots, a macro file that one includes through another, and a lonely library."""
    (tmp_path / "package.xml").write_text("<package><name>pkg</name></package>")
    write(tmp_path, "urdf/arm.xacro", include("$(find pkg)/urdf/parts/rod.xacro") + "<xacro:rod/>")
    write(tmp_path, "urdf/parts/rod.xacro", include("units.xacro") + '<xacro:macro name="rod"/>')
    write(tmp_path, "urdf/parts/units.xacro", '<xacro:property name="mm" value="0.001"/>')
    write(tmp_path, "urdf/base.urdf", '<link name="base"/>')
    write(tmp_path, "urdf/lonely.xacro", '<xacro:macro name="x"><link name="x"/></xacro:macro>')
    write(tmp_path, "build/copy.urdf", '<link name="copy"/>')
    (tmp_path / "urdf/notes.xacro").write_text("<notes/>")
    return tmp_path


def names(found) -> list[str]:
    return [Path(robot.file).name for robot in found.robots]


def test_robots_are_what_nobody_includes(package):
    found = discover(str(package), Config(), Resolver())
    assert names(found) == ["arm.xacro", "base.urdf"]
    assert [Path(path).name for path in found.libraries] == ["lonely.xacro"]


@pytest.mark.parametrize(
    ("changed", "expected"),
    [
        ("urdf/parts/units.xacro", ["arm.xacro"]),
        ("urdf/base.urdf", ["base.urdf"]),
        ("package.xml", ["arm.xacro", "base.urdf"]),
        ("meshes/a.stl", ["arm.xacro", "base.urdf"]),
    ],
)
def test_a_changed_file_leads_to_the_robots_it_is_part_of(package, changed, expected):
    found = affected([str(package / changed)], Config(), Resolver())
    assert names(found) == expected


def test_several_changed_files_lead_to_each_robot_once(package):
    files = [str(package / name) for name in ("urdf/arm.xacro", "urdf/parts/rod.xacro")]
    assert names(affected(files, Config(), Resolver())) == ["arm.xacro"]


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    """A repository of three packages: a robot, the parts it is made of, and settings for it."""
    (tmp_path / ".git").mkdir()
    for name in ("robot", "parts", "settings", "other"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").write_text(f"<package><name>{name}</name></package>")
    write(
        tmp_path, "parts/urdf/rod.xacro", '<xacro:macro name="rod"><link name="r"/></xacro:macro>'
    )
    write(tmp_path, "parts/urdf/sim.gazebo", '<gazebo reference="r"/>')
    write(
        tmp_path,
        "robot/urdf/robot.xacro",
        include("$(find parts)/urdf/rod.xacro")
        + include("$(find parts)/urdf/sim.gazebo")
        + '<xacro:rod/><link name="l"><visual><geometry>'
        '<mesh filename="package://parts/meshes/rod.stl"/></geometry></visual></link>',
    )
    write(tmp_path, "other/urdf/other.urdf", '<link name="o"/>')
    return tmp_path


@pytest.mark.parametrize(
    ("changed", "expected"),
    [
        ("parts/urdf/rod.xacro", ["robot.xacro"]),  # of another package
        ("parts/urdf/sim.gazebo", ["robot.xacro"]),  # whatever its suffix
        ("parts/meshes/rod.stl", ["robot.xacro"]),  # named by the robot
        ("parts/meshes/new.stl", []),
        ("robot/config/new.yaml", ["robot.xacro"]),  # of the same package
        ("settings/config/limits.yaml", []),  # of a package without robots
        ("notes/new.yaml", []),  # of none
        ("gone/with/its/directory.xacro", []),
        (".github/workflows/ci.yml", []),
        ("robot/.vscode/settings.yaml", []),
        ("other/urdf/other.urdf", ["other.urdf"]),
    ],
)
def test_robots_are_found_all_over_the_repository(repository, changed, expected):
    found = affected([str(repository / changed)], Config(), Resolver())
    assert names(found) == expected
    assert found.libraries == ()


def test_nothing_to_check_is_no_mistake(repository):
    report = check(repository / "settings" / "x.yaml", options=Options(changed=True))
    assert (report.files, report.diagnostics, report.exit_code()) == ((), (), 0)


def test_a_library_that_nobody_includes_is_told(repository):
    path = write(repository, "parts/urdf/new.xacro", '<xacro:macro name="new"/>')
    found = affected([path], Config(), Resolver())
    assert found.robots == ()
    assert found.libraries == (path,)


def test_a_configuration_of_one_package_does_not_hide_the_others(repository):
    robot = str(repository / "robot" / "urdf" / "robot.xacro")
    variants = tuple(RobotEntry(robot, name, {}) for name in ("a", "b"))
    config = Config(str(repository / "robot" / "urdfkit.toml"), robots=variants)
    changed = [robot, str(repository / "other" / "urdf" / "other.urdf")]
    found = affected(changed, config, Resolver())
    assert [(Path(r.file).name, r.name) for r in found.robots] == [
        ("other.urdf", ""),
        ("robot.xacro", "a"),
        ("robot.xacro", "b"),
    ]


def test_an_included_file_that_is_gone_leads_to_its_robot(repository):
    (repository / "parts" / "urdf" / "rod.xacro").unlink()
    found = affected([str(repository / "parts" / "urdf" / "rod.xacro")], Config(), Resolver())
    assert names(found) == ["robot.xacro"]


def test_an_expression_in_a_name_stands_for_the_files_it_may_mean(tmp_path):
    write(tmp_path, "robot.xacro", include("${kind}_wheel.xacro") + '<link name="a"/>')
    write(tmp_path, "big_wheel.xacro", '<link name="w"/>')
    write(tmp_path, "small_wheel.xacro", '<link name="w"/>')
    write(tmp_path, "other.xacro", '<link name="o"/>')
    assert names(discover(str(tmp_path), Config(), Resolver())) == ["other.xacro", "robot.xacro"]


@pytest.mark.parametrize("pattern", ["wheel_?.xacro", "wheel_[ab].xacro", "wheel*.xacro"])
def test_a_pattern_stands_for_the_files_that_it_matches(tmp_path, pattern):
    write(tmp_path, "robot.xacro", include(pattern) + '<link name="a"/>')
    write(tmp_path, "wheel_a.xacro", '<link name="w"/>')
    assert names(discover(str(tmp_path), Config(), Resolver())) == ["robot.xacro"]


def test_a_name_of_many_expressions_is_compared_in_time(tmp_path):
    write(tmp_path, "robot.xacro", include("${a}e" * 40 + ".xacro") + '<link name="a"/>')
    other = "e" * 200 + ".urdf"
    write(tmp_path, other, '<link name="w"/>')
    assert names(discover(str(tmp_path), Config(), Resolver())) == [other, "robot.xacro"]


def test_a_name_that_is_all_expression_hides_nothing(tmp_path):
    write(tmp_path, "robot.xacro", include("${file}") + '<link name="a"/>')
    write(tmp_path, "other.xacro", '<link name="o"/>')
    assert len(discover(str(tmp_path), Config(), Resolver()).robots) == 2


def test_includes_in_comments_do_not_count(tmp_path):
    write(tmp_path, "robot.xacro", f"<!-- {include('other.xacro')} -->" + '<link name="a"/>')
    write(tmp_path, "other.xacro", '<link name="o"/>')
    assert len(discover(str(tmp_path), Config(), Resolver()).robots) == 2


def test_a_dangling_link_hides_no_robot(tmp_path):
    (tmp_path / "a.urdf").symlink_to(tmp_path / "gone.urdf")
    (tmp_path / "b.urdf").write_text('<robot name="b"><link name="a"/></robot>')
    assert check(tmp_path).files == (str(tmp_path / "b.urdf"),)


def test_robots_of_a_directory_are_spelt_as_the_directory_was(tmp_path, monkeypatch):
    (tmp_path / "robots").mkdir()
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "robots" / "b.urdf").write_text('<robot name="b"><link name="a"/></robot>')
    monkeypatch.chdir(tmp_path / "elsewhere")
    assert check("../robots").files == ("../robots/b.urdf",)
    assert check(tmp_path / "robots").files == (str(tmp_path / "robots" / "b.urdf"),)
    monkeypatch.chdir(tmp_path)
    assert check("robots").files == check(tmp_path / "robots").files == ("robots/b.urdf",)


def test_files_that_include_each_other_are_bounded(tmp_path):
    write(tmp_path, "a.xacro", include("b.xacro") + '<link name="a"/>')
    write(tmp_path, "b.xacro", include("a.xacro") + '<link name="b"/>')
    write(tmp_path, "c.xacro", include("a.xacro"))
    found = affected([str(tmp_path / "b.xacro")], Config(), Resolver())
    assert names(found) == ["c.xacro"]


def test_of_files_that_include_each_other_one_is_checked_and_tells_of_the_ring(tmp_path):
    write(tmp_path, "a.xacro", include("b.xacro") + '<link name="a"/>')
    write(tmp_path, "b.xacro", include("c.xacro"))
    write(tmp_path, "c.xacro", include("b.xacro") + include("a.xacro"))
    write(tmp_path, "whole.xacro", '<link name="whole"/>')
    assert names(discover(str(tmp_path), Config(), Resolver())) == ["a.xacro", "whole.xacro"]
    report = check(tmp_path)
    assert [found.code for found in report.diagnostics if found.severity.value == "error"] != []


def test_excluded_files_are_passed_over(package):
    config = Config(str(package / "urdfkit.toml"), exclude=("urdf/base.urdf",))
    assert names(discover(str(package), config, Resolver())) == ["arm.xacro"]


@pytest.mark.parametrize("name", ["", "missing"])
def test_a_directory_without_robots_is_an_error(tmp_path, name):
    with pytest.raises(UnreadableFile):
        discover(str(tmp_path / name), Config(), Resolver())


def test_a_directory_is_checked_and_the_library_is_told(package):
    report = check(package)
    assert len(report.files) == 2
    assert [(Path(skip.path).name, skip.code) for skip in report.skipped] == [("lonely.xacro", "")]


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("demo.launch", '<launch><node pkg="p" name="n" type="t"/></launch>'),
        ("macros.xacro", "<robot><xacro:macro name='m'><link name='a'/></xacro:macro></robot>"),
    ],
)
def test_a_directory_without_a_robot_is_not_green(tmp_path: Path, file: str, text: str) -> None:
    (tmp_path / file).write_text(text)
    (found,) = [d for d in check(tmp_path).diagnostics if d.code == "CFG003"]
    assert found.message.startswith("no robot checked in ")
    assert (Path(found.span.source.path).name, found.severity.value) == (file, "warning")
    assert "CFG003" not in {d.code for d in check(tmp_path, ignore=["CFG003"]).diagnostics}
    write(tmp_path, "r.urdf", '<link name="a"/>')
    assert "CFG003" not in {d.code for d in check(tmp_path).diagnostics}


def test_the_texts_of_many_robots_are_not_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(source, "MAX_BYTES", 100_000)  # so much is reserved to read a file
    text = '<!-- made by xacro --><robot name="r"><link name="a"/></robot>' + 50_000 * " "
    for number in range(100):
        (tmp_path / f"{number}.urdf").write_text(text, encoding="utf-8")
    resolver = Resolver()
    tracemalloc.start()
    try:
        assert len(discover(str(tmp_path), Config(), resolver).robots) == 100
        most = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert most < 20 * len(text)


def test_processes_give_the_same_report(package):
    write(package, "urdf/bad.urdf", '<link name="a"/><link name="a"/>')
    one, two = check(package), check(package, options=Options(jobs=2))
    assert [str(d.span) + d.message for d in one.diagnostics] == [
        str(d.span) + d.message for d in two.diagnostics
    ]
    assert one.diagnostics


def test_a_found_robot_that_needs_arguments_is_not_checked(tmp_path):
    path = write(tmp_path, "r.xacro", '<link name="$(arg side)_a"/>')
    report = check(tmp_path)
    assert [(d.code, d.severity.value) for d in report.diagnostics] == [("CFG003", "warning")]
    (skip,) = report.skipped
    assert "side" in skip.reason
    assert [d.code for d in check(path).diagnostics] == ["XAC010"]


ARM = '<link name="arm"/><xacro:arg default="1" name="scale"/><joint name="$(arg scale)"/>'


@pytest.mark.parametrize(
    ("declared", "expected"),
    [
        ("", ["arm.xacro", "sim.xacro"]),
        ('<xacro:arg name="sim"/>', ["arm.xacro", "sim.xacro"]),
        ('<xacro:arg name="sim" default="true"/>', ["sim.xacro"]),
        ('<xacro:arg default="" name="sim"/>', ["sim.xacro"]),
    ],
)
def test_a_whole_robot_in_one_that_needs_arguments(
    tmp_path: Path, declared: str, expected: list[str]
):
    write(tmp_path, "arm.xacro", ARM + include("rod.xacro"))
    write(tmp_path, "rod.xacro", '<xacro:macro name="rod"/>')
    write(tmp_path, "sim.xacro", f'{declared}{include("arm.xacro")}<link name="$(arg sim)"/>')
    assert names(discover(str(tmp_path), Config(), Resolver())) == expected


def test_parts_of_a_robot_that_needs_arguments_stay_parts(tmp_path: Path):
    write(tmp_path, "part.xacro", '<link name="$(arg prefix)_part"/>')
    (tmp_path / "nameless.xacro").write_text('<robot><link name="x"/></robot>')
    body = include("part.xacro") + include("nameless.xacro") + '<link name="$(arg prefix)"/>'
    write(tmp_path, "whole.xacro", body)
    assert names(discover(str(tmp_path), Config(), Resolver())) == ["whole.xacro"]


def test_a_name_that_no_file_can_have_includes_nothing(tmp_path):
    (tmp_path / "r.xacro").write_bytes(b'<robot><xacro:include filename="a\0b.xacro"/></robot>')
    found = discover(str(tmp_path), Config(), Resolver())
    assert [Path(robot.file).name for robot in found.robots] == ["r.xacro"]


def test_the_launch_files_of_a_directory_are_checked(package):
    (package / "launch").mkdir()
    (package / "launch" / "a.launch").write_text("<launch><group></launch>")
    (package / "launch" / "gone.launch").symlink_to("nowhere")
    report = check(package, select=["LAU"])
    assert [(d.code, Path(d.span.source.path).name) for d in report.diagnostics] == [
        ("LAU001", "a.launch")
    ]
    config = Config(path=str(package / "urdfkit.toml"), exclude=("launch",))
    assert check(package, select=["LAU"], config=config).diagnostics == ()


def test_the_controllers_that_launch_files_load_are_compared_with_the_robots(package):
    write(package, "urdf/cart.xacro", CART)
    (package / "c.yaml").write_text(
        "grip:\n  type: position_controllers/JointPositionController\n  joint: axel\n"
    )
    (package / "launch").mkdir()
    (package / "launch" / "a.launch").write_text(LAUNCH)
    report = check(package / "urdf", package)
    (found,) = (d for d in report.diagnostics if d.code == "RCT001")
    assert "joint 'axel'" in found.message
    assert found.span.source.path == str(package / "c.yaml")
    assert [Path(file).name for file in report.files].count("cart.xacro") == 1


def test_a_directory_of_launch_files_alone_is_checked(tmp_path):
    (tmp_path / "a.launch").write_text("<launch><group></launch>")
    report = check(tmp_path, select=["LAU"])
    assert [found.code for found in report.diagnostics] == ["CFG003", "LAU001"]


def test_a_robot_is_checked_with_the_arguments_of_launch_files(package):
    """What is left out without them is told once."""
    (package / "urdf").mkdir(exist_ok=True)
    (package / "urdf" / "arm.urdf.xacro").write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:arg name="sim" default="false"/><link name="base"/>'
        '<xacro:if value="$(arg sim)"><gazebo reference="bsae"><mu1>1</mu1></gazebo></xacro:if>'
        "</robot>"
    )
    (package / "launch").mkdir(exist_ok=True)
    for name in "ab":
        (package / "launch" / f"{name}.launch").write_text(
            '<launch><param name="robot_description" '
            'command="xacro $(dirname)/../urdf/arm.urdf.xacro sim:=true"/></launch>'
        )
    (found,) = check(package, select=["GAZ001"]).diagnostics
    assert found.span.text == "bsae"
    assert [step.name for step in found.calls[0].via] == ["a.launch"]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "XML001"),
        ("version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n", "XML001"),
        ('<robt name="r"><link name="a"/></robt>', "URD015"),
    ],
    ids=["empty", "a pointer of Git LFS", "misspelt"],
)
def test_a_urdf_without_a_robot_is_no_reason_for_a_green_report(
    tmp_path: Path, text: str, code: str
) -> None:
    write(tmp_path, "good.urdf", CART)
    (tmp_path / "lost.urdf").write_text(text)
    report = check(tmp_path)
    assert {Path(path).name for path in report.files} == {"good.urdf", "lost.urdf"}
    assert code in {found.code for found in report.diagnostics if found.severity.value == "error"}


def test_what_cannot_be_opened_is_told(tmp_path: Path) -> None:
    write(tmp_path, "good.urdf", CART)
    (tmp_path / "lost.urdf").symlink_to(tmp_path / "nowhere")
    (skipped,) = [one for one in check(tmp_path).skipped if not one.code]
    assert (Path(skipped.path).name, skipped.reason.partition(";")[0]) == (
        "lost.urdf",
        "cannot be opened",
    )


ROOT_ROBOT = '<robot name="box"><link name="box"/></robot>\n'


@pytest.mark.parametrize("name", ["arm.URDF", "arm.Urdf", "arm.XACRO", "arm.URDF.XACRO"])
def test_the_case_of_a_suffix_does_not_matter(tmp_path: Path, name: str):
    (tmp_path / name).write_text(ROOT_ROBOT)
    assert names(discover(str(tmp_path), Config(), Resolver())) == [name]
    (tmp_path / "top.xacro").write_text(
        f'<robot xmlns:xacro="x"><xacro:include filename="{name}"/><link name="a"/></robot>'
    )
    assert names(discover(str(tmp_path), Config(), Resolver())) == ["top.xacro"]


@pytest.mark.parametrize("name", ["box.model", "box.gazebo", "box.xml", "box"])
def test_a_robot_that_a_launch_file_names_is_one_whatever_its_suffix(tmp_path: Path, name: str):
    write(tmp_path, "arm.urdf", '<link name="a"/>')
    (tmp_path / name).write_text(f'<?xml version="1.0"?>\n<!-- a <box> -->\n{ROOT_ROBOT}')
    found = discover(str(tmp_path), Config(), Resolver())
    assert (names(found), [Path(path).name for path in found.others]) == (["arm.urdf"], [name])
    (tmp_path / "box.launch").write_text(
        f'<launch><node pkg="gazebo_ros" type="spawn_model" args="-file {name} -urdf"/></launch>'
    )
    found = discover(str(tmp_path), Config(), Resolver())
    assert (names(found), dict(found.others)) == (["arm.urdf", name], {})
    assert [str(r.file) for r in affected([str(tmp_path / name)], Config(), Resolver()).robots] == [
        str(tmp_path / name)
    ]


@pytest.mark.parametrize(
    "text",
    [
        '<sdf><model name="robot"><link name="a"/></model></sdf>',
        '<robot><gazebo reference="a"/></robot>',
        '<robot xmlns:xacro="x"><xacro:macro name="m"><link name="a"/></xacro:macro></robot>',
        "<!-- <robot><link/></robot> --><world/>",
        "a <robot><link/></robot>",
        "",
    ],
)
def test_what_is_no_robot_is_not_told(tmp_path: Path, text: str):
    write(tmp_path, "arm.urdf", '<link name="a"/>')
    for name in ("box.model", "box.gazebo"):
        (tmp_path / name).write_text(text)
    assert dict(discover(str(tmp_path), Config(), Resolver()).others) == {}


def test_robots_that_the_configuration_does_not_name_are_told(tmp_path: Path):
    write(tmp_path, "arm.xacro", f'{include("part.urdf")}<link name="a"/>')
    write(tmp_path, "part.urdf", '<link name="b"/>')
    write(tmp_path, "spare.urdf", '<link name="c"/>')
    config = Config(robots=(RobotEntry(str(tmp_path / "arm.xacro"), "", {}),))
    found = discover(str(tmp_path), config, Resolver())
    assert (names(found), [Path(path).name for path in found.others]) == (
        ["arm.xacro"],
        ["spare.urdf"],
    )
    report = check(tmp_path, config=config, select=["XML"])
    assert [(Path(skip.path).name, skip.reason) for skip in report.skipped] == [
        ("spare.urdf", "no [[robot]] in the configuration for it")
    ]


@pytest.mark.parametrize(
    ("name", "parent", "is_part"),
    [
        ("arm", "base", True),
        ("base", "base", False),
        ("${x}", "base", False),
        ("arm", "${x}", False),
    ],
)
def test_a_xacro_without_a_name_is_a_part_if_a_parent_is_certainly_elsewhere(
    tmp_path: Path, name: str, parent: str, is_part: bool
):
    write(tmp_path, "whole.xacro", '<link name="base"/>')
    ends = f'<parent link="{parent}"/><child link="arm"/>'
    body = f'<link name="{name}"/><joint name="j" type="fixed">{ends}</joint>'
    nameless = f"{HEAD}{body}</robot>".replace(' name="r"', "")
    (tmp_path / "part.xacro").write_text(nameless)
    found = names(discover(str(tmp_path), Config(), Resolver()))
    assert found == (["whole.xacro"] if is_part else ["part.xacro", "whole.xacro"])
