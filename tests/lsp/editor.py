"""A real client of the server, and a whole session with it."""

import asyncio
import sys
from collections.abc import Awaitable, Callable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

from lsprotocol import types as lsp
from pygls.lsp.client import LanguageClient

from tests.conftest import MISSION, ROOT
from urdfkit.lsp.text import to_uri

TEXT = MISSION.read_text(encoding="utf-8")

#: Seconds that a test waits for anything.
PATIENCE = 30


class Editor:
    """A client with some open files."""

    def __init__(self) -> None:
        self.client: Any = LanguageClient("editor", "1")
        self.found: dict[str, list[lsp.Diagnostic]] = {}
        self.messages: list[str] = []
        self.registered: list[str] = []
        self.refreshed = 0
        self.versions: dict[str, int] = {}
        self._news = asyncio.Condition()
        self.initialized: Any = None

        async def take(params: lsp.PublishDiagnosticsParams) -> None:
            async with self._news:
                self.found[params.uri] = list(params.diagnostics)
                self._news.notify_all()

        def register(params: lsp.RegistrationParams) -> None:
            self.registered += [one.method for one in params.registrations]

        def hear(params: lsp.ShowMessageParams) -> None:
            self.messages.append(params.message)

        self.client.feature(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)(take)
        self.client.feature(lsp.WINDOW_SHOW_MESSAGE)(hear)

        async def refresh(params: None) -> None:
            async with self._news:
                self.refreshed += 1
                self._news.notify_all()

        self.client.feature(lsp.CLIENT_REGISTER_CAPABILITY)(register)
        self.client.feature(lsp.WORKSPACE_DIAGNOSTIC_REFRESH)(refresh)

    async def start(self, encoding: str | None = None, *, pulls: bool = False) -> None:
        await self.client.start_io(sys.executable, "-m", "urdfkit", "lsp", "--stdio", cwd=ROOT)
        general = lsp.GeneralClientCapabilities(
            position_encodings=[lsp.PositionEncodingKind(encoding)] if encoding else None
        )
        watching = lsp.DidChangeWatchedFilesClientCapabilities(dynamic_registration=True)
        item = lsp.ClientCompletionItemOptions(snippet_support=True)
        completion = lsp.CompletionClientCapabilities(completion_item=item)
        capabilities = lsp.ClientCapabilities(
            general=general,
            text_document=lsp.TextDocumentClientCapabilities(
                completion=completion,
                diagnostic=lsp.DiagnosticClientCapabilities() if pulls else None,
            ),
            workspace=lsp.WorkspaceClientCapabilities(
                did_change_watched_files=watching,
                diagnostics=lsp.DiagnosticWorkspaceClientCapabilities(refresh_support=pulls),
            ),
        )
        params = lsp.InitializeParams(capabilities=capabilities)
        self.initialized = await self.client.initialize_async(params)
        self.client.initialized(lsp.InitializedParams())

    async def stop(self) -> int | None:
        """Leave, and return the exit code of the server."""
        await self.client.shutdown_async(None)
        self.client.exit(None)
        await asyncio.wait_for(self.client._server.wait(), PATIENCE)
        await self.client.stop()
        code: int | None = self.client._server.returncode
        return code

    def open(self, path: Path, text: str) -> lsp.TextDocumentIdentifier:
        uri = to_uri(str(path))
        self.versions[uri] = 1
        item = lsp.TextDocumentItem(uri, "xacro", 1, text)
        self.client.text_document_did_open(lsp.DidOpenTextDocumentParams(item))
        return lsp.TextDocumentIdentifier(uri)

    async def close_all(self) -> None:
        """Close the open files; what was found in them is not there for the next conversation."""
        for uri in self.versions:
            file = lsp.TextDocumentIdentifier(uri)
            self.client.text_document_did_close(lsp.DidCloseTextDocumentParams(file))
        for uri in list(self.found):
            await self.until(uri, lambda found: found == [])
        for seen in (self.versions, self.found, self.messages):
            seen.clear()

    def change(self, uri: str, *changes: Any) -> None:
        self.versions[uri] += 1
        self.client.text_document_did_change(
            lsp.DidChangeTextDocumentParams(
                lsp.VersionedTextDocumentIdentifier(self.versions[uri], uri), list(changes)
            )
        )

    def retype(self, uri: str, text: str) -> None:
        self.change(uri, lsp.TextDocumentContentChangeWholeDocument(text))

    async def pull(self, file: lsp.TextDocumentIdentifier) -> list[lsp.Diagnostic]:
        """Ask for the findings of a file."""
        params = lsp.DocumentDiagnosticParams(file)
        report = await self.client.text_document_diagnostic_async(params)
        assert report.kind == "full"
        return list(report.items)

    async def until_refreshed(self, count: int) -> None:
        """Wait until the server has said so often that there are other findings."""
        async with self._news:
            await asyncio.wait_for(self._news.wait_for(lambda: self.refreshed >= count), PATIENCE)

    async def until(self, uri: str, wanted: Callable[[list[lsp.Diagnostic]], bool]) -> None:
        """Wait for findings."""
        async with self._news:
            await asyncio.wait_for(
                self._news.wait_for(lambda: uri in self.found and wanted(self.found[uri])), PATIENCE
            )


def position(text: str, needle: str, skip: int = 0) -> lsp.Position:
    """Behind some characters of a piece of ASCII text."""
    at = text.index(needle) + skip
    return lsp.Position(text.count("\n", 0, at), at - text.rfind("\n", 0, at) - 1)


def codes(found: list[lsp.Diagnostic]) -> list[str]:
    return [str(one.code) for one in found]


Conversation = Callable[[Editor], Awaitable[None]]
Held = Callable[[Conversation], None]


def talk(conversation: Conversation, encoding: str | None = None, *, pulls: bool = False) -> None:
    """A whole session; it ends in good order."""
    with session(encoding, pulls=pulls) as held:
        held(conversation)


@contextmanager
def session(encoding: str | None = None, *, pulls: bool = False) -> Iterator[Held]:
    """A server for several conversations; it ends in good order."""
    editor = Editor()

    async def hold(conversation: Conversation) -> None:
        try:
            await conversation(editor)
        finally:
            await editor.close_all()

    with closing(asyncio.new_event_loop()) as loop:
        loop.run_until_complete(editor.start(encoding, pulls=pulls))
        yield lambda conversation: loop.run_until_complete(hold(conversation))
        assert loop.run_until_complete(editor.stop()) == 0
