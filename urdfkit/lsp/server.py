"""The protocol: what clients ask is put to the workspace, and its answers are told them.

All work on robots is done by one thread beside that of the protocol, so that a slow robot never
keeps the server from reading. A text that is changed is checked when no other change has come for
a moment; the rules that open meshes run when it is saved. An error in answering is logged and
answered by nothing: the server lives on.
"""

from __future__ import annotations

import asyncio
import logging
import os
import sys
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from difflib import SequenceMatcher
from itertools import accumulate
from typing import Any, TypeVar

from lsprotocol import types as lsp
from pygls.lsp.server import LanguageServer

from urdfkit import __version__
from urdfkit.diagnostic import Diagnostic, Edit, Severity
from urdfkit.errors import UrdfkitError
from urdfkit.lsp import actions, completion, hover, navigation, outline
from urdfkit.lsp.markup import Page
from urdfkit.lsp.text import Places, to_bytes, to_path, to_uri
from urdfkit.lsp.workspace import Robot, Workspace, slow_rules
from urdfkit.source import Source, Span

Answer = TypeVar("Answer")

#: Seconds without a change after which a text is checked.
QUIET = 0.03
#: The files that a check may read.
PARTS = (
    "**/{package.xml,urdfkit.toml,pyproject.toml,"
    "*.{urdf,xacro,srdf,gazebo,xml,yaml,yml,launch,stl,dae,obj,ply,glb,gltf}}"
)
#: Of the thread that expands robots: xacro recurses in the depth of macros.
_STACK = 64 * 1024 * 1024

_SEVERITIES = {
    Severity.ERROR: lsp.DiagnosticSeverity.Error,
    Severity.WARNING: lsp.DiagnosticSeverity.Warning,
    Severity.INFO: lsp.DiagnosticSeverity.Information,
}
_SYMBOLS = {
    "link": lsp.SymbolKind.Object,
    "joint": lsp.SymbolKind.Event,
    "macro": lsp.SymbolKind.Function,
    "property": lsp.SymbolKind.Variable,
    "argument": lsp.SymbolKind.Constant,
    "material": lsp.SymbolKind.EnumMember,
    "gazebo": lsp.SymbolKind.Module,
    "transmission": lsp.SymbolKind.Interface,
    "group": lsp.SymbolKind.Package,
}
_ITEMS = {
    "tag": lsp.CompletionItemKind.Class,
    "attribute": lsp.CompletionItemKind.Property,
    "name": lsp.CompletionItemKind.Reference,
    "word": lsp.CompletionItemKind.Value,
    "file": lsp.CompletionItemKind.File,
    "folder": lsp.CompletionItemKind.Folder,
    "end": lsp.CompletionItemKind.Text,
}
_log = logging.getLogger(__name__)


class Server(LanguageServer):
    """The language server."""

    def __init__(self) -> None:
        super().__init__("urdfkit", __version__)
        threading.stack_size(_STACK)
        self.worker = ThreadPoolExecutor(1, "robots")
        self.robots = Workspace()
        self.uris: dict[str, str] = {}
        self.places = Places()
        self._waiting: dict[str, asyncio.Task[None]] = {}
        self._told_trouble = ""

    async def ask(self, question: Callable[[], Answer], otherwise: Answer) -> Answer:
        """Let the worker answer; ``otherwise`` if it fails."""
        try:
            return await asyncio.get_running_loop().run_in_executor(self.worker, question)
        except UrdfkitError as error:
            _log.info("%s", error)
        except Exception:  # a bug must not end the server
            _log.exception("no answer")
        return otherwise

    def path(self, uri: str) -> str:
        """The real path of a URI."""
        path = to_path(uri)
        return os.path.realpath(path) if path != uri else uri

    def watch(self) -> None:
        """Let the client tell when files change that no editor shows."""
        workspace = self.client_capabilities.workspace
        watching = workspace.did_change_watched_files if workspace else None
        if not (watching and watching.dynamic_registration):
            return
        options = lsp.DidChangeWatchedFilesRegistrationOptions([lsp.FileSystemWatcher(PARTS)])
        method = lsp.WORKSPACE_DID_CHANGE_WATCHED_FILES
        registration = lsp.Registration("parts", method, options)
        self.client_register_capability(lsp.RegistrationParams([registration]))

    # -------------------------------------------------------------- documents

    def take(self, uri: str) -> str:
        """Take over the text of a document as the client has it; its path."""
        path = self.path(uri)
        self.uris[path] = uri
        text = to_bytes(path, self.workspace.get_text_document(uri).source)
        self.worker.submit(self.robots.set_text, path, text)
        return path

    def check_soon(self, uri: str, *, thorough: bool = False) -> None:
        """Check a text once it has been quiet."""
        if waiting := self._waiting.pop(uri, None):
            waiting.cancel()
        self._waiting[uri] = asyncio.ensure_future(self._check(uri, thorough=thorough))

    async def _check(self, uri: str, *, thorough: bool) -> None:
        await asyncio.sleep(QUIET)
        path = self.path(uri)
        checked = await self.ask(lambda: self.robots.check(path, thorough=thorough), None)
        if checked is None:
            return
        if checked.trouble != self._told_trouble:
            self._told_trouble = checked.trouble
            if checked.trouble:
                params = lsp.ShowMessageParams(lsp.MessageType.Warning, checked.trouble)
                self.window_show_message(params)
        for file, found in checked.diagnostics.items():
            self._publish(file, found)

    def _publish(self, file: str, found: list[Diagnostic]) -> None:
        uri = self.uris.get(file)
        if uri is None:
            if "://" in file or file.startswith("untitled:"):
                return
            uri = to_uri(file)
        diagnostics = [self.diagnostic(one) for one in found]
        self.text_document_publish_diagnostics(lsp.PublishDiagnosticsParams(uri, diagnostics))

    def diagnostic(self, found: Diagnostic) -> lsp.Diagnostic:
        """A finding as the protocol has it; the calls of a macro are related places."""
        message = found.message + (f"\n{found.help}" if found.help else "")
        related = [(note.span, note.message) for note in found.related]
        for call in found.calls[:8]:
            for step in call.via[::-1]:
                verb = "included here" if step.kind == "include" else f"called: {call.message}"
                related.append((step.span, verb))
        return lsp.Diagnostic(
            self.places.range(found.span),
            message,
            _SEVERITIES[found.severity],
            found.code,
            source="urdfkit",
            related_information=[
                lsp.DiagnosticRelatedInformation(self.places.location(span, self.uris), text)
                for span, text in dict.fromkeys(related)
            ],
        )

    # ---------------------------------------------------------------- answers

    def at(self, uri: str, position: lsp.Position) -> tuple[Robot, Page, int]:
        """The robot, the text and the byte that a position means; the worker asks.

        Raises:
            UrdfkitError: the file cannot be read.
        """
        robot, page = self.page(uri)
        return robot, page, self.places.offset(page.source, position)

    def page(self, uri: str) -> tuple[Robot, Page]:
        """The robot and the elements of a file; the worker asks."""
        path = self.path(uri)
        robot = self.robots.robot(path)
        return robot, robot.page(path)

    def locations(self, spans: list[Span]) -> list[lsp.Location]:
        return [self.places.location(span, self.uris) for span in dict.fromkeys(spans)]

    def replaced(self, path: str, text: bytes) -> list[lsp.TextEdit]:
        """Edits of the lines in which a file differs from a text; the worker asks."""
        source = self.robots.robot(path).source(path)
        old, new = source.data.splitlines(keepends=True), text.splitlines(keepends=True)
        starts = [0, *accumulate(map(len, old))]
        edits = []
        for kind, first, last, begin, end in SequenceMatcher(None, old, new).get_opcodes():
            if kind != "equal":
                place = self.places.range(Span(source, starts[first], starts[last]))
                edits.append(lsp.TextEdit(place, b"".join(new[begin:end]).decode()))
        return edits

    def edit(self, edits: tuple[Edit, ...] | list[Edit]) -> lsp.WorkspaceEdit:
        """Edits of texts, for the client to make."""
        changes: dict[str, list[lsp.TextEdit]] = {}
        for span, text in edits:
            location = self.places.location(span, self.uris)
            changes.setdefault(location.uri, []).append(lsp.TextEdit(location.range, text))
        return lsp.WorkspaceEdit(changes)


def make() -> Server:
    """A server with all its features."""
    server = Server()
    _add_documents(server)
    _add_reading(server)
    _add_writing(server)
    _add_mending(server)
    return server


def _add_documents(server: Server) -> None:
    @server.feature(lsp.INITIALIZED)
    def _(params: lsp.InitializedParams) -> None:
        server.worker.submit(slow_rules)  # so that the first check is as fast as the others
        server.places = Places(server.server_capabilities.position_encoding or "utf-16")
        server.watch()

    @server.feature(lsp.TEXT_DOCUMENT_DID_OPEN)
    def _(params: lsp.DidOpenTextDocumentParams) -> None:
        server.take(params.text_document.uri)
        server.check_soon(params.text_document.uri, thorough=True)

    @server.feature(lsp.TEXT_DOCUMENT_DID_CHANGE)
    def _(params: lsp.DidChangeTextDocumentParams) -> None:
        server.take(params.text_document.uri)
        server.check_soon(params.text_document.uri)

    @server.feature(lsp.TEXT_DOCUMENT_DID_SAVE)
    def _(params: lsp.DidSaveTextDocumentParams) -> None:
        server.worker.submit(server.robots.look_again)
        server.check_soon(params.text_document.uri, thorough=True)

    @server.feature(lsp.TEXT_DOCUMENT_DID_CLOSE)
    def _(params: lsp.DidCloseTextDocumentParams) -> None:
        path = server.path(params.text_document.uri)
        server.uris.pop(path, None)
        server.worker.submit(server.robots.close, path)

    @server.feature(lsp.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def _(params: lsp.DidChangeWatchedFilesParams) -> None:
        server.worker.submit(server.robots.look_again)
        for uri in list(server.uris.values()):
            server.check_soon(uri)


def _add_reading(server: Server) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_HOVER)
    async def _(params: lsp.HoverParams) -> lsp.Hover | None:
        def answer() -> lsp.Hover | None:
            robot, page, offset = server.at(params.text_document.uri, params.position)
            found = server.robots.diagnostics(server.path(params.text_document.uri))
            text = hover.hover(robot, page, offset, found)
            return lsp.Hover(lsp.MarkupContent(lsp.MarkupKind.Markdown, text)) if text else None

        return await server.ask(answer, None)

    @server.feature(lsp.TEXT_DOCUMENT_DEFINITION)
    async def _(params: lsp.DefinitionParams) -> list[lsp.Location]:
        def answer() -> list[lsp.Location]:
            at = server.at(params.text_document.uri, params.position)
            return server.locations(navigation.definitions(*at))

        return await server.ask(answer, [])

    @server.feature(lsp.TEXT_DOCUMENT_REFERENCES)
    async def _(params: lsp.ReferenceParams) -> list[lsp.Location]:
        def answer() -> list[lsp.Location]:
            at = server.at(params.text_document.uri, params.position)
            wanted = params.context.include_declaration
            return server.locations(navigation.references(*at, definitions=wanted))

        return await server.ask(answer, [])

    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    async def _(params: lsp.DocumentSymbolParams) -> list[lsp.DocumentSymbol]:
        def answer() -> list[lsp.DocumentSymbol]:
            robot, page = server.page(params.text_document.uri)
            return [_symbol(server.places, entry) for entry in outline.outline(robot, page)]

        return await server.ask(answer, [])


def _add_writing(server: Server) -> None:
    options = lsp.CompletionOptions(trigger_characters=["<", '"', "'", "/", "{", "(", " ", ":"])

    @server.feature(lsp.TEXT_DOCUMENT_COMPLETION, options)
    async def _(params: lsp.CompletionParams) -> list[lsp.CompletionItem]:
        def answer() -> list[lsp.CompletionItem]:
            robot, page, offset = server.at(params.text_document.uri, params.position)
            offers = completion.complete(robot, page, offset)
            return [_item(server.places, page.source, offset, offer) for offer in offers]

        return await server.ask(answer, [])

    @server.feature(lsp.TEXT_DOCUMENT_PREPARE_RENAME)
    async def _(params: lsp.PrepareRenameParams) -> lsp.PrepareRenamePlaceholder | None:
        def answer() -> lsp.PrepareRenamePlaceholder | None:
            at = server.at(params.text_document.uri, params.position)
            name = navigation.renamable(*at)
            return lsp.PrepareRenamePlaceholder(server.places.range(name.span), name.text)

        return await server.ask(answer, None)

    @server.feature(lsp.TEXT_DOCUMENT_RENAME, lsp.RenameOptions(prepare_provider=True))
    async def _(params: lsp.RenameParams) -> lsp.WorkspaceEdit | None:
        def answer() -> lsp.WorkspaceEdit | None:
            at = server.at(params.text_document.uri, params.position)
            try:
                return server.edit(navigation.rename(*at, params.new_name))
            except navigation.CannotRename as error:
                told = lsp.ShowMessageParams(lsp.MessageType.Warning, str(error))
                server.window_show_message(told)
                return None

        return await server.ask(answer, None)


def _add_mending(server: Server) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_FORMATTING)
    async def _(params: lsp.DocumentFormattingParams) -> list[lsp.TextEdit] | None:
        def answer() -> list[lsp.TextEdit]:
            path = server.path(params.text_document.uri)
            return server.replaced(path, server.robots.laid_out(path))

        return await server.ask(answer, None)

    kinds = lsp.CodeActionOptions(
        code_action_kinds=[lsp.CodeActionKind.QuickFix, lsp.CodeActionKind.SourceFixAll]
    )

    @server.feature(lsp.TEXT_DOCUMENT_CODE_ACTION, kinds)
    async def _(params: lsp.CodeActionParams) -> list[lsp.CodeAction]:
        def answer() -> list[lsp.CodeAction]:
            path = server.path(params.text_document.uri)
            if any(kind.startswith("source") for kind in params.context.only or ()):
                return _fix_all(server, path)
            _, page, start = server.at(params.text_document.uri, params.range.start)
            end = server.places.offset(page.source, params.range.end)
            return [
                _action(server, action)
                for found in server.robots.diagnostics(path)
                if found.span.start <= end and start <= found.span.end
                for action in actions.actions(page, found)
            ]

        return await server.ask(answer, [])


def _symbol(places: Places, entry: outline.Entry) -> lsp.DocumentSymbol:
    range_ = places.range(entry.span)
    return lsp.DocumentSymbol(
        entry.name,
        _SYMBOLS[entry.kind],
        range_,
        lsp.Range(range_.start, range_.start),
        detail=entry.detail,
        children=[_symbol(places, child) for child in entry.children],
    )


def _item(
    places: Places, source: Source, offset: int, offer: completion.Offer
) -> lsp.CompletionItem:
    at = places.range(Span(source, offer.start, offset))
    return lsp.CompletionItem(
        offer.text,
        kind=_ITEMS[offer.kind],
        detail=offer.detail or None,
        sort_text=f"{0 if offer.needed else 1}{offer.text}",
        filter_text=offer.text,
        text_edit=lsp.TextEdit(at, offer.text),
    )


def _action(server: Server, action: actions.Action) -> lsp.CodeAction:
    return lsp.CodeAction(
        action.title,
        lsp.CodeActionKind.QuickFix,
        [server.diagnostic(action.diagnostic)],
        action.preferred,
        edit=server.edit(action.edits),
    )


def _fix_all(server: Server, path: str) -> list[lsp.CodeAction]:
    """All safe fixes at once; computed only where they are asked for, as on saving."""
    changes = {
        server.uris.get(file) or to_uri(file): server.replaced(file, text)
        for file, text in server.robots.mended(path).items()
    }
    if not changes:
        return []
    edit = lsp.WorkspaceEdit(changes)
    title = "Apply all fixes that cannot change what the robot does"
    return [lsp.CodeAction(title, lsp.CodeActionKind.SourceFixAll, edit=edit)]


def serve() -> None:
    """Serve one client over standard input and output, until it goes.

    Whatever a library prints goes to standard error: one stray word would break the protocol.
    """
    logging.basicConfig(stream=sys.stderr, level=logging.WARNING)
    with os.fdopen(os.dup(1), "wb", buffering=0) as output:
        os.dup2(2, 1)
        sys.stdout = sys.stderr
        make().start_io(sys.stdin.buffer, output)


__all__: list[Any] = ["Server", "make", "serve"]
