"""``urdfkit check`` in a project: directories, configuration, baseline, changes, processes."""

import json
from pathlib import Path
from typing import NoReturn

import pytest

from tests.workspaces import add_file
from urdfkit.cli import main

LOOP = '<joint name="{}" type="fixed"><parent link="a"/><child link="a"/></joint>\n'
SETTINGS = 'select = ["XML", "TRE003", "CFG"]\n'


class Project:
    """A directory with a robot in order, and one with a joint from a link to itself."""

    def __init__(self, directory: Path, capsys: pytest.CaptureFixture[str]) -> None:
        self.directory = directory
        self.capsys = capsys
        self.write("urdfkit.toml", SETTINGS)
        self.robot("good.urdf")
        self.robot("bad.urdf", "one")

    def write(self, name: str, text: str) -> None:
        add_file(self.directory / name, text)

    def robot(self, name: str, *joints: str) -> None:
        body = "".join(map(LOOP.format, joints))
        self.write(name, f'<robot name="r">\n<link name="a"/>\n{body}</robot>\n')

    def check(self, *words: str) -> tuple[int, str, str]:
        code = main(["check", *words])
        captured = self.capsys.readouterr()
        return code, captured.out, captured.err

    def summary(self, *words: str) -> tuple[int, str]:
        """Exit code and last line."""
        code, out, err = self.check(*words)
        assert err == ""
        return code, out.splitlines()[-1]


@pytest.fixture
def project(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> Project:
    monkeypatch.chdir(tmp_path)
    return Project(tmp_path, capsys)


def test_a_directory(project: Project) -> None:
    code, out, _ = project.check(".")
    assert code == 1
    assert out.startswith("bad.urdf:3:")
    assert out.endswith("1 error in 2 files\n")
    (project.directory / "bad.urdf").unlink()
    assert project.summary(".") == (0, "no findings in 1 file")


def test_a_directory_without_robots_cannot_be_checked(project: Project) -> None:
    (project.directory / "empty").mkdir()
    code, out, err = project.check("empty")
    assert (code, out) == (2, "")
    assert err == "error: empty: contains no .urdf, no .xacro with a <robot> and no launch file\n"


def test_the_nearest_configuration_applies_unless_another_is_given(project: Project) -> None:
    project.write("inner/urdfkit.toml", 'select = ["XML"]\n')
    project.robot("inner/bad.urdf", "one")
    project.write("other.toml", 'select = ["TRE003"]\nfail-on = "error"\n')
    assert project.summary("inner/bad.urdf") == (0, "no findings in 1 file")
    assert project.summary("inner/bad.urdf", "--config", "urdfkit.toml")[0] == 1
    assert project.summary("inner/bad.urdf", "--isolated", "--select", "TRE003")[0] == 1
    project.write("urdfkit.toml", SETTINGS + '[severity]\nTRE003 = "warning"\n')
    assert project.summary("bad.urdf") == (1, "1 warning in 1 file")
    project.write("urdfkit.toml", SETTINGS + 'fail-on = "error"\n[severity]\nTRE003 = "warning"\n')
    assert project.summary("bad.urdf") == (0, "1 warning in 1 file")
    assert project.summary("bad.urdf", "--fail-on", "warning")[0] == 1


def test_a_typo_in_the_configuration_stops_the_check(project: Project) -> None:
    project.write("urdfkit.toml", "selct = []")
    code, out, err = project.check(".")
    assert (code, out) == (2, "")
    assert "urdfkit.toml:1: unknown setting 'selct'; did you mean 'select'?" in err
    assert project.check(".", "--isolated", "--select", "TRE003")[0] == 1
    assert project.check(".", "--config", "none.toml")[2] == ("error: none.toml: file not found\n")


@pytest.mark.parametrize("words", [[], ["--trust"], ["--config", "urdfkit.toml"]])
def test_trust_requires_an_option(project: Project, words: list[str]) -> None:
    project.write("urdfkit.toml", SETTINGS + "trust = true\n")
    code, _, err = project.check("good.urdf", *words)
    assert code == (0 if words else 2)
    assert ("'trust' must be confirmed on the command line" in err) is not bool(words)


def test_findings_in_a_baseline_are_not_counted_as_fixable(project: Project) -> None:
    project.write(
        "a.urdf",
        '<robot name="r"><material name="m"><color rgba="255 0 0 1"/></material>'
        '<link name="a"/></robot>',
    )
    words = (".", "--select", "GEO007", "--baseline", "known.json")
    assert "an unsafe fix" in project.check(*words[:3])[1]
    for more in (["--write-baseline"], []):
        _, out, _ = project.check(*words, *more)
        assert out.endswith("(1 finding in the baseline)\n")
        assert "fix" not in out


def test_a_baseline_hides_known_findings(project: Project) -> None:
    code, out, _ = project.check(".", "--baseline", "known.json", "--write-baseline")
    assert code == 0
    assert out == "no new findings in 2 files (1 finding in the baseline)\n"
    assert [entry["code"] for entry in json.loads(Path("known.json").read_text())["findings"]] == [
        "TRE003"
    ]
    assert project.summary(".", "--baseline", "known.json")[0] == 0

    project.robot("bad.urdf", "one", "two")
    code, out, _ = project.check(".", "--baseline", "known.json")
    assert code == 1
    assert "bad.urdf:4:" in out
    assert out.endswith("1 error in 2 files (1 finding in the baseline)\n")

    project.robot("bad.urdf")  # fixed: the baseline holds more than there is
    assert project.summary(".", "--baseline", "known.json") == (0, "no findings in 2 files")


@pytest.mark.parametrize(
    ("words", "reported"),
    [
        (["--write-baseline"], "--write-baseline needs --baseline FILE"),
        (["--baseline", "none.json"], "none.json: file not found"),
    ],
)
def test_a_baseline_that_is_missing_is_reported_before_the_check(
    project: Project, monkeypatch: pytest.MonkeyPatch, words: list[str], reported: str
) -> None:
    monkeypatch.setattr(
        "urdfkit.cli.checking.check_with", lambda *_, **__: pytest.fail("it checks")
    )
    code, _, err = project.check(".", *words)
    assert code == 2
    assert reported in err


def test_a_baseline_works_from_every_directory(project: Project, monkeypatch) -> None:
    project.check(".", "--baseline", "known.json", "--write-baseline")
    project.write("inner/x", "")
    monkeypatch.chdir(project.directory / "inner")
    assert project.summary("..", "--baseline", "../known.json") == (
        0,
        "no new findings in 2 files (1 finding in the baseline)",
    )


def test_invalid_baselines(project: Project) -> None:
    code, out, err = project.check(".", "--write-baseline")
    assert (code, out) == (2, "")
    assert err == "error: --write-baseline needs --baseline FILE to write to\n"
    code, out, err = project.check(".", "--baseline", "none.json")
    assert (code, out) == (2, "")
    assert err == "error: none.json: file not found\n"
    project.write("known.json", "[]")
    assert project.check(".", "--baseline", "known.json")[0] == 2


def test_a_baseline_hides_no_crash(project: Project, monkeypatch) -> None:
    from urdfkit.lint import rule_index

    def crash(_: object) -> NoReturn:
        raise ValueError("boom")

    rule = rule_index.get("TRE003")._replace(check=crash)
    monkeypatch.setattr(rule_index, "get", lambda code: rule)
    project.write("urdfkit.toml", 'select = ["TRE003"]\n')
    assert project.check(".", "--baseline", "known.json", "--write-baseline")[0] == 3


def test_changed_files(project: Project) -> None:
    project.write(
        "robot.xacro",
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
        '<xacro:include filename="part.xacro"/></robot>',
    )
    project.robot("part.xacro", "one")
    code, out, _ = project.check("--changed", "part.xacro", "notes.txt")
    assert code == 1
    assert out.startswith("part.xacro:3:")
    assert "included at robot.xacro:2:1" in out
    assert out.endswith("1 error in 1 file\n")
    (project.directory / ".git").mkdir()
    project.write("docs/notes.txt", "")
    assert project.summary("--changed", "docs/notes.txt") == (0, "no findings in 0 files")


def test_processes_print_the_same(project: Project) -> None:
    for number in range(9):
        project.robot(f"robot_{number}.urdf", *"abc"[: number % 3])
    assert project.check(".", "--jobs", "2") == project.check(".")
    for wrong in ("0", "-1", "x", "1.5"):
        code, out, err = project.check(".", f"--jobs={wrong}")
        expected = f"error: --jobs {wrong}: write a number from 1, or auto\n"
        assert (code, out, err) == (2, "", expected)


def test_exit_zero_hides_findings_but_no_mistake(project: Project) -> None:
    assert project.summary(".", "--exit-zero")[0] == 0
    assert project.check("none", "--exit-zero")[0] == 2
