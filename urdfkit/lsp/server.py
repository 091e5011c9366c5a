"""The protocol: requests of clients go to the workspace, its answers to the clients.

All work on robots is done by a second thread, so that a slow robot never keeps the server from
reading. A text that is changed is checked when no other change has come for a moment, and a check
of a text that has changed since ends before its next rule. The rules that open meshes run when it
is saved. An error in answering is logged and answered by nothing: the server lives on.
"""

from __future__ import annotations

import asyncio
import gc
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
from urdfkit.errors import UrdfkitError
from urdfkit.lsp.markup import Page
from urdfkit.lsp.open_robot import OpenRobot
from urdfkit.lsp.text import PositionEncoding, to_bytes, to_path, to_uri
from urdfkit.lsp.workspace import Workspace, slow_rules
from urdfkit.text.diagnostic import Diagnostic, Edit, Severity
from urdfkit.text.source import Span
from urdfkit.text.terminal import printable

Answer = TypeVar("Answer")

#: Seconds without a change after which a text is checked.
QUIET = 0.03
#: The files that a check may read.
PARTS = (
    "**/{package.xml,urdfkit.toml,pyproject.toml,"
    "*.{urdf,xacro,srdf,gazebo,xml,yaml,yml,launch,launch.py,stl,dae,obj,ply,glb,gltf}}"
)
#: Of the thread that expands robots: xacro recurses in the depth of macros.
_STACK = 64 * 1024 * 1024
#: New objects after which garbage is collected during a check: several large robots. It is
#: collected after each check, when nobody waits for findings.
_GARBAGE = 1_000_000

_SEVERITIES = {
    Severity.ERROR: lsp.DiagnosticSeverity.Error,
    Severity.WARNING: lsp.DiagnosticSeverity.Warning,
    Severity.INFO: lsp.DiagnosticSeverity.Information,
}
_log = logging.getLogger(__name__)


class Server(LanguageServer):
    """The language server."""

    def __init__(self) -> None:
        super().__init__("urdfkit", __version__)
        threading.stack_size(_STACK)
        self.worker = ThreadPoolExecutor(1, "robots")
        self.worker.submit(_prepare)
        self.robots = Workspace()
        self.uris: dict[str, str] = {}
        self.places = PositionEncoding()
        self._waiting: dict[str, asyncio.Task[None]] = {}
        self._first: dict[str, asyncio.Event] = {}  # set when the quick rules have run
        self._shown_failure = ""

    async def ask(self, question: Callable[[], Answer], otherwise: Answer) -> Answer:
        """Let the worker answer; ``otherwise`` if it fails."""
        try:
            return await asyncio.get_running_loop().run_in_executor(self.worker, question)
        except UrdfkitError as error:
            _log.info("%s", error)
        except Exception:  # a bug must not end the server
            _log.exception("no answer")
        return otherwise

    def answer(
        self,
        request: str,
        question: Callable[[Server, Any], object],
        otherwise: object,
        options: object = None,
    ) -> None:
        """Let the worker answer a kind of requests.

        Args:
            question: computes the answer of the parameters of a request.
            options: of the method, which the client is sent.
        """

        async def handle(params: Any) -> object:
            return await self.ask(lambda: question(self, params), otherwise)

        self.feature(request, options)(handle)

    def path(self, uri: str) -> str:
        path = to_path(uri)
        return os.path.realpath(path) if path != uri and "\0" not in path else uri

    @property
    def takes_snippets(self) -> bool:
        """True if what is completed may hold a place for the cursor."""
        asked = self.client_capabilities.text_document
        items = asked.completion.completion_item if asked and asked.completion else None
        return bool(items and items.snippet_support)

    def watch(self) -> None:
        """Ask the client to report changes of files that are not open."""
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
        self.forget(uri)
        self._first[uri] = asyncio.Event()
        self._waiting[uri] = asyncio.ensure_future(self._check(uri, thorough=thorough))

    def forget(self, uri: str) -> None:
        """A text is closed: a check that it waits for is of no use any more."""
        if waiting := self._waiting.pop(uri, None):
            waiting.cancel()
        if first := self._first.pop(uri, None):
            first.set()

    async def checked(self, uri: str) -> list[Diagnostic]:
        """What the check of the text as it is now finds in it, as soon as there is one."""
        while (first := self._first.get(uri)) and not first.is_set():
            await first.wait()  # a newer check may have taken its place
        path = self.path(uri)
        nothing: list[Diagnostic] = []
        return await self.ask(lambda: self.robots.diagnostics(path), nothing)

    async def _check(self, uri: str, *, thorough: bool) -> None:
        first = self._first[uri]
        await asyncio.sleep(QUIET)
        await self._publish_findings(uri, thorough=False)
        first.set()
        if thorough:  # what takes longer comes behind what does not
            await self._publish_findings(uri, thorough=True)
        self._ask_to_pull()
        if self._waiting.get(uri) is asyncio.current_task():
            self.worker.submit(gc.collect)  # the robot that was checked, full of circles

    # ---------------------------------------------- clients that pull findings

    @property
    def _is_pulled(self) -> bool:
        """True of a client that asks for the findings of a file that it has open."""
        asked = self.client_capabilities.text_document
        return bool(asked and asked.diagnostic)

    def leave_to_pull(self, uri: str) -> None:
        """A file is opened: what was published of it is asked for from now on."""
        if self._is_pulled:
            self.text_document_publish_diagnostics(lsp.PublishDiagnosticsParams(uri, []))

    def _ask_to_pull(self) -> None:
        """Tell a client that pulls that there may be other findings."""
        workspace = self.client_capabilities.workspace
        asked = workspace.diagnostics if workspace else None
        if self._is_pulled and asked and asked.refresh_support:
            self.workspace_diagnostic_refresh(None)

    async def _publish_findings(self, uri: str, *, thorough: bool) -> None:
        path, task = self.path(uri), asyncio.current_task()

        def is_cancelled() -> bool:
            return self._waiting.get(uri) is not task

        checked = await self.ask(
            lambda: self.robots.check(path, thorough=thorough, is_cancelled=is_cancelled), None
        )
        if checked is None:
            return
        if checked.failure != self._shown_failure:
            self._shown_failure = checked.failure
            if checked.failure:
                params = lsp.ShowMessageParams(lsp.MessageType.Warning, checked.failure)
                self.window_show_message(params)
        for file, found in checked.diagnostics.items():
            self.publish(file, found)

    def publish(self, file: str, found: list[Diagnostic]) -> None:
        uri = self.uris.get(file)
        if uri is None:
            if "://" in file or file.startswith("untitled:"):
                return
            uri = to_uri(file)
        if self._is_pulled and uri in self.workspace.text_documents:
            return
        diagnostics = [self.diagnostic(one) for one in found]
        self.text_document_publish_diagnostics(lsp.PublishDiagnosticsParams(uri, diagnostics))

    def diagnostic(self, found: Diagnostic) -> lsp.Diagnostic:
        """A finding as the protocol has it; the calls of a macro are related places."""
        texts = (found.message, found.help) if found.help else (found.message,)
        message = "\n".join(map(printable, texts))
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
                lsp.DiagnosticRelatedInformation(
                    self.places.location(span, self.uris), printable(text)
                )
                for span, text in dict.fromkeys(related)
            ],
        )

    # ---------------------------------------------------------------- answers

    def at(self, uri: str, position: lsp.Position) -> tuple[OpenRobot, Page, int]:
        """The robot, the text and the byte that a position means; called by the worker.

        Raises:
            UrdfkitError: the file cannot be read.
        """
        robot, page = self.page(uri)
        return robot, page, self.places.offset(page.source, position)

    def page(self, uri: str) -> tuple[OpenRobot, Page]:
        """The robot and the elements of a file; called by the worker."""
        path = self.path(uri)
        robot = self.robots.robot(path)
        return robot, robot.page(path)

    def locations(self, spans: list[Span]) -> list[lsp.Location]:
        return [self.places.location(span, self.uris) for span in dict.fromkeys(spans)]

    def replaced(self, path: str, text: bytes) -> list[lsp.TextEdit]:
        """Edits of the lines in which a file differs from a text; called by the worker."""
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


def _prepare() -> None:
    """Import the rules, and leave them out of the search for garbage."""
    slow_rules()
    gc.collect()
    gc.freeze()


def serve(server: Server) -> None:
    """Serve one client over standard input and output, until it goes.

    Whatever a library prints goes to standard error: one stray word would break the protocol.
    """
    logging.basicConfig(stream=sys.stderr, level=logging.WARNING)
    gc.set_threshold(_GARBAGE)
    with os.fdopen(os.dup(1), "wb", buffering=0) as output:
        os.dup2(2, 1)
        sys.stdout = sys.stderr
        server.start_io(sys.stdin.buffer, output)
