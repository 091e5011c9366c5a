"""The protocol: requests of the client are answered by the workspace.

All work on robots is done in the main thread, where the limits of an expansion apply, and the
protocol runs in a second thread, so that a slow robot does not block it. A changed text is checked
after a short pause in typing; the check of an outdated text ends before its next rule. The rules
that open meshes run on saving. Errors of handlers are logged and answered with an empty result: the
server does not end.
"""

from __future__ import annotations

import asyncio
import gc
import logging
import os
import sys
import threading
from collections.abc import Callable
from difflib import SequenceMatcher
from itertools import accumulate
from typing import Any, TypeVar

from lsprotocol import types as lsp
from pygls.capabilities import get_capability
from pygls.lsp.server import LanguageServer

from urdfkit import __version__
from urdfkit.core.grouping import by_key
from urdfkit.errors import UrdfkitError
from urdfkit.lsp.main_thread import MainThreadExecutor
from urdfkit.lsp.markup import Markup
from urdfkit.lsp.open_robot import OpenRobot
from urdfkit.lsp.text import PositionEncoding, to_bytes, to_path, to_uri
from urdfkit.lsp.workspace import Workspace, slow_rules
from urdfkit.text.diagnostic import Diagnostic, Edit, Severity
from urdfkit.text.source import Span
from urdfkit.text.terminal import printable

Result = TypeVar("Result")

#: Seconds without a change after which a text is checked.
DEBOUNCE = 0.03
#: Files that a check may read.
WATCHED = (
    "**/{package.xml,urdfkit.toml,pyproject.toml,"
    "*.{urdf,xacro,srdf,gazebo,xml,yaml,yml,launch,launch.py,stl,dae,obj,ply,glb,gltf}}"
)
#: New objects after which garbage is collected during a check: several large robots. Garbage is
#: also collected after each check.
_GARBAGE_THRESHOLD = 1_000_000

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
        self.worker = MainThreadExecutor()
        self.worker.submit(_prepare)
        self.robots = Workspace()
        self.uris: dict[str, str] = {}
        self.encoding = PositionEncoding()
        self._pending_checks: dict[str, asyncio.Task[None]] = {}
        self._quick_checks: dict[str, asyncio.Event] = {}  # set when the fast rules have run
        self._shown_failure = ""

    async def in_worker(self, handler: Callable[[], Result], fallback: Result) -> Result:
        """Run a function in the main thread; ``fallback`` if it fails."""
        try:
            return await asyncio.get_running_loop().run_in_executor(self.worker, handler)
        except UrdfkitError as error:
            _log.info("%s", error)
        except Exception:  # a bug must not end the server
            _log.exception("no answer")
        return fallback

    def register(
        self,
        request: str,
        handler: Callable[[Server, Any], object],
        fallback: object,
        options: object = None,
    ) -> None:
        """Answer a type of requests by a handler in the main thread.

        Args:
            handler: returns the result for the parameters of a request.
            options: of the request type, sent to the client.
        """

        async def handle(params: Any) -> object:
            return await self.in_worker(lambda: handler(self, params), fallback)

        self.feature(request, options)(handle)

    def path(self, uri: str) -> str:
        path = to_path(uri)
        return os.path.realpath(path) if path != uri and "\0" not in path else uri

    def _client_supports(self, capability: str) -> bool:
        return bool(get_capability(self.client_capabilities, capability))

    @property
    def supports_snippets(self) -> bool:
        """True if completions may contain a placeholder for the cursor."""
        return self._client_supports("text_document.completion.completion_item.snippet_support")

    def watch(self) -> None:
        """Ask the client to report changes of files that are not open."""
        if not self._client_supports("workspace.did_change_watched_files.dynamic_registration"):
            return
        options = lsp.DidChangeWatchedFilesRegistrationOptions([lsp.FileSystemWatcher(WATCHED)])
        method = lsp.WORKSPACE_DID_CHANGE_WATCHED_FILES
        registration = lsp.Registration("parts", method, options)
        self.client_register_capability(lsp.RegistrationParams([registration]))

    # -------------------------------------------------------------- documents

    def update_text(self, uri: str) -> None:
        """Update the text of a document from the client."""
        path = self.path(uri)
        self.uris[path] = uri
        text = to_bytes(path, self.workspace.get_text_document(uri).source)
        self.worker.submit(self.robots.set_text, path, text)

    def check_soon(self, uri: str, *, thorough: bool = False) -> None:
        """Check a text after a pause without changes."""
        self.cancel_check(uri)
        self._quick_checks[uri] = asyncio.Event()
        self._pending_checks[uri] = asyncio.ensure_future(self._check(uri, thorough=thorough))

    def cancel_check(self, uri: str) -> None:
        """Cancel the pending check of a text."""
        if waiting := self._pending_checks.pop(uri, None):
            waiting.cancel()
        if done := self._quick_checks.pop(uri, None):
            done.set()

    async def checked(self, uri: str) -> list[Diagnostic]:
        """The findings of the current text, as soon as it is checked."""
        while (done := self._quick_checks.get(uri)) and not done.is_set():
            await done.wait()  # a newer check may have replaced it
        path = self.path(uri)
        nothing: list[Diagnostic] = []
        return await self.in_worker(lambda: self.robots.diagnostics(path), nothing)

    async def _check(self, uri: str, *, thorough: bool) -> None:
        done = self._quick_checks[uri]
        await asyncio.sleep(DEBOUNCE)
        await self._publish_findings(uri, thorough=False)
        done.set()
        if thorough:  # the slow rules run last
            await self._publish_findings(uri, thorough=True)
        self._request_refresh()
        if self._pending_checks.get(uri) is asyncio.current_task():
            self.worker.submit(gc.collect)  # frees the checked robot, which has reference cycles

    # ---------------------------------------------- clients that pull findings

    @property
    def _pulls_diagnostics(self) -> bool:
        """True if the client pulls the findings of open files."""
        return self._client_supports("text_document.diagnostic")

    def clear_published(self, uri: str) -> None:
        """Clear the published findings of an opened file, which the client pulls from now on."""
        if self._pulls_diagnostics:
            self.text_document_publish_diagnostics(lsp.PublishDiagnosticsParams(uri, []))

    def _request_refresh(self) -> None:
        """Request that a pulling client refreshes its findings."""
        can_refresh = self._client_supports("workspace.diagnostics.refresh_support")
        if self._pulls_diagnostics and can_refresh:
            self.workspace_diagnostic_refresh(None)

    async def _publish_findings(self, uri: str, *, thorough: bool) -> None:
        path, task = self.path(uri), asyncio.current_task()

        def is_cancelled() -> bool:
            return self._pending_checks.get(uri) is not task

        checked = await self.in_worker(
            lambda: self.robots.check(path, thorough=thorough, is_cancelled=is_cancelled), None
        )
        if checked is None:
            return
        if checked.failure != self._shown_failure:
            self._shown_failure = checked.failure
            if checked.failure:
                params = lsp.ShowMessageParams(lsp.MessageType.Warning, checked.failure)
                self.window_show_message(params)
        for file, diagnostics in checked.diagnostics.items():
            self.publish(file, diagnostics)

    def publish(self, file: str, findings: list[Diagnostic]) -> None:
        uri = self.uris.get(file)
        if uri is None:
            if "://" in file or file.startswith("untitled:"):
                return
            uri = to_uri(file)
        if self._pulls_diagnostics and uri in self.workspace.text_documents:
            return
        diagnostics = [self.diagnostic(finding) for finding in findings]
        self.text_document_publish_diagnostics(lsp.PublishDiagnosticsParams(uri, diagnostics))

    def diagnostic(self, finding: Diagnostic) -> lsp.Diagnostic:
        """A finding for the protocol; macro calls are related locations."""
        texts = filter(None, (finding.message_with_variants, finding.help))
        message = "\n".join(map(printable, texts))
        related = [(note.span, note.message) for note in finding.related]
        for call in finding.calls[:8]:
            for step in call.via[::-1]:
                verb = "included here" if step.kind == "include" else f"called: {call.message}"
                related.append((step.span, verb))
        return lsp.Diagnostic(
            self.encoding.range(finding.span),
            message,
            _SEVERITIES[finding.severity],
            finding.code,
            source="urdfkit",
            related_information=[
                lsp.DiagnosticRelatedInformation(
                    self.encoding.location(span, self.uris), printable(text)
                )
                for span, text in dict.fromkeys(related)
            ],
        )

    # ---------------------------------------------------------------- answers

    def at(self, uri: str, position: lsp.Position) -> tuple[OpenRobot, Markup, int]:
        """The robot, the text and the offset of a position; runs in the main thread.

        Raises:
            UrdfkitError: the file is unreadable.
        """
        robot, markup = self.markup(uri)
        return robot, markup, self.encoding.offset(markup.source, position)

    def markup(self, uri: str) -> tuple[OpenRobot, Markup]:
        """The robot and the elements of a file; runs in the main thread."""
        path = self.path(uri)
        robot = self.robots.robot(path)
        return robot, robot.markup(path)

    def locations(self, spans: list[Span]) -> list[lsp.Location]:
        return [self.encoding.location(span, self.uris) for span in dict.fromkeys(spans)]

    def replaced(self, path: str, text: bytes) -> list[lsp.TextEdit]:
        """Edits of the lines in which a file differs from a text; runs in the main thread."""
        source = self.robots.robot(path).source(path)
        old, new = source.data.splitlines(keepends=True), text.splitlines(keepends=True)
        starts = [0, *accumulate(map(len, old))]
        edits = []
        for kind, first, last, begin, end in SequenceMatcher(None, old, new).get_opcodes():
            if kind != "equal":
                place = self.encoding.range(Span(source, starts[first], starts[last]))
                edits.append(lsp.TextEdit(place, b"".join(new[begin:end]).decode()))
        return edits

    def edit(self, edits: tuple[Edit, ...] | list[Edit]) -> lsp.WorkspaceEdit:
        """Text edits for the client."""
        places = ((self.encoding.location(span, self.uris), text) for span, text in edits)
        return lsp.WorkspaceEdit(
            by_key((place.uri, lsp.TextEdit(place.range, text)) for place, text in places)
        )


def _prepare() -> None:
    """Import the rules, and exclude them from garbage collection."""
    slow_rules()
    gc.collect()
    gc.freeze()


def serve(server: Server) -> None:
    """Serve a client over standard input and output until it disconnects.

    Output of libraries is redirected to standard error: it would break the protocol.
    """
    logging.basicConfig(stream=sys.stderr, level=logging.WARNING)
    gc.set_threshold(_GARBAGE_THRESHOLD)
    with os.fdopen(os.dup(1), "wb", buffering=0) as output:
        os.dup2(2, 1)
        sys.stdout = sys.stderr

        def exchange_messages() -> None:
            try:
                server.start_io(sys.stdin.buffer, output)
            finally:
                server.worker.shutdown()

        threading.Thread(target=exchange_messages).start()
        server.worker.run()
