"""The robots of a directory, and those that a changed file is part of."""

import tracemalloc
from pathlib import Path

import pytest

from tests.lint.directories import ROOT_ROBOT, include, names, write
from tests.workspaces import add_file
from tests.xacros import xacro
from urdfkit import check
from urdfkit.errors import UnreadableFile
from urdfkit.lint.config import Config, RobotEntry
from urdfkit.lint.discovery import affected, discover, launch_files
from urdfkit.lint.options import Options
from urdfkit.text import source
from urdfkit.workspace.resolve import Resolver


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


@pytest.mark.parametrize("is_named_by", ["the SRDF", "the assistant"])
def test_a_changed_file_of_moveit_leads_to_the_robot_of_another_package(
    repository: Path, is_named_by: str
) -> None:
    """The robot is in its own package in most workspaces; a hook passed such a file unchecked."""
    settings = repository / "settings"
    add_file(settings / "config" / "kinematics.yaml", b"arm: {}")
    if is_named_by == "the SRDF":
        add_file(settings / "config" / "a.srdf", b'<robot name="arm"><group name="arm"/></robot>')
        robot = add_file(
            repository / "robot" / "urdf" / "a.urdf",
            b'<robot name="arm"><link name="base"/></robot>',
        )
    else:
        robot = repository / "robot" / "urdf" / "robot.xacro"
        add_file(
            settings / ".setup_assistant",
            b"config:\n  URDF:\n    package: robot\n    relative_path: urdf/robot.xacro\n",
        )
    found = affected([str(settings / "config" / "kinematics.yaml")], Config(), Resolver())
    assert names(found) == [robot.name]


def test_nothing_to_check_is_no_mistake(repository):
    report = check(repository / "settings" / "x.yaml", options=Options(changed=True))
    assert (report.files, report.diagnostics, report.exit_code()) == ((), (), 0)


def test_a_library_that_nobody_includes_is_reported(repository):
    path = write(repository, "parts/urdf/new.xacro", '<xacro:macro name="new"/>')
    found = affected([path], Config(), Resolver())
    assert found.robots == ()
    assert found.libraries == (path,)


@pytest.mark.parametrize("user", ["arm.srdf.xacro", "arm.sdf.xacro"])
def test_a_library_of_another_model_is_included(tmp_path: Path, user: str) -> None:
    """KUKA's macros for SRDFs, which only a .srdf.xacro includes."""
    write(tmp_path, "arm.urdf", '<link name="base"/>')
    library = write(tmp_path, "arm_macro.xacro", '<xacro:macro name="arm"/>')
    write(tmp_path, user, include("arm_macro.xacro") + '<group><link name="base"/></group>')
    found = discover(str(tmp_path), Config(), Resolver())
    assert names(found) == ["arm.urdf"]
    assert found.libraries == ()
    assert found.others == {library: "defines no link, and no robot that is checked includes it"}


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


def test_a_directory_that_is_excluded_as_a_whole_says_so(package):
    config = Config("urdfkit.toml", exclude=("*",))
    with pytest.raises(
        UnreadableFile, match=r"not counting what 'exclude' in .*urdfkit\.toml names$"
    ):
        discover(str(package), config, Resolver())


def test_excluded_files_are_passed_over(package):
    config = Config(str(package / "urdfkit.toml"), exclude=("urdf/base.urdf",))
    assert names(discover(str(package), config, Resolver())) == ["arm.xacro"]


@pytest.mark.parametrize("name", ["", "missing"])
def test_a_directory_without_robots_is_an_error(tmp_path, name):
    with pytest.raises(UnreadableFile):
        discover(str(tmp_path / name), Config(), Resolver())


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


@pytest.mark.parametrize(
    ("name", "count"), [("bringup.py", 1), ("helpers.py", 0), ("a_launch.py", 1)]
)
def test_programs_in_a_directory_of_launch_files(tmp_path: Path, name: str, count: int) -> None:
    """clydemcqueen/orca4: ``ros2 launch orca_bringup bringup.py``."""
    text = (
        "def generate_launch_description():\n    pass\n" if name == "bringup.py" else "VALUE = 1\n"
    )
    path = add_file(tmp_path / "launch" / name, text)
    found = launch_files(str(tmp_path), Config(), Resolver().directories)
    assert list(found) == [str(path)] * count


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
def test_what_is_no_robot_is_not_reported(tmp_path: Path, text: str):
    write(tmp_path, "arm.urdf", '<link name="a"/>')
    for name in ("box.model", "box.gazebo"):
        (tmp_path / name).write_text(text)
    assert dict(discover(str(tmp_path), Config(), Resolver()).others) == {}


def test_robots_that_the_configuration_does_not_name_are_reported(tmp_path: Path):
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


def test_a_robot_is_called_as_its_link_is(tmp_path: Path):
    add_file(tmp_path / "real" / "r.xml", b'<robot name="r"><link name="a"/></robot>')
    for name in ("a.urdf", "z.urdf"):
        (tmp_path / name).symlink_to("real/r.xml")
        found = discover(str(tmp_path), Config(), Resolver())
        assert [one.file for one in found.robots] == [str(tmp_path / name)]
        assert not found.others
        (tmp_path / name).unlink()


def test_a_directory_without_a_robot_says_what_is_there(tmp_path: Path):
    add_file(tmp_path / "r.xml", b'<robot name="r"><link name="a"/></robot>')
    (found,) = check(tmp_path).diagnostics
    assert found.message.endswith(
        "r.xml has the root <robot>, but an unusual suffix, and no launch file references it"
    )


def test_a_library_that_is_named_is_reported_to_hold_no_robot(tmp_path: Path):
    library = add_file(tmp_path / "m.xacro", xacro('<xacro:macro name="m"/>').encode())
    robot = add_file(tmp_path / "r.xacro", xacro('<link name="a"/>').encode())
    (skip,) = check(library, robot).skipped
    assert (skip.code, skip.path, skip.reason) == (
        "",
        str(library),
        "defines no link; check a robot that uses it",
    )


MACRO = '<xacro:macro name="m" params="name"><link name="${name}"/></xacro:macro>'


def test_a_macro_that_is_called_without_its_prefix_is_no_library(tmp_path: Path) -> None:
    robot = add_file(tmp_path / "r.xacro", xacro(f'{MACRO}\n<m name="a"/>'))
    add_file(tmp_path / "other.urdf", b'<robot name="b"><link name="b"/></robot>')
    report = check(tmp_path, options=Options(select=("XAC002",)))
    assert [str(one.span) for one in report.diagnostics] == [f"{robot}:3:1"]
    assert not report.skipped
    assert not [skip for skip in check(robot).skipped if not skip.code]


@pytest.mark.parametrize(
    ("name", "root", "count"),
    [
        ("a.urdf.xacro", "Robot", 1),
        ("a.urdf.xacro", "robt", 1),
        ("a.urdf.xacro", "root", 0),  # of PR2's fragments
        ("a.urdf.xacro", "materials", 0),
        ("a.xacro", "robt", 0),
        ("a.urdf", "materials", 1),
    ],
)
def test_a_robot_with_another_root(tmp_path: Path, name: str, root: str, count: int) -> None:
    text = f'<!-- an arm --><{root} name="a"><link name="b"/></{root}>'
    add_file(tmp_path / name, text)
    add_file(tmp_path / "other.urdf", b'<robot name="b"><link name="b"/></robot>')
    found = check(tmp_path, options=Options(select=("URD015",))).diagnostics
    assert [one.code for one in found] == ["URD015"] * count


def test_an_srdf_that_is_named_is_reported_to_be_none(tmp_path: Path):
    srdf = add_file(tmp_path / "a.srdf", b'<robot name="a"><group name="arm"/></robot>')
    (skip,) = [skip for skip in check(srdf).skipped if not skip.code]
    assert skip == ("", str(srdf), "is an SRDF; check the robots that it is for with --changed")


def test_srdfs_that_no_robot_of_a_directory_is_compared_with_are_named(tmp_path: Path) -> None:
    add_file(tmp_path / "a.urdf", b'<robot name="a"><link name="base"/></robot>')
    add_file(
        tmp_path / "a.srdf", b'<robot name="a"><group name="g"><link name="base"/></group></robot>'
    )
    other = add_file(
        tmp_path / "elsewhere" / "b.srdf", b'<robot name="b"><group name="g"/></robot>'
    )
    skipped = [skip for skip in check(tmp_path).skipped if not skip.code]
    assert skipped == [("", str(other), "not compared with any robot that is checked")]
    assert [s for s in check(tmp_path, select=["TRE"]).skipped if not s.code] == []


@pytest.mark.parametrize("is_repository", [False, True])
def test_a_robot_in_home_is_looked_for_nowhere_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, is_repository: bool
) -> None:
    """An editor would wait until all of home is walked, which dotfiles may make a repository."""
    monkeypatch.setenv("HOME", str(tmp_path))
    if is_repository:
        (tmp_path / ".git").mkdir()
    write(tmp_path, "arm.urdf.xacro", '<link name="a"/>')
    write(tmp_path, "elsewhere/more.urdf.xacro", include("../arm.urdf.xacro"))
    resolver = Resolver()
    found = affected([str(tmp_path / "arm.urdf.xacro")], Config(), resolver)
    assert names(found) == ["arm.urdf.xacro"]
    assert names(affected([str(tmp_path / "notes.yaml")], Config(), resolver)) == []
    inside = affected([str(tmp_path / "elsewhere" / "more.urdf.xacro")], Config(), resolver)
    assert names(inside) == ["more.urdf.xacro"]


@pytest.mark.parametrize(
    ("value", "is_template"),
    [
        ("$mass$", True),  # isaacgym-utils: single_obj_urdf_template.urdf
        ("{{ mass }}", True),
        ("@MASS@", True),
        ("${mass}", False),
        ("$5", False),
        ("1", False),
    ],
)
def test_a_template_of_a_program_is_no_robot(tmp_path: Path, value: str, is_template: bool) -> None:
    link = '<link name="a"><inertial><mass value="{}"/></inertial></link>'
    (tmp_path / "a.urdf").write_text(f'<robot name="a">{link.format(1)}<!-- x="$y$" --></robot>')
    (tmp_path / "b.urdf").write_text(f'<robot name="b">{link.format(value)}</robot>')
    found = discover(str(tmp_path), Config(), Resolver())
    assert names(found) == (["a.urdf"] if is_template else ["a.urdf", "b.urdf"])
    assert [Path(path).name for path in found.others] == (["b.urdf"] if is_template else [])


@pytest.mark.parametrize(
    ("name", "value", "is_template"),
    [
        ("box-template.urdf", "DIM0 DIM1 DIM2", True),  # ravens
        ("box-template.urdf", "0.1 0.1 0.1", False),
        ("box.urdf", "DIM0 DIM1 DIM2", False),
    ],
)
def test_a_file_that_is_called_a_template(
    tmp_path: Path, name: str, value: str, is_template: bool
) -> None:
    box = f'<visual><geometry><box size="{value}"/></geometry></visual>'
    (tmp_path / "a.urdf").write_text('<robot name="a"><link name="a"/></robot>')
    (tmp_path / name).write_text(f'<robot name="b"><link name="BOX">{box}</link></robot>')
    found = discover(str(tmp_path), Config(), Resolver())
    assert [Path(path).name for path in found.others] == ([name] if is_template else [])


@pytest.mark.parametrize(
    ("file", "count"),
    [
        ("test/fail_double_joint.urdf", 1),
        ("arm/tests/urdf/loader_invalid.urdf", 1),
        ("test/two_joints.urdf", 2),
        ("urdf/failsafe_arm.urdf", 2),
    ],
)
def test_robots_of_tests_that_are_wrong_on_purpose(tmp_path, file, count):
    write(tmp_path, "robot.urdf", '<link name="a"/>')
    (tmp_path / file).parent.mkdir(parents=True)
    write(tmp_path, file, '<link name="a"/>')
    found = discover(str(tmp_path), Config(), Resolver())
    assert len(found.robots) == count
    assert len(found.others) == 2 - count


def test_a_directory_of_wrong_robots_alone_is_checked(tmp_path):
    (tmp_path / "test").mkdir()
    write(tmp_path, "test/invalid.urdf", '<link name="a"/>')
    assert len(discover(str(tmp_path), Config(), Resolver()).robots) == 1
