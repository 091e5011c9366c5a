import io
import json
import os
import re
import sys
from pathlib import Path

import pytest

from tests.hand_made_rules import run_only
from tests.shipped import GRIPPER
from urdfkit.cli import main
from urdfkit.lint import engine
from urdfkit.lint.context import Context
from urdfkit.lint.options import Options
from urdfkit.lint.rules import Finding, Need, Rule
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import shown

LINK_TO_ITSELF = """\
<robot name="r">
  <link name="a"/>
  <joint name="j" type="fixed"><parent link="a"/><child link="a"/></joint>
</robot>
"""


@pytest.fixture
def bad(tmp_path: Path) -> str:
    """A robot of which TRE003 says something."""
    file = tmp_path / "bad.urdf"
    file.write_text(LINK_TO_ITSELF, encoding="utf-8")
    return str(file)


class Screen:
    """Runs ``urdfkit check`` in this process."""

    def __init__(self, capsys: pytest.CaptureFixture[str]) -> None:
        self.capsys = capsys

    def __call__(self, *words: str) -> tuple[int, str, str]:
        code = main(["check", *words])
        captured = self.capsys.readouterr()
        return code, captured.out, captured.err


@pytest.fixture
def check(capsys: pytest.CaptureFixture[str]) -> Screen:
    return Screen(capsys)


def codes(out: str) -> list[str]:
    return [found["code"] for found in json.loads(out)["diagnostics"]]


def test_select_and_ignore(check: Screen, bad: str) -> None:
    for words, found in [
        (["--select", "TRE003"], ["TRE003"]),
        (["--select", "tre"], ["TRE003"]),
        (["--select", "cycle"], ["TRE003"]),
        (["--select", "XML"], []),
        (["--select", "XML,TRE", "--ignore", "TRE003"], []),
        (["--select", "TRE003", "--select", "XML001"], ["TRE003"]),
    ]:
        assert codes(check(bad, "--format", "json", *words)[1]) == found, words


def test_an_unknown_code_that_is_ignored_is_a_warning(check: Screen, bad: str) -> None:
    code, out, err = check(bad, "--select", "TRE003", "--ignore", "XYZ999", "--format", "json")
    assert (code, codes(out)) == (1, ["TRE003"])
    assert err.startswith("warning: --ignore: no rule 'XYZ999'")


def fake(severity: Severity) -> Rule:
    def find(context: Context):
        yield Finding(context.document.root, "it is there")

    return Rule("ABC123", "fake", severity, frozenset({Need.MODEL}), find, "", False, __name__, {})


@pytest.mark.parametrize(
    ("severity", "fails"),
    [
        (Severity.ERROR, {"error", "warning", "info", None}),
        (Severity.WARNING, {"warning", "info", None}),
        (Severity.INFO, {"info"}),
    ],
)
def test_fail_on(
    severity: Severity, fails: set[str | None], check: Screen, monkeypatch: pytest.MonkeyPatch
) -> None:
    run_only(monkeypatch, [fake(severity)])
    for level in ("error", "warning", "info", None):
        words = ["--fail-on", level] if level else []
        assert check(GRIPPER, *words)[0] == int(level in fails)
        assert check(GRIPPER, "--exit-zero", *words)[0] == 0


def test_a_crashed_rule_exits_with_3_and_the_rest_is_reported(
    check: Screen, bad: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def crash(context: Context):
        raise ValueError("boom")

    rules = [fake(Severity.INFO)._replace(check=crash, code="ABC001"), fake(Severity.ERROR)]
    run_only(monkeypatch, rules)
    monkeypatch.delenv("URDFKIT_DEBUG", raising=False)
    code, out, err = check(bad, "--exit-zero")
    assert (code, err) == (3, "")
    assert "error ABC123 it is there" in " ".join(out.split())
    assert "ABC001 failed with ValueError: boom. This is a bug in urdfkit" in " ".join(out.split())
    monkeypatch.setenv("URDFKIT_DEBUG", "1")
    code, again, err = check(bad, "--exit-zero")
    assert again == out
    assert err.startswith("Traceback ")
    assert "in crash" in err


def test_several_files_are_one_report(check: Screen, bad: str) -> None:
    code, out, _ = check(bad, GRIPPER, "--format", "json")
    assert code == 1
    assert json.loads(out)["summary"]["files"] == [bad, shown(GRIPPER)]
    assert re.search(r" in 2 files\b", check(bad, GRIPPER)[1])


def test_several_formats(check: Screen, bad: str, tmp_path: Path) -> None:
    file = tmp_path / "report.json"
    code, out, _ = check(bad, "--format", f"json:{file}", "--format", "text")
    assert code == 1
    assert "error TRE003" in out
    assert codes(file.read_text(encoding="utf-8")) == codes(check(bad, "--format", "json")[1])
    assert check(bad, "--format", f"text:{file}") == (1, "", "")
    assert file.read_text(encoding="utf-8") == out


def test_nothing_is_printed_if_an_output_file_cannot_be_written(check: Screen, bad: str) -> None:
    code, out, err = check(bad, "--format", "text", "--format", "json:/no/such/directory/r.json")
    assert (code, out) == (2, "")
    assert err.startswith("error: /no/such/directory/r.json: ")


def test_statistics(check: Screen, bad: str) -> None:
    code, out, _ = check(bad, "--select", "TRE003", "--statistics")
    assert (code, out) == (1, "     1  TRE003  error    cycle\n1 error in 1 file\n")


def stdin(monkeypatch: pytest.MonkeyPatch, data: bytes) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(data)))


def test_standard_input(check: Screen, monkeypatch: pytest.MonkeyPatch) -> None:
    for words, name in [([], "<stdin>"), (["--stdin-filename", "arm.urdf"], "arm.urdf")]:
        stdin(monkeypatch, LINK_TO_ITSELF.encode())
        out = check("-", "--select", "TRE003", "--format", "json", *words)[1]
        assert [found["path"] for found in json.loads(out)["diagnostics"]] == [name]


def test_standard_input_has_a_size_limit(check: Screen, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("urdfkit.cli.stdin.MAX_BYTES", 2**20)
    stdin(monkeypatch, b" " * (2**20 + 1))
    assert check("-") == (2, "", "error: standard input: larger than 1 MiB\n")


def test_options_reach_the_library(
    monkeypatch: pytest.MonkeyPatch, check: Screen, tmp_path: Path
) -> None:
    asked: list[tuple[list[object], dict[str, object]]] = []

    def record(options: Options, files: list[object], *, spills: bool) -> object:
        asked.append((files, options._asdict()))
        return engine.check()

    monkeypatch.setattr("urdfkit.cli.checking.check_with", record)
    check(
        *("a.urdf", "b", "p:=1", "--trust", "--package", f"x={tmp_path}"),
        *("--select=A", "--ignore=COL,INE", "--target", "moveit", "--target=kdl"),
    )
    check("a.urdf")
    given = {
        "arguments": {"p": "1"},
        "packages": {"x": str(tmp_path)},
        "select": ["A"],
        "ignore": ["COL", "INE"],
        "targets": ["moveit", "kdl"],
        "trust": True,
    }
    (files, options), (other_files, others) = asked
    assert (files, other_files) == (["a.urdf", "b"], ["a.urdf"])
    assert {name: options[name] for name in given} == given
    assert {name: others[name] for name in given} == {
        name: type(value)() for name, value in given.items()
    }


@pytest.mark.parametrize(
    ("words", "environment", "coloured"),
    [
        ([], {}, False),
        (["--color", "auto"], {}, False),
        (["--color", "always"], {}, True),
        (["--color", "always"], {"NO_COLOR": "1"}, True),
        (["--color", "never"], {"FORCE_COLOR": "1"}, False),
        ([], {"FORCE_COLOR": "1"}, True),
        ([], {"FORCE_COLOR": ""}, False),
        ([], {"FORCE_COLOR": "1", "NO_COLOR": "1"}, False),
        ([], {"FORCE_COLOR": "1", "NO_COLOR": ""}, True),
    ],
)
def test_color(
    words: list[str],
    environment: dict[str, str],
    coloured: bool,
    check: Screen,
    bad: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for name in ("NO_COLOR", "FORCE_COLOR"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert ("\x1b[" in check(bad, *words)[1]) is coloured


def test_files_have_no_colours(check: Screen, bad: str, tmp_path: Path) -> None:
    check(bad, "--color", "always", "--format", f"text:{tmp_path / 'out'}")
    assert "\x1b" not in (tmp_path / "out").read_text(encoding="utf-8")


@pytest.mark.skipif(os.name == "nt", reason="no pseudo terminals on Windows")
def test_a_terminal_has_colours_and_its_own_width(bad: str) -> None:
    import fcntl
    import pty
    import struct
    import subprocess
    import termios

    from tests.conftest import ROOT

    parent, child = pty.openpty()
    fcntl.ioctl(child, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 50, 0, 0))
    environment = {
        k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "FORCE_COLOR", "COLUMNS")
    }
    subprocess.run(
        [sys.executable, "-m", "urdfkit", "check", bad, "--select", "TRE003"],
        check=False,
        cwd=ROOT,
        stdout=child,
        env={**environment, "TERM": "xterm"},
        timeout=60,
    )
    os.close(child)
    text = b""
    try:
        while chunk := os.read(parent, 4096):
            text += chunk
    except OSError:  # Linux says so at the end
        pass
    os.close(parent)
    assert b"\x1b[1;31merror\x1b[0m" in text
    frame = next(line for line in text.decode().splitlines() if line.startswith("    3 | "))
    assert frame == '    3 | ...ent link="a"/><child link="a"/></joint>'


def test_show_files_lists_and_checks_nothing(check: Screen, tmp_path: Path) -> None:
    (tmp_path / "bad.URDF").write_text(LINK_TO_ITSELF, encoding="utf-8")
    (tmp_path / "box.model").write_text(LINK_TO_ITSELF, encoding="utf-8")
    code, out, _ = check(str(tmp_path), "--show-files", "side:=left")
    assert code == 0
    robot, left = out.splitlines()
    assert robot == f"{tmp_path / 'bad.URDF'} side:=left"
    assert left.startswith(f"not checked: {tmp_path / 'box.model'}: has the root <robot>, ")
    said = " ".join(check(str(tmp_path))[1].split())
    assert said.count("box.model skipped: has the root <robot>, but") == 1


@pytest.mark.parametrize("form", ["text", "full", "concise"])
def test_quiet_prints_only_findings(check: Screen, bad: str, form: str) -> None:
    words = [bad, "--select", "TRE003", "--format", form]
    _, whole, _ = check(*words)
    code, out, _ = check(*words, "--quiet")
    assert code == 1
    assert out.rstrip("\n")
    assert whole.startswith(out.rstrip("\n"))
    assert "1 error in 1 file" in whole
    assert "in 1 file" not in out
    assert check(GRIPPER, "-q", "--format", form) == (0, "", "")


def test_output_option_is_the_file_of_the_format(check: Screen, bad: str, tmp_path: Path) -> None:
    file = tmp_path / "found.json"
    words = [bad, "--select", "TRE003", "--format", "json"]
    assert check(*words, "-o", str(file)) == (1, "", "")
    assert codes(file.read_text(encoding="utf-8")) == ["TRE003"]
    assert codes(check(*words, "-o", "-")[1]) == ["TRE003"]
    code, _, err = check(bad, "--format", f"json:{file}", "-o", "other")
    assert (code, err) == (2, "error: --output other: every --format has a file already\n")
