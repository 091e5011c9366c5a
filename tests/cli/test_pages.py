"""Every command has a page that names all its options and shows what it really prints."""

import ast
import importlib
import re
import shlex
import shutil
import subprocess
from pathlib import Path

import click
import pytest

pytest.importorskip("trimesh", reason="the commands about meshes need the extra meshes")

import urdfkit
from docs import transcripts
from tests.conftest import MODELS
from urdfkit.cli import main
from urdfkit.cli.group import group
from urdfkit.cli.lazy import LazyGroup


def all_commands(inside: LazyGroup, prefix: str = "") -> dict[str, click.Command]:
    """Every command by its full name, those of groups included."""
    found: dict[str, click.Command] = {}
    for name in inside.names:
        command = inside.get_command(click.Context(inside), name)
        assert command is not None
        found[prefix + name] = command
        if isinstance(command, LazyGroup):
            found |= all_commands(command, f"{prefix}{name} ")
    return found


assert isinstance(group, LazyGroup)
COMMANDS = all_commands(group)
PAGES = sorted(transcripts.DIRECTORY.glob("*.md"))


def option_names(command: str) -> set[str]:
    params = COMMANDS[command].params
    return {flag for param in params if isinstance(param, click.Option) for flag in param.opts}


@pytest.mark.parametrize("command", [name for name in COMMANDS if name != "mesh"])
def test_the_help_has_examples_that_are_command_lines(command: str) -> None:
    lines = (COMMANDS[command].epilog or "").splitlines()[2:]
    assert lines
    for line in lines:
        assert len(line) <= 80
        words = shlex.split(line.rpartition("|")[2].partition(">")[0])
        assert words[: 1 + len(command.split())] == ["urdfkit", *command.split()]
        # As in the group: click keeps the option for help that is made first.
        COMMANDS[command].make_context(
            command, words[1 + len(command.split()) :], help_option_names=["-h", "--help"]
        )


def test_every_command_has_a_page() -> None:
    assert {page.stem for page in PAGES} == {name.replace(" ", "-") for name in COMMANDS}


@pytest.mark.parametrize("command", COMMANDS)
def test_the_page_names_every_option_of_its_command_and_no_other(command: str) -> None:
    text = (transcripts.DIRECTORY / f"{command.replace(' ', '-')}.md").read_text(encoding="utf-8")
    assert text.startswith(f"# urdfkit {command}\n")
    named = set(re.findall(r"(?<=[`\[])--?[a-z][a-z-]*", text))
    others = set().union(*map(option_names, COMMANDS)) - option_names(command)
    assert option_names(command) - {"--color"} <= named
    assert named - option_names(command) <= others


@pytest.mark.parametrize("command", [name for name in COMMANDS if name != "mesh"])
def test_every_command_has_colours_which_the_page_of_check_explains(command: str) -> None:
    (option,) = [param for param in COMMANDS[command].params if "--color" in param.opts]
    assert isinstance(option.type, click.Choice)
    assert [*option.type.choices] == ["auto", "always", "never"]
    assert "`--color WHEN`" in (transcripts.DIRECTORY / "check.md").read_text(encoding="utf-8")


def test_names_of_options_agree() -> None:
    """One name for one thing; what a command writes is named by -o."""
    flags = set().union(*map(option_names, COMMANDS))
    assert [flag for flag in flags if f"{flag}s" in flags] == []
    written = {
        flag
        for command in COMMANDS.values()
        for param in command.params
        if isinstance(param, click.Option) and param.metavar and " to write" in (param.help or "")
        for flag in param.opts
    }
    assert written == {"-o", "--output"}


# --- what pages show without its output


def shown(language: str) -> list[tuple[str, str]]:
    """The blocks of a language on all pages, each with the name of its page."""
    block = re.compile(rf"(?<=^```{language}\n).*?(?=^```$)", re.DOTALL | re.MULTILINE)
    return [
        (page.name, text)
        for page in transcripts.PAGES[2:]  # the READMEs have tests of their own
        for text in block.findall(page.read_text(encoding="utf-8"))
    ]


def without_output() -> list[tuple[str, str]]:
    """Commands that pages only show, each on one line.

    Not those that wait for a browser, draw a hundred pictures or check a collection: these have
    tests of their own.
    """
    return [
        (page, line)
        for page, block in shown("sh")
        for line in block.replace("\\\n", "").splitlines()
        if line.startswith("urdfkit ")
        and not re.search("urdfkit (view|scan)|--turntable|--sweep", line)
    ]


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A repository with the files and the revision that the pages name."""
    directory: Path = tmp_path_factory.mktemp("project") / "two_link_arm"
    shutil.copytree(MODELS / "good" / "two_link_arm", directory)
    arm = directory / "urdf" / "two_link_arm.urdf"
    for name in ("robot.urdf", "robot.urdf.xacro", "panda.urdf", "urdf/robot.urdf.xacro"):
        shutil.copy(arm, directory / name)
    arm.rename(directory / "urdf" / "arm.urdf.xacro")
    state = '<group_state name="ready" group="arm"><joint name="elbow" value="0.5"/></group_state>'
    (directory / "panda.srdf").write_text(f'<robot name="two_link_arm">{state}</robot>')
    who = ("-c", "user.name=a", "-c", "user.email=a@b.c")
    for words in (("init", "-q"), ("add", "-A"), ("commit", "-qm", "1"), ("tag", "v1.2.0")):
        subprocess.run(["git", *who, *words], cwd=directory, check=True)
    subprocess.run(
        ["git", *who, "commit", "-q", "--allow-empty", "-m", "2"], cwd=directory, check=True
    )
    return directory


@pytest.mark.parametrize(("page", "line"), without_output(), ids=lambda words: words[:60])
def test_other_commands_of_pages_run(
    page: str,
    line: str,
    project: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    for library in ("PIL", "jinja2", "coal"):
        pytest.importorskip(library)
    monkeypatch.chdir(project)
    assert main(shlex.split(line, comments=True)[1:]) in (0, 1)
    assert "error:" not in capsys.readouterr().err


@pytest.mark.parametrize(("page", "block"), shown("python"), ids=lambda words: words[:12])
def test_python_of_pages_parses(page: str, block: str) -> None:
    """Names that a block imports from urdfkit, or uses of it, are there."""
    tree = ast.parse(block)
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("urdfkit"):
            module = importlib.import_module(node.module or "")
            assert [alias.name for alias in node.names if not hasattr(module, alias.name)] == []
        if isinstance(node, ast.Attribute) and ast.unparse(node.value) == "urdfkit":
            assert node.attr in urdfkit.__all__
