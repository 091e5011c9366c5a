"""The server as a program, talked to by a real client over standard input and output."""

import asyncio
import os
import random
import sys
import threading
from pathlib import Path

import pytest

pytest.importorskip("pygls")
from lsprotocol import types as lsp

import urdfkit
from tests.conftest import MISSION, ROOT
from tests.lsp.edited import XACRO
from tests.lsp.editor import PATIENCE, TEXT, Editor, Held, codes, position, talk
from tests.workspaces import add_file
from tests.xacros import xacro
from urdfkit.core.installation import install_command
from urdfkit.lsp.main_thread import MainThreadExecutor
from urdfkit.lsp.text import to_uri
from urdfkit.lsp.workspace import slow_rules


def test_findings_while_typing(held: Held) -> None:
    async def conversation(editor: Editor) -> None:
        file = editor.open(MISSION, TEXT)
        expected = [found.code for found in urdfkit.check(MISSION).diagnostics]
        await editor.until(file.uri, lambda found: codes(found) == expected)
        pi = next(one for one in editor.found[file.uri] if one.code == "XAC007")
        assert pi.severity == lsp.DiagnosticSeverity.Information
        assert pi.source == "urdfkit"
        assert pi.range == lsp.Range(lsp.Position(8, 2), lsp.Position(8, 47))
        # One character of it, as an editor sends it.
        at = position(TEXT, 'value="3.1415926"', 7)
        end = lsp.Position(at.line, at.character + 9)
        editor.change(file.uri, lsp.TextDocumentContentChangePartial(lsp.Range(at, end), "${pi}"))
        await editor.until(file.uri, lambda found: "XAC007" not in codes(found))
        # Findings of what the text broke, then the others again but for those that wait.
        soon = [code for code in expected if code not in slow_rules()]
        assert len(soon) > 40
        editor.retype(file.uri, TEXT.replace("</robot>", "<link nam"))
        await editor.until(file.uri, lambda found: "XML001" in codes(found))
        editor.retype(file.uri, TEXT)
        await editor.until(file.uri, lambda found: codes(found) == soon)
        params = lsp.DidSaveTextDocumentParams(file)
        editor.client.text_document_did_save(params)
        await editor.until(file.uri, lambda found: codes(found) == expected)

    held(conversation)


def test_calls_of_a_macro_are_related_places(held: Held) -> None:
    async def conversation(editor: Editor) -> None:
        file = editor.open(MISSION, TEXT)
        await editor.until(file.uri, lambda found: "INE006" in codes(found))
        wheel = next(one for one in editor.found[file.uri] if one.code == "INE006")
        places = wheel.related_information or []
        assert [place.location.range.start.line for place in places] == [30, 90, 111, 132, 153]
        assert "link 'wheel_4'" in places[-1].message

    held(conversation)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16", "utf-32"])
def test_positions_count_as_the_client_counts(tmp_path: Path, encoding: str) -> None:
    text = '<robot name="轮🦾"><link name="é🦾a"/><link name="é🦾a"/></robot>'
    unit = {"utf-8": ("utf-8", 1), "utf-16": ("utf-16-le", 2), "utf-32": ("utf-32-le", 4)}[encoding]

    def units(piece: str) -> int:
        return len(piece.encode(unit[0])) // unit[1]

    async def conversation(editor: Editor) -> None:
        file = editor.open(tmp_path / "轮.urdf", text)
        await editor.until(file.uri, lambda found: "NAM001" in codes(found))
        (found,) = [one for one in editor.found[file.uri] if one.code == "NAM001"]
        start = text.rindex("é🦾a")
        assert found.range.start.character == units(text[:start])
        assert found.range.end.character == units(text[: start + 3])
        at = lsp.Position(0, units(text[: start + 2]))
        shown = await editor.client.text_document_hover_async(lsp.HoverParams(file, at))
        assert shown.contents.value.startswith("**link** `é🦾a`")

    talk(conversation, encoding)


def test_nothing_that_is_typed_ends_the_server(held: Held, tmp_path: Path) -> None:
    """Damaged texts, and at each every question at any place: all are answered, none fails."""
    chance = random.Random(11)
    junk = ["<", ">", '"', "${", "$(", "}", "</", "<!--", "&", "\x00", "\r", "轮", "]]>", "<xacro:"]

    async def conversation(editor: Editor) -> None:
        file = editor.open(tmp_path / "r.xacro", TEXT)
        for _ in range(20):
            text = TEXT
            for _ in range(chance.randrange(1, 4)):
                at, until = sorted(chance.choices(range(len(text)), k=2))
                until = min(until, at + 200)
                text = text[:at] + chance.choice(junk) + text[until:]
            editor.retype(file.uri, text)
            line = chance.randrange(text.count("\n") + 2)
            here = lsp.Position(line, chance.randrange(120))
            client = editor.client
            await asyncio.wait_for(
                asyncio.gather(
                    client.text_document_hover_async(lsp.HoverParams(file, here)),
                    client.text_document_completion_async(lsp.CompletionParams(file, here)),
                    client.text_document_definition_async(lsp.DefinitionParams(file, here)),
                    client.text_document_document_symbol_async(lsp.DocumentSymbolParams(file)),
                    client.text_document_references_async(
                        lsp.ReferenceParams(lsp.ReferenceContext(True), file, here)
                    ),
                    client.text_document_prepare_rename_async(lsp.PrepareRenameParams(file, here)),
                    client.text_document_code_action_async(
                        lsp.CodeActionParams(file, lsp.Range(here, here), lsp.CodeActionContext([]))
                    ),
                ),
                PATIENCE,
            )
        editor.retype(file.uri, TEXT)
        await editor.until(file.uri, lambda found: "XAC007" in codes(found))
        assert editor.messages == []

    held(conversation)


def test_standard_error_has_no_traceback_after_damage(tmp_path: Path) -> None:
    """An answer that fails inside is logged there, so silence means that none did."""

    async def session() -> bytes:
        editor = Editor()
        await editor.start()
        file = editor.open(tmp_path / "r.xacro", TEXT)
        for end in range(0, len(TEXT), 661):
            editor.retype(file.uri, TEXT[:end])
            lines = TEXT[:end].split("\n")
            here = lsp.Position(len(lines) - 1, len(lines[-1]))
            await editor.client.text_document_completion_async(lsp.CompletionParams(file, here))
            await editor.client.text_document_hover_async(lsp.HoverParams(file, here))
        assert await editor.stop() == 0
        errors: bytes = await editor.client._server.stderr.read()
        return errors

    assert asyncio.run(session()) == b""


def test_closing_and_files_that_change_on_disk(held: Held, tmp_path: Path) -> None:
    parts, top = tmp_path / "parts.xacro", tmp_path / "top.xacro"
    head = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    parts.write_text(f'{head}<link name="a"/></robot>')
    text = f'{head}<xacro:include filename="parts.xacro"/></robot>'
    top.write_text(text)

    async def conversation(editor: Editor) -> None:
        file = editor.open(top, text)
        await editor.until(file.uri, lambda found: "INE004" in codes(found))
        assert editor.registered == [lsp.WORKSPACE_DID_CHANGE_WATCHED_FILES]
        parts.write_text(f'{head}<link name="a"/><link name="a"/></robot>')
        change = lsp.FileEvent(to_uri(str(parts)), lsp.FileChangeType.Changed)
        editor.client.workspace_did_change_watched_files(lsp.DidChangeWatchedFilesParams([change]))
        await editor.until(to_uri(str(parts)), lambda found: "NAM001" in codes(found))
        # Nobody looks at the robot any more: its findings go, those of other files, too.
        editor.client.text_document_did_close(lsp.DidCloseTextDocumentParams(file))
        await editor.until(file.uri, lambda found: found == [])
        await editor.until(to_uri(str(parts)), lambda found: found == [])

    held(conversation)


def test_a_text_without_end_does_not_stop_the_others(held: Held, tmp_path: Path) -> None:
    (tmp_path / "urdfkit.toml").write_text("xacro-seconds = 0.5")
    endless = (
        '<xacro:macro name="m" params="n"><xacro:if value="${n}"><xacro:m n="${n-1}"/>'
        '<xacro:m n="${n-1}"/></xacro:if></xacro:macro><xacro:m n="40"/>'
    )

    async def conversation(editor: Editor) -> None:
        bomb = editor.open(tmp_path / "bomb.xacro", XACRO.format(endless))
        text = XACRO.format('<link name="arm"/>')
        file = editor.open(tmp_path / "arm.xacro", text)
        here = position(text, '"arm"', 2)
        shown = await editor.client.text_document_hover_async(lsp.HoverParams(file, here))
        assert "**link** `arm`" in shown.contents.value
        await editor.until(bomb.uri, lambda found: codes(found) == ["XAC013"])

    held(conversation)


def test_robots_are_read_in_the_main_thread() -> None:
    """Where the system can interrupt an expansion."""
    executor = MainThreadExecutor()
    thread = executor.submit(threading.current_thread)
    failing = executor.submit(int, "x")
    threading.Thread(target=executor.shutdown).start()
    executor.run()
    assert thread.result() is threading.main_thread()
    with pytest.raises(ValueError, match="'x'"):
        failing.result()


def test_a_client_that_pulls_gets_no_finding_twice(tmp_path: Path) -> None:
    (tmp_path / "parts.xacro").write_text(XACRO.format('<link name="a"/><link name="a"/>'))
    text = XACRO.format('<xacro:include filename="parts.xacro"/><link name="b"/><link name="b"/>')

    async def conversation(editor: Editor) -> None:
        file = editor.open(tmp_path / "r.xacro", text)
        parts = to_uri(str(tmp_path / "parts.xacro"))
        assert "NAM001" in codes(await editor.pull(file))
        await editor.until_refreshed(1)
        # Of a file that is not open, nobody pulls.
        await editor.until(parts, lambda found: "NAM001" in codes(found))
        assert editor.found.get(file.uri, []) == []
        editor.retype(file.uri, text.replace('<link name="b"/><link', '<link name="c"/><link'))
        assert "NAM001" not in codes(await editor.pull(file))
        await editor.until_refreshed(2)
        opened = editor.open(tmp_path / "parts.xacro", (tmp_path / "parts.xacro").read_text())
        await editor.until(parts, lambda found: found == [])
        assert "NAM001" in codes(await editor.pull(opened))
        assert editor.found[parts] == []

    talk(conversation, pulls=True)


def test_without_pygls_it_says_what_to_install(tmp_path: Path) -> None:
    (tmp_path / "pygls").mkdir()
    (tmp_path / "pygls" / "__init__.py").write_text("raise ModuleNotFoundError(name='pygls')")
    done = asyncio.run(_run(tmp_path))
    assert done == (2, f"error: urdfkit lsp needs pygls: {install_command('lsp')}\n")


async def _run(directory: Path) -> tuple[int | None, str]:
    environment = {**os.environ, "PYTHONPATH": f"{directory}{os.pathsep}{ROOT}"}
    process = await asyncio.create_subprocess_exec(
        *(sys.executable, "-m", "urdfkit", "lsp"),
        env=environment,
        stderr=asyncio.subprocess.PIPE,
        stdin=asyncio.subprocess.DEVNULL,
    )
    _, errors = await process.communicate()
    return process.returncode, errors.decode()


def test_the_variants_that_have_a_finding_are_in_its_message(held: Held, tmp_path: Path) -> None:
    reference = '<gazebo reference="am"><mu1>1</mu1></gazebo>'
    block = f'<xacro:if value="$(arg sim)">{reference}</xacro:if>'
    body = f'<xacro:arg name="sim" default="false"/><link name="arm"/>{block}'
    robot = add_file(tmp_path / "robot.urdf.xacro", xacro(body))

    async def conversation(editor: Editor) -> None:
        file = editor.open(robot, robot.read_text())
        await editor.until(file.uri, lambda found: "GAZ001" in codes(found))
        (one,) = (one for one in editor.found[file.uri] if one.code == "GAZ001")
        assert one.message.splitlines()[0].endswith(" (variants: sim=true)")

    held(conversation)
