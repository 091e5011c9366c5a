"""What ``check --show-settings`` prints is a configuration that means the same."""

from pathlib import Path

import pytest

from urdfkit.cli import main
from urdfkit.lint.config_reader import load

ROBOT = '<robot name="r"><link name="a"/></robot>'
SETTINGS = """
select = ["XML", "MSH", "GEO"]
ignore = ["GEO002"]
fail-on = "error"
targets = ["ros2", "gz-harmonic"]
exclude = ["attic", "*/made/*"]
preview = true
min-confidence = "inferred"
width = 120
xacro-megabytes = 100
[arguments]
use_sim = true
"a b" = "\\u202e \\"##[x]"
[severity]
JNT008 = "info"
missing-file = "warning"
[rules.MSH019]
triangles = 50_000
[[per-file-ignores]]
files = ["vendor/*"]
codes = ["URD", "INE"]
reason = "as delivered"
[[robot]]
file = "r.urdf"
arguments.prefix = "lab_"
[robot.variants]
left = { side = "left" }
right = { side = "right" }
"""


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "r.urdf").write_text(ROBOT)
    return tmp_path


def test_shown_settings_are_equivalent(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (project / "urdfkit.toml").write_text(SETTINGS)
    before = load("urdfkit.toml")
    assert main(["check", "r.urdf", "--show-settings"]) == 0
    text = capsys.readouterr().out
    assert text.isascii()
    (project / "urdfkit.toml").write_text(text)
    after = load("urdfkit.toml")
    # CFG003 runs in any case; what is ignored is not among what is selected.
    selected = before.select - before.ignore | {"CFG003"}
    assert after._replace(named=before.named) == before._replace(
        select=selected, ignore=frozenset()
    )


def test_the_command_line_takes_precedence(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (project / "urdfkit.toml").write_text("width = 90\nfail-on = 'error'")
    words = ["--select", "MSH,GEO002", "--fail-on", "info", "--target", "moveit", "a:=1"]
    assert main(["check", "r.urdf", "--show-settings", *words]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "# from urdfkit.toml"
    expected = ('select = ["CFG003", "GEO002", "MSH"]', 'targets = ["moveit"]', 'fail-on = "info"')
    assert {*expected, "width = 90", 'a = "1"'} <= set(lines)
    assert main(["check", "r.urdf", "--show-settings", "--isolated"]) == 0
    assert "# no configuration file" in capsys.readouterr().out
