"""check(): which descriptions are checked, and what becomes of their verdicts."""

import gc
import os
from pathlib import Path
from types import ModuleType

import pytest

from tests.workspaces import add_file
from tests.xacros import HEAD
from urdfkit import Source, check
from urdfkit.errors import UnknownRule, UnreadableFile
from urdfkit.lint import check_job, engine
from urdfkit.lint.config import Config, ConfigError, RobotEntry
from urdfkit.lint.context import Context
from urdfkit.lint.options import Options
from urdfkit.lint.report import Report
from urdfkit.lint.runner import FileResult
from urdfkit.robot.model import RobotModel
from urdfkit.ros import launch
from urdfkit.ros.targets import Targets, UnknownTarget
from urdfkit.text.document import Element
from urdfkit.xacro import recovery

LOOP = '<joint name="j" type="fixed"><parent link="a"/><child link="a"/></joint>'


def write(directory: Path, name: str, body: str) -> Path:
    return add_file(directory / name, f"{HEAD}\n{body}\n</robot>\n")


def found(report: Report) -> list[tuple[str, str, int]]:
    """File, code and line of every finding."""
    return [(os.path.basename(d.span.source.path), d.code, d.span.line) for d in report.diagnostics]


@pytest.fixture
def robots(tmp_path: Path) -> Path:
    """Two robots with the same defect in a file that both include, and one each of their own."""
    write(tmp_path, "shared.xacro", f'<link name="a"/>{LOOP}')
    include = '<xacro:include filename="shared.xacro"/>'
    write(tmp_path, "one.xacro", f'{include}\n<xacro:property name="unused_one" value="1"/>')
    write(tmp_path, "two.xacro", f'{include}\n\n<xacro:property name="unused_two" value="1"/>')
    return tmp_path


SELECT = ["TRE003", "XAC004"]


def test_the_defect_of_a_shared_file_is_reported_once(robots: Path) -> None:
    report = check(robots / "two.xacro", robots / "one.xacro", select=SELECT)
    assert found(report) == [
        ("one.xacro", "XAC004", 3),
        ("shared.xacro", "TRE003", 2),
        ("two.xacro", "XAC004", 4),
    ]
    assert report.files == (str(robots / "two.xacro"), str(robots / "one.xacro"))


def test_a_shared_file_is_known_by_whatever_name(robots: Path) -> None:
    (robots / "package.xml").write_text("<package><name>p</name></package>")
    include = '<xacro:include filename="../shared.xacro"/>'
    other = write(robots, "inner/other.xacro", include)
    report = check(robots / "one.xacro", other, select=["TRE003"])
    assert found(report) == [("shared.xacro", "TRE003", 2)]


def test_a_directory_is_its_entry_points(robots: Path) -> None:
    report = check(robots, select=SELECT)
    assert [os.path.basename(file) for file in report.files] == ["one.xacro", "two.xacro"]
    assert len(report.diagnostics) == 3


@pytest.mark.parametrize("jobs", [1, 2, 8])
def test_processes_change_nothing_but_the_time(robots: Path, jobs: int) -> None:
    def reported(report: Report) -> object:
        rows = [
            (
                str(d.span),
                d.span.end,
                *d[:5],
                d.help,
                d.targets,
                [(c.message, c.element) for c in d.calls],
            )
            for d in report.diagnostics
        ]
        return rows, report.files, report.skipped, report.rules, report.targets, report.suppressed

    write(robots, "three.xacro", '<link name="${none}"/>')
    write(robots, "lib.xacro", '<xacro:macro name="m"><link name="x"/></xacro:macro>')
    (robots / "four.urdf").write_text(f'<robot name="r"><link name="a"/>{LOOP}</robot>')
    calls: list[tuple[int, int]] = []
    report = check(robots, options=Options(jobs=jobs, progress=lambda *n: calls.append(n)))
    assert reported(report) == reported(check(robots))
    assert report.diagnostics
    assert report.skipped
    assert calls == [(n, 4) for n in range(1, 5)]


def test_variants_are_checked_under_their_names_with_all_arguments(tmp_path: Path) -> None:
    file = write(
        tmp_path,
        "r.xacro",
        '<xacro:arg name="n" default="x"/><xacro:arg name="m" default=""/>'
        '<link name="$(arg n)"/><link name="$(arg n)$(arg m)"/>',
    )
    robots = (RobotEntry(str(file), "same", {}), RobotEntry(str(file), "other", {"m": "_2"}))
    config = Config(robots=robots, arguments={"n": "y"})
    (same,) = check(file, select=["NAM001"], config=config).diagnostics
    assert "'y'" in same.message
    assert check(file, select=["NAM001"], config=config, arguments={"m": "_3"}).diagnostics == ()
    assert check(file, select=["NAM001"]).diagnostics[0].message.count("'x'")


def test_a_finding_says_which_variants_have_it(tmp_path: Path) -> None:
    file = write(
        tmp_path,
        "r.xacro",
        f"""<link name="a"/>{LOOP}
        <xacro:if value="$(arg big)"><link name="b"/><link name="b"/></xacro:if>
        <xacro:unless value="$(arg big)"><link name="c"/><link name="c"/></xacro:unless>""",
    )
    robots = tuple(
        RobotEntry(str(file), name, {"big": value})
        for name, value in (("s", "false"), ("l", "true"), ("xl", "true"))
    )
    config = Config(robots=robots)
    for jobs in (1, 3):
        report = check(file, select=["NAM001", "TRE003"], config=config, options=Options(jobs=jobs))
        reported = [(d.code, d.span.line, d.variants) for d in report.diagnostics]
        assert reported == [
            ("TRE003", 2, ()),
            ("NAM001", 3, ("l", "xl")),
            ("NAM001", 4, ("s",)),
        ]
    (found,) = check(
        file, select=["NAM001"], config=config, options=Options(variant="l")
    ).diagnostics
    assert found.variants == ()


def test_a_variant_that_is_none_is_an_exception(robots: Path) -> None:
    with pytest.raises(ConfigError, match="unknown variant 'big'; it has none"):
        check(robots / "one.xacro", options=Options(variant="big"))
    with pytest.raises(ConfigError, match="no robot has a variant 'big'"):
        check(robots, options=Options(variant="big"))


def test_a_shared_file_that_one_robot_has_in_all_variants(robots: Path) -> None:
    one, two = robots / "one.xacro", robots / "two.xacro"
    config = Config(robots=(RobotEntry(str(one), "a", {}), RobotEntry(str(one), "b", {})))
    report = check(one, two, select=["TRE003"], config=config)
    assert [d.variants for d in report.diagnostics] == [()]


def test_a_source_needs_no_file() -> None:
    report = check(Source("nowhere.urdf", f'<robot><link name="a"/>{LOOP}</robot>'.encode()))
    assert ("nowhere.urdf", "TRE003", 1) in found(report)


def test_what_cannot_be_done_is_an_exception(tmp_path: Path) -> None:
    good = write(tmp_path, "r.urdf", '<link name="a"/>')
    with pytest.raises(UnreadableFile, match=r"file not found; did you mean 'r\.urdf'"):
        check(tmp_path / "r.xacro")
    (tmp_path / "empty").mkdir()
    with pytest.raises(
        UnreadableFile, match=r"no \.urdf, no \.xacro with a <robot> and no launch file"
    ):
        check(tmp_path / "empty")
    with pytest.raises(UnknownRule):
        check(good, select=["XYZ"])
    with pytest.raises(UnknownRule):
        check(good, ignore=["XYZ"])
    with pytest.raises(UnknownTarget, match="did you mean 'mujoco'"):
        check(good, targets=["mojoco"])


def test_targets_go_before_those_of_the_configuration(tmp_path: Path) -> None:
    root = '<link name="a"><inertial><mass value="1"/></inertial></link>'
    file = write(tmp_path, "r.urdf", root)
    config = Config(targets=("mujoco",))
    for given, expected in (([], "mujoco"), (["kdl"], "kdl")):
        report = check(file, targets=given, config=config, select=["TRE007"])
        assert report.targets == ((str(file), Targets((expected,))),)


def test_changed_files_of_several_directories(robots: Path, tmp_path_factory) -> None:
    other = tmp_path_factory.mktemp("other")
    write(other, "four.xacro", '<link name="a"/>')
    changed = [robots / "shared.xacro", robots / "one.xacro", other / "four.xacro"]
    report = check(*changed, select=SELECT, options=Options(changed=True))
    assert sorted(map(os.path.basename, report.files)) == ["four.xacro", "one.xacro", "two.xacro"]


def test_a_finding_of_one_argument_set_only_stays(tmp_path: Path) -> None:
    file = write(
        tmp_path,
        "r.xacro",
        f'<xacro:arg name="bad" default="0"/><link name="a"/>'
        f'<xacro:if value="$(arg bad)">{LOOP}</xacro:if>',
    )
    robots = (
        RobotEntry(str(file), "good", {"bad": "0"}),
        RobotEntry(str(file), "bad", {"bad": "1"}),
    )
    assert found(check(file, select=["TRE003"], config=Config(robots=robots))) == [
        ("r.xacro", "TRE003", 2)
    ]


@pytest.mark.parametrize("jobs", [1, 2])
def test_texts_stand_for_files_and_what_they_include(robots: Path, jobs: int) -> None:
    texts = {str(robots / "shared.xacro"): f'{HEAD}<link name="a"/></robot>'.encode()}
    texts[str(robots / "two.xacro")] = (robots / "one.xacro").read_bytes()
    assert found(check(robots, select=["XAC", "TRE"], options=Options(texts=texts, jobs=jobs))) == [
        ("one.xacro", "XAC004", 3),
        ("two.xacro", "XAC004", 3),
    ]
    alone = check(robots / "one.xacro", select=["XAC", "TRE"], options=Options(texts=texts))
    assert found(alone) == [("one.xacro", "XAC004", 3)]


def test_of_a_robot_that_was_checked_nothing_heavy_stays(
    robots: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("numpy")
    alive: list[int] = []

    def count(*arguments: object, run=check_job.check_job) -> FileResult:
        alive.append(sum(isinstance(one, (Context, Element)) for one in gc.get_objects()))
        return run(*arguments)

    monkeypatch.setattr(check_job, "check_job", count)
    gc.collect()
    gc.disable()  # as good as it is for a few objects with large meshes
    try:
        engine.check(robots)
    finally:
        gc.enable()
    assert len(alive) > 1
    assert len(set(alive)) == 1


def test_of_an_argument_set_that_was_checked_nothing_heavy_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """robotis_hand: each set has the same 40 dense meshes."""
    pytest.importorskip("numpy")
    arm = "<xacro:arg name='tool' default='a'/><link name='$(arg tool)'/>"
    path = write(tmp_path, "arm.xacro", arm)
    (tmp_path / "package.xml").write_text("<package format='2'><name>arm</name></package>")
    for tool in ("b", "c"):
        command = f"$(command 'xacro $(find-pkg-share arm)/arm.xacro tool:={tool}')"
        node = f'<node pkg="p" exec="e"><param name="robot_description" value="{command}"/></node>'
        (tmp_path / f"{tool}.launch.xml").write_text(f"<launch>{node}</launch>")
    alive: list[int] = []

    def count(*arguments: object, run=check_job.check_context) -> FileResult:
        alive.append(sum(isinstance(one, RobotModel) for one in gc.get_objects()))
        return run(*arguments)

    monkeypatch.setattr(check_job, "check_context", count)
    gc.collect()
    engine.check(path)
    assert len(alive) == 3
    assert len(set(alive)) == 1


def test_what_launch_files_have_in_common_is_read_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "package.xml").write_text("<package format='2'><name>arm</name></package>")
    write(tmp_path, "arm.xacro", "<link name='a'/>")
    command = "$(command 'xacro $(find-pkg-share arm)/arm.xacro')"
    node = f'<node pkg="p" exec="e"><param name="robot_description" value="{command}"/></node>'
    for name in ("a", "b", "c"):
        (tmp_path / f"{name}.launch.xml").write_text(f"<launch>{node}</launch>")
    calls: list[str] = []

    def counted(module: ModuleType, name: str) -> None:
        function = getattr(module, name)

        def call(*arguments: object) -> object:
            calls.append(name)
            return function(*arguments)

        monkeypatch.setattr(module, name, call)

    counted(launch, "_read")
    counted(recovery, "_expand_once")
    check(tmp_path)
    assert calls.count("_read") == 3
    assert calls.count("_expand_once") == 2  # by itself, and as the launch files start it


def test_an_argument_that_one_of_several_robots_has_is_known(tmp_path: Path) -> None:
    with_it = '<xacro:arg name="side" default="left"/><link name="a"/>'
    bodies = {"a": '<link name="a"/>', "b": with_it, "c": '<link name="a"/>'}
    robots = [write(tmp_path, f"{name}.xacro", body) for name, body in bodies.items()]
    given = {"side": "left"}
    assert dict(check(robots[0], arguments=given).unknown_arguments).keys() == given.keys()
    assert check(*robots, arguments=given).unknown_arguments == ()
