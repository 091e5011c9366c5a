"""The viewer: the report page on a local address, updated whenever a file is saved.

It listens on 127.0.0.1 only, and all addresses begin with an unguessable token, so that other
programs and other pages in the browser have no access. The host name is checked as well, against
DNS rebinding.
"""

from __future__ import annotations

import asyncio
import json
import os
import secrets
import socket
import threading
from collections.abc import AsyncIterator, Callable
from concurrent.futures import Future
from functools import partial
from typing import TYPE_CHECKING, TypeVar

from urdfkit.core.installation import needing
from urdfkit.errors import Unavailable, UrdfkitError
from urdfkit.lint.options import Options
from urdfkit.output.report import html
from urdfkit.output.report.engine import load as load_engine
from urdfkit.output.report.scene import nothing
from urdfkit.output.report.translations import Translator
from urdfkit.viewer.state import ViewerState, completed, read

if TYPE_CHECKING:
    from starlette.applications import Starlette
    from starlette.requests import Request
    from starlette.responses import Response

T = TypeVar("T")

HOST = "127.0.0.1"
#: Seconds between checks of the files. Polling works on every file system, and with editors that
#: replace a file by a new one.
POLL_SECONDS = 0.4
#: Size limit of the arguments that a page sends, in bytes.
MAX_BODY = 100_000

_HEADERS = {
    "Cache-Control": "no-store",
    # Directives for loaded resources are in the page; these are effective only in a header.
    "Content-Security-Policy": "frame-ancestors 'none'; form-action 'none'; base-uri 'none'",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}


class Viewer:
    """A robot, and the events of the pages that show it.

    Attributes:
        file: a URDF or xacro file.
        options: of its check.
        state: the last state that was read.
        revision: the number of events so far.
        shape: number of the robot's 3D model, so that pages need not load the same model again.
        error: error of the last attempt to read; empty if it succeeded.
    """

    def __init__(self, file: str, options: Options, translator: Translator) -> None:
        self.file = file
        self.options = options
        self.translator = translator
        self.state: ViewerState = read(file, options)
        self.revision = self.shape = 1
        self.error = ""
        self._changed = asyncio.Event()
        self._completion_lock = asyncio.Lock()
        self._completing: asyncio.Task[None] | None = None

    async def watch(self) -> None:
        """Read the robot again whenever a file changes, until the process ends."""
        self._completing = asyncio.create_task(self._complete(self.state))
        while True:
            await asyncio.sleep(POLL_SECONDS)
            have_changed = await asyncio.to_thread(lambda: self.state.files.have_changed)
            if self.error or have_changed:
                await self.refresh()

    async def refresh(self) -> None:
        """Read the robot again, and notify the pages."""
        try:
            self.state = await asyncio.to_thread(read, self.file, self.options)
            self.error = ""
            self.shape += 1
            self._completing = asyncio.create_task(self._complete(self.state))
        except Exception as error:  # the file may come back; a bug must not end the viewer
            is_bug = not isinstance(error, UrdfkitError)
            message = f"internal error: {type(error).__name__}: {error}" if is_bug else str(error)
            if self.error == message:
                return
            self.error = message
        self._notify()

    async def _complete(self, state: ViewerState) -> None:
        """Complete a state with the slow results, unless it is outdated."""
        async with self._completion_lock:
            if state is self.state:
                complete = await _in_thread(completed, state)
                if state is self.state:
                    self.state = complete
                    self._notify()

    def _notify(self) -> None:
        """Notify the pages of a new revision."""
        self.revision += 1
        self._changed.set()
        self._changed = asyncio.Event()

    async def revisions(self) -> AsyncIterator[int]:
        """The current revision and all following ones."""
        while True:
            changed = self._changed
            yield self.revision
            await changed.wait()

    def page(self) -> str:
        """The page with the current state."""
        page = partial(html.render, shape=self.shape)  # an outdated number only costs a reload
        state = self.state
        try:
            scene = state.scene or nothing()
        except Unavailable:
            return page(state.document, self.translator, state.drawings)
        return page(state.document, self.translator, state.drawings, scene, load_engine())

    def message(self, shown: str = "") -> dict[str, object]:
        """The state as a message to an open page.

        Args:
            shown: number of the 3D model that the page shows.
        """
        return {
            **self.state.message(self.translator, with_scene=shown != str(self.shape)),
            "revision": self.revision,
            "shape": self.shape,
            "error": self.error,
        }


async def _in_thread(work: Callable[[T], T], argument: T) -> T:
    """The result of a function, computed in a thread that Ctrl-C does not wait for."""
    future: Future[T] = Future()
    future.set_running_or_notify_cancel()  # it can no longer be cancelled

    def run() -> None:
        try:
            future.set_result(work(argument))
        except Exception as error:
            future.set_exception(error)

    threading.Thread(target=run, daemon=True).start()
    return await asyncio.wrap_future(future)


def application(viewer: Viewer, token: str) -> Starlette:
    """The server of a viewer, as an ASGI application.

    Args:
        token: first part of all paths.

    Raises:
        UrdfkitError: Starlette is not installed.
    """
    with needing("the viewer", "report"):
        from starlette.applications import Starlette
        from starlette.middleware import Middleware
        from starlette.middleware.trustedhost import TrustedHostMiddleware
        from starlette.responses import HTMLResponse, JSONResponse, Response, StreamingResponse
        from starlette.routing import Route

    async def page(request: Request) -> Response:
        return HTMLResponse(await asyncio.to_thread(viewer.page), headers=_HEADERS)

    async def state(request: Request) -> Response:
        shown = request.query_params.get("shown", "")
        return JSONResponse(await asyncio.to_thread(viewer.message, shown), headers=_HEADERS)

    async def events(request: Request) -> Response:
        stream = (f"data: {revision}\n\n" async for revision in viewer.revisions())
        return StreamingResponse(stream, headers=_HEADERS, media_type="text/event-stream")

    async def arguments(request: Request) -> Response:
        new = _arguments(await request.body())
        if new is None:
            return Response(status_code=400)
        merged = {**viewer.options.arguments, **new}
        viewer.options = viewer.options._replace(arguments=merged)
        await viewer.refresh()
        return Response(status_code=204)

    return Starlette(
        routes=[
            Route(f"/{token}/", page),
            Route(f"/{token}/state", state),
            Route(f"/{token}/events", events),
            Route(f"/{token}/arguments", arguments, methods=["POST"]),
        ],
        middleware=[Middleware(TrustedHostMiddleware, allowed_hosts=[HOST])],
    )


def _arguments(body: bytes) -> dict[str, str] | None:
    """The arguments that a page sends; None if the body is invalid."""
    try:
        content = json.loads(body) if len(body) <= MAX_BODY else None
    except (ValueError, RecursionError):
        return None
    if not isinstance(content, dict) or not all(isinstance(text, str) for text in content.values()):
        return None
    return content


def serve(
    file: str,
    options: Options,
    translator: Translator,
    *,
    port: int = 0,
    opened: Callable[[str], None] = print,
) -> None:
    """Show a robot until Ctrl-C.

    Args:
        port: to listen on; a free one if 0.
        opened: called with the address when the page is available.

    Raises:
        UrdfkitError: the robot's file is missing, the port is taken, or a library is missing.
        KeyboardInterrupt: Ctrl-C.
    """
    with needing("the viewer", "report"):
        import uvicorn

    try:
        listening = socket.create_server((HOST, port))  # accepts connections before the server runs
    except OSError as error:
        raise UrdfkitError(f"port {port} of {HOST}: {os.strerror(error.errno or 0)}") from error
    token = secrets.token_urlsafe(24)

    async def run() -> None:
        viewer = Viewer(file, options, translator)
        app = application(viewer, token)
        config = uvicorn.Config(
            app,
            log_level="critical",
            lifespan="off",
            server_header=False,
            timeout_graceful_shutdown=1,
        )
        watching = asyncio.create_task(viewer.watch())
        opened(f"http://{HOST}:{listening.getsockname()[1]}/{token}/")
        try:
            await uvicorn.Server(config).serve(sockets=[listening])
        finally:
            watching.cancel()

    with listening:
        asyncio.run(run())
