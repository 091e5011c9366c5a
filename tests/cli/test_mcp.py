"""The tools for agents, called by the client of the official SDK over standard input and output."""

import asyncio
import base64
import os
import shutil
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("mcp")
from mcp import Client, StdioServerParameters
from mcp.server.mcpserver import MCPServer
from mcp.server.mcpserver.exceptions import ToolError

from tests.conftest import MODELS, ROOT
from urdfkit.cli import main
from urdfkit.cli.mcp_tools import MAX_BYTES, Tools, server

MODEL = "gazebo_pkg/urdf/waking_robot_new.xacro"


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """A workspace with the mission's model, and a file outside of it."""
    shutil.copytree(MODELS / "gazebo_pkg", tmp_path / "ws" / "gazebo_pkg")
    (tmp_path / "outside.urdf").write_text('<robot name="secret"/>')
    (tmp_path / "ws" / "link.urdf").symlink_to(tmp_path / "outside.urdf")
    return tmp_path / "ws"


Conversation = Callable[[Client], Awaitable[None]]


def talk(workspace: Path, conversation: Conversation, *, may_write: bool = False) -> None:
    """A whole session with a server in this process."""
    converse(server(str(workspace), may_write=may_write), conversation)


def converse(with_: MCPServer | StdioServerParameters, conversation: Conversation) -> None:
    async def session() -> None:
        async with Client(with_) as client:
            await conversation(client)

    asyncio.run(session())


def program(workspace: Path, *options: str) -> StdioServerParameters:
    """The command."""
    return StdioServerParameters(
        command=sys.executable,
        args=["-m", "urdfkit", "mcp", str(workspace), *options],
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        cwd=workspace,
    )


async def ask(client: Client, tool: str, **words: Any) -> str:
    """The answer of a tool that answers."""
    done = await client.call_tool(tool, words)
    (content,) = done.content
    assert content.type == "text"
    assert not done.is_error, content.text
    assert len(content.text.encode()) <= MAX_BYTES + 100
    return content.text


async def failure(client: Client, tool: str, **words: Any) -> str:
    """Why a tool does not answer."""
    done = await client.call_tool(tool, words)
    assert done.is_error
    (content,) = done.content
    assert content.type == "text"
    return content.text


def test_reading_tools(workspace: Path) -> None:
    async def conversation(client: Client) -> None:
        tools = {tool.name: tool for tool in (await client.list_tools()).tools}
        assert set(tools) == {"check", "explain", "trace", "expand", "fix", "render"}
        hints = [tool.annotations for tool in tools.values()]
        assert all(hint is not None and hint.read_only_hint for hint in hints)

        found = await ask(client, "check", path="gazebo_pkg")
        assert f"{MODEL}:266:25: error MSH001" in found
        found = await ask(client, "check", path=MODEL, select=["XAC007"])
        assert "1 info in 1 file" in found
        assert (await ask(client, "explain", code="MSH001")).startswith("MSH001 missing-file")
        mass = "link/base_link/inertial/mass@value"
        assert "= 8.2" in await ask(client, "trace", path=MODEL, element=mass)

        image = await client.call_tool("render", {"path": MODEL, "view": "front"})
        (content,) = image.content
        assert content.type == "image"
        assert base64.b64decode(content.data).startswith(b"\x89PNG")

    converse(program(workspace), conversation)


def test_unknown_arguments_are_rejected(workspace: Path) -> None:
    async def conversation(client: Client) -> None:
        for tool in (await client.list_tools()).tools:
            assert tool.input_schema["additionalProperties"] is False
        reason = await failure(client, "check", path=MODEL, codes=["XAC007"])
        assert "codes" in reason
        assert "Extra inputs are not permitted" in reason

    talk(workspace, conversation)


def test_a_long_answer_is_read_page_by_page(
    workspace: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["expand", str(workspace / MODEL)]) == 0
    whole = capsys.readouterr().out.splitlines()

    async def conversation(client: Client) -> None:
        lines: list[str] = []
        while len(lines) < len(whole):
            page = await ask(client, "expand", path=MODEL, start=len(lines) + 1)
            *shown, last = page.splitlines()
            start, end = len(lines) + 1, len(lines) + len(shown)
            lines += shown
            if last.startswith("["):
                more = f"start={end + 1} shows more]"
                assert last == f"[lines {start} to {end} of {len(whole)}; {more}"
            else:
                lines.append(last)
        # The banner names the file as it was given.
        assert [line for line in lines if "|" not in line] == [
            line for line in whole if "|" not in line
        ]
        reason = await failure(client, "expand", path=MODEL, start=9999)
        assert f"only {len(whole)} lines" in reason

    talk(workspace, conversation)


def test_a_fix_is_a_diff_until_writing_is_allowed(workspace: Path) -> None:
    file = workspace / MODEL
    before = file.read_bytes()

    async def looks(client: Client) -> None:
        diff = await ask(client, "fix", path=MODEL, unsafe=True, select=["URD008"])
        assert f"--- {MODEL}" in diff
        assert "started without --write" in await failure(client, "fix", path=MODEL, write=True)
        safe = await ask(client, "fix", path=MODEL, select=["URD008"])
        assert "unsafe fix: needs --unsafe-fixes" in safe
        assert "0 would be fixed" in await ask(client, "fix", path=MODEL, select=["XML"])

    talk(workspace, looks)
    assert file.read_bytes() == before

    async def writes(client: Client) -> None:
        await ask(client, "fix", path=MODEL, unsafe=True, select=["URD008"])
        assert file.read_bytes() == before
        words = {"unsafe": True, "select": ["URD008"]}
        assert "8 fixed" in await ask(client, "fix", path=MODEL, write=True, **words)

    converse(program(workspace, "--write"), writes)
    assert file.read_bytes() != before


@pytest.mark.parametrize(
    ("name", "included"),
    [
        ("shared.xacro", "../shared.xacro"),
        ("a b.xacro", "../a b.xacro"),
        ("a b.xacro", "a b.xacro"),
    ],
)
def test_files_outside_the_workspace_are_rejected(
    workspace: Path, name: str, included: str
) -> None:
    # A repository that is larger than the directory that was given.
    (workspace.parent / ".git").mkdir()
    (workspace / "a b.xacro").symlink_to(workspace.parent / "a b.xacro")
    (workspace.parent / name).write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
        '<xacro:property name="PI" value="3.1415926"/>\n<link name="a${PI}"/>\n</robot>\n'
    )
    (workspace / "r.xacro").write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
        f'<xacro:include filename="{included}"/>\n</robot>\n'
    )
    shared = (workspace.parent / name).read_bytes()

    async def conversation(client: Client) -> None:
        for path in ("../outside.urdf", str(workspace.parent / "outside.urdf"), "link.urdf", "a\0"):
            assert "secret" not in await failure(client, "check", path=path)
            await failure(client, "expand", path=path)
        await failure(client, "check", path="--config=x.toml")
        assert "is not a name" in await failure(client, "explain", code="--rules=evil")
        await failure(client, "check", path=MODEL, select=["--trust"])
        await failure(client, "check", path=MODEL, arguments={"--trust": ""})
        await failure(client, "trace", path=MODEL, element="--trust")
        await failure(client, "render", path=MODEL, view="--trust")
        words = {"path": "r.xacro", "unsafe": True, "select": ["XAC007"]}
        assert name in await ask(client, "fix", **words)
        reason = await failure(client, "fix", write=True, **words)
        assert "outside of the workspace" in reason

    talk(workspace, conversation, may_write=True)
    assert (workspace.parent / name).read_bytes() == shared


def test_modules_of_the_workspace_are_not_imported(workspace: Path) -> None:
    """Whoever starts the server says how Python finds modules; a workspace has no word in it."""
    (workspace / "click.py").write_text("raise SystemExit('imported')")
    (workspace / "yaml.py").write_text("raise SystemExit('imported')")
    from urdfkit.cli.mcp_tools import Tools

    assert Tools(str(workspace), may_write=False).explain("MSH001").startswith("MSH001")


def test_a_missing_sdk_is_reported_with_the_install_command(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("urdfkit.cli.mcp_tools", "mcp.server.mcpserver", "mcp.server"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    monkeypatch.setitem(sys.modules, "mcp", None)
    assert main(["mcp"]) == 2
    assert "urdfkit mcp needs mcp: " in capsys.readouterr().err
    assert main(["mcp", "/no/such"]) == 2
    assert "no such directory" in capsys.readouterr().err


@pytest.mark.parametrize("path", ["a\0b", "a\ud800"])
def test_an_invalid_file_name_is_an_error(path: str, tmp_path: Path) -> None:
    with pytest.raises(ToolError, match="not a valid file name"):
        Tools(str(tmp_path), may_write=False).check(path)
