"""Answers to an editor's questions, by the server as a program."""

from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("pygls")
from lsprotocol import types as lsp

from tests.conftest import MISSION
from tests.lsp.edited import XACRO
from tests.lsp.editor import TEXT, Editor, Held, codes, position
from urdfkit.lsp.text import to_path, to_uri
from urdfkit.text.editing.formatter import formatted
from urdfkit.text.source import Source


def test_every_question_has_an_answer(held: Held) -> None:
    async def conversation(editor: Editor) -> None:
        file = editor.open(MISSION, TEXT)
        await editor.until(file.uri, lambda found: "XAC007" in codes(found))
        client, link = editor.client, position(TEXT, '<parent link="base_link"', 16)

        shown = await client.text_document_hover_async(lsp.HoverParams(file, link))
        assert shown.contents.value.startswith("**link** `base_link`\n- 8.2 kg")

        given = await client.text_document_definition_async(lsp.DefinitionParams(file, link))
        assert [(one.uri, one.range.start.line) for one in given] == [(file.uri, 52)]

        used = await client.text_document_references_async(
            lsp.ReferenceParams(lsp.ReferenceContext(True), file, link)
        )
        assert len(used) == TEXT.count('"base_link"')

        tree = await client.text_document_document_symbol_async(lsp.DocumentSymbolParams(file))
        assert (tree[0].name, tree[0].children[0].children[0].name) == ("dummy", "base_footprint")

        offered = await client.text_document_completion_async(lsp.CompletionParams(file, link))
        assert {"base_link", "wheel_1"} <= {item.label for item in offered}

        ready = await client.text_document_prepare_rename_async(lsp.PrepareRenameParams(file, link))
        assert ready.placeholder == "base_link"
        edit = await client.text_document_rename_async(lsp.RenameParams(file, link, "chassis"))
        assert len(edit.changes[file.uri]) == TEXT.count('"base_link"')
        refused = await client.text_document_rename_async(lsp.RenameParams(file, link, "wheel_1"))
        assert refused is None
        assert editor.messages == ["there is already a link 'wheel_1'"]

        here = position(TEXT, 'name="PI"')
        offered = await client.text_document_code_action_async(
            lsp.CodeActionParams(file, lsp.Range(here, here), lsp.CodeActionContext([]))
        )
        fix, accept = offered
        assert (fix.title, fix.kind, fix.is_preferred) == ("Use the built-in pi", "quickfix", False)
        assert [change.new_text for change in fix.edit.changes[file.uri]] == ["${pi}"]
        assert accept.title == "Suppress XAC007 here with a comment"

    held(conversation)


def applied(text: str, edits: Any) -> str:
    """A text after edits as an editor makes them: all at once, places of the text before."""
    lines = text.splitlines(keepends=True)
    for edit in sorted(edits, key=lambda edit: (edit.range.start.line, edit.range.start.character))[
        ::-1
    ]:
        start, end = (
            sum(map(len, lines[: at.line])) + at.character
            for at in (edit.range.start, edit.range.end)
        )
        text = text[:start] + edit.new_text + text[end:]
    return text


def test_formatting_and_all_safe_fixes(held: Held) -> None:
    async def conversation(editor: Editor) -> None:
        file = editor.open(MISSION, TEXT)
        await editor.until(file.uri, lambda found: "JNT020" in codes(found))
        options = lsp.FormattingOptions(2, True)
        params = lsp.DocumentFormattingParams(file, options)
        edits = await editor.client.text_document_formatting_async(params)
        assert applied(TEXT, edits) == formatted(Source.read(MISSION)).decode()
        assert all(edit.range.end.line - edit.range.start.line < 60 for edit in edits)

        child = '    <child link="imu_link"/>\n'
        doubled = TEXT.replace(child, 2 * child)  # JNT020 stays: nobody asked for an info
        editor.retype(file.uri, doubled)
        await editor.until(file.uri, lambda found: "URD007" in codes(found))
        top = lsp.Range(lsp.Position(0, 0), lsp.Position(0, 0))
        only = lsp.CodeActionContext([], [lsp.CodeActionKind.SourceFixAll])
        (action,) = await editor.client.text_document_code_action_async(
            lsp.CodeActionParams(file, top, only)
        )
        mended = applied(doubled, action.edit.changes[file.uri])
        assert mended == TEXT
        editor.retype(file.uri, mended)
        await editor.until(file.uri, lambda found: "URD007" not in codes(found))

        editor.retype(file.uri, TEXT[:200])
        assert await editor.client.text_document_formatting_async(params) is None

    held(conversation)


def test_an_attribute_comes_with_its_quotes(held: Held, tmp_path: Path) -> None:
    async def conversation(editor: Editor) -> None:
        file = editor.open(tmp_path / "r.urdf", "<robot><joint ty/>\n<joint ty='fixed'>")
        for line, character, text in ((0, 16, 'type="$1"'), (1, 9, "type")):
            params = lsp.CompletionParams(file, lsp.Position(line, character))
            items = await editor.client.text_document_completion_async(params)
            (item,) = [one for one in items if one.label == "type"]
            assert item.text_edit.new_text == text

    held(conversation)


def test_a_chain_of_3000_links_has_an_outline(held: Held, tmp_path: Path) -> None:
    links = "".join(f'<link name="l{n}"/>' for n in range(3000))
    joints = "".join(
        f'<joint name="j{n}" type="fixed"><parent link="l{n}"/><child link="l{n + 1}"/></joint>'
        for n in range(2999)
    )

    async def conversation(editor: Editor) -> None:
        text = f'<robot name="r">{links}{joints}</robot>'
        file = editor.open(tmp_path / "r.urdf", text)
        params = lsp.DocumentSymbolParams(file)
        entries = await editor.client.text_document_document_symbol_async(params)
        assert entries[0].name == "l0"
        assert len(entries) > 1

    held(conversation)


def test_values_of_expressions_stand_behind_them(held: Held, tmp_path: Path) -> None:
    text = XACRO.format(
        '<xacro:property name="d" value="0.1"/>\n'
        '<xacro:macro name="wheel" params="name x">\n'
        '<link name="${name}"/>\n'
        '<joint name="${name}_joint" type="fixed"><parent link="base"/><child link="${name}"/>\n'
        '<origin xyz="${x} 0 ${d/3}"/></joint>\n'
        "</xacro:macro>\n"
        '<link name="base"/><xacro:wheel name="a" x="1"/><xacro:wheel name="b" x="2"/>'
    )

    async def conversation(editor: Editor) -> None:
        file = editor.open(tmp_path / "r.xacro", text)
        whole = lsp.Range(lsp.Position(0, 0), lsp.Position(99, 0))
        hints = await editor.client.text_document_inlay_hint_async(lsp.InlayHintParams(file, whole))
        assert [(hint.label, hint.position) for hint in hints] == [
            ("a, b", position(text, '<link name="${name}"', 20)),
            ("a_joint, b_joint", position(text, '"${name}_joint"', 15)),
            ("a, b", position(text, '<child link="${name}"', 21)),
            ("1 0 0.0333333, 2 0 0.0333333", position(text, "${d/3}", 7)),
        ]
        line = position(text, "<child")
        only = lsp.Range(line, line)
        hints = await editor.client.text_document_inlay_hint_async(lsp.InlayHintParams(file, only))
        assert [hint.label for hint in hints] == ["a, b"]

    held(conversation)


def test_files_are_links(held: Held, tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    for name in ("a.stl", "b.stl", "parts.xacro"):
        (tmp_path / name).write_text(XACRO.format(""))
    text = XACRO.format(
        '<xacro:include filename="parts.xacro"/><xacro:include filename="$(find p)/parts.xacro"/>'
        '<link name="l"><visual><geometry><mesh filename="package://p/${\'a\'}.stl"/></geometry>'
        '</visual><collision><geometry><mesh filename="file:///no.stl"/></geometry></collision>'
        "</link>"
    )

    async def conversation(editor: Editor) -> None:
        file = editor.open(tmp_path / "r.xacro", text)
        links = await editor.client.text_document_document_link_async(lsp.DocumentLinkParams(file))
        targets = [Path(to_path(link.target)).name for link in links]
        assert targets == ["parts.xacro", "parts.xacro", "a.stl"]
        assert links[2].range.start == position(text, "package://p/$")
        launch = '<launch><param name="x" textfile="$(find p)/r.xacro"/></launch>'
        (tmp_path / "r.xacro").write_text(text)
        (tmp_path / "l.launch").write_text(launch)
        started = editor.open(tmp_path / "l.launch", launch)
        links = await editor.client.text_document_document_link_async(
            lsp.DocumentLinkParams(started)
        )
        assert [Path(to_path(link.target)).name for link in links] == ["r.xacro"]

    held(conversation)


def test_names_are_found_in_all_files_of_open_robots(held: Held, tmp_path: Path) -> None:
    parts = XACRO.format('<xacro:macro name="leg" params="n"><link name="leg_${n}"/></xacro:macro>')
    (tmp_path / "parts.xacro").write_text(parts)
    text = XACRO.format('<xacro:include filename="parts.xacro"/><xacro:leg n="2"/><link name="b"/>')

    async def conversation(editor: Editor) -> None:
        editor.open(tmp_path / "r.xacro", text)
        ask = editor.client.workspace_symbol_async
        found = await ask(lsp.WorkspaceSymbolParams("LEG"))
        assert [(one.name, one.kind) for one in found] == [
            ("leg", lsp.SymbolKind.Function),
            ("leg_2", lsp.SymbolKind.Object),
        ]
        assert {one.location.uri for one in found} == {to_uri(str(tmp_path / "parts.xacro"))}
        assert [one.name for one in await ask(lsp.WorkspaceSymbolParams("lg2"))] == ["leg_2"]
        assert {one.name for one in await ask(lsp.WorkspaceSymbolParams(""))} == {
            *("b", "leg", "leg_2")
        }

    held(conversation)
