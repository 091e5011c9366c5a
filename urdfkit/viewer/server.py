"""The viewer: the page of a report on a local address, sent anew whenever a file is saved.

It listens on 127.0.0.1 alone, and every address begins with a token that nobody can guess: other
programs and other pages of the browser get nothing. The name of the host is checked as well, so
that no foreign name can be made to lead here (DNS rebinding).
"""

from __future__ import annotations

import asyncio
import json
import os
import secrets
import socket
import threading
from collections.abc import AsyncIterator, Callable
from contextlib import suppress
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
#: Seconds between two looks at the files. They are looked at, not watched: that works on every
#: file system, and with editors that write a new file in place of the old one.
PAUSE = 0.4
#: Characters of all arguments that a page may send.
MAX_BODY = 100_000

_HEADERS = {
    "Cache-Control": "no-store",
    # What a page loads is in the page itself; these directives only count here.
    "Content-Security-Policy": "frame-ancestors 'none'; form-action 'none'; base-uri 'none'",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}


class Viewer:
    """One robot, the pages that show it, and the events that they get.

    Attributes:
        file: a URDF or xacro file.
        options: of its check.
        state: what was read last.
        revision: the number of events so far.
        shape: counts the robots; the 3D view need not be sent again for the same one.
        error: why the last attempt to read gave nothing; empty if it did.
    """

    def __init__(self, file: str, options: Options, translator: Translator) -> None:
        self.file = file
        self.options = options
        self.translator = translator
        self.state: ViewerState = read(file, options)
        self.revision = self.shape = 1
        self.error = ""
        self._changed = asyncio.Event()
        self._one_at_a_time = asyncio.Lock()
        self._completing: asyncio.Task[None] | None = None

    async def watch(self) -> None:
        """Read the robot again whenever a file changes, until the process ends."""
        self._completing = asyncio.create_task(self._complete(self.state))
        while True:
            await asyncio.sleep(PAUSE)
            if await asyncio.to_thread(lambda: self.state.is_stale):
                await self.refresh()

    async def refresh(self) -> None:
        """Read the robot again, and notify the pages."""
        try:
            self.state = await asyncio.to_thread(read, self.file, self.options, self.state.versions)
            self.error = ""
            self.shape += 1
            self._completing = asyncio.create_task(self._complete(self.state))
        except Exception as error:  # a file that is gone may come back; nor may a bug end this
            is_bug = not isinstance(error, UrdfkitError)
            what = f"internal error: {type(error).__name__}: {error}" if is_bug else str(error)
            if self.error == what:
                return
            self.error = what
        self._notify()

    async def _complete(self, state: ViewerState) -> None:
        """Add what takes a while, unless there is another state by then."""
        async with self._one_at_a_time:
            if state is self.state:
                whole = await _aside(completed, state)
                if state is self.state:
                    self.state = whole
                    self._notify()

    def _notify(self) -> None:
        """Tell the pages that there is something new."""
        self.revision += 1
        self._changed.set()
        self._changed = asyncio.Event()

    async def revisions(self) -> AsyncIterator[int]:
        """The number of the state, now and whenever there is another one."""
        while True:
            changed = self._changed
            yield self.revision
            await changed.wait()

    def page(self) -> str:
        """The page, with the state as it is."""
        page = partial(html.render, shape=self.shape)  # an older number costs no more than time
        state = self.state
        try:
            scene = state.scene or nothing()
        except Unavailable:
            return page(state.document, self.translator, state.drawings)
        return page(state.document, self.translator, state.drawings, scene, load_engine())

    def message(self, shown: str = "") -> dict[str, object]:
        """The state for a page that is open.

        Args:
            shown: the number of the robot that its 3D view shows.
        """
        return {
            **self.state.message(self.translator, with_scene=shown != str(self.shape)),
            "revision": self.revision,
            "shape": self.shape,
            "error": self.error,
        }


async def _aside(work: Callable[[T], T], thing: T) -> T:
    """What a function makes of a thing, in a thread that Ctrl-C does not wait for."""
    loop = asyncio.get_running_loop()
    made: asyncio.Future[T] = loop.create_future()

    def run() -> None:
        try:
            result, failed = work(thing), None
        except Exception as error:
            result, failed = thing, error
        with suppress(RuntimeError):  # the loop has ended meanwhile
            if failed is None:
                loop.call_soon_threadsafe(made.set_result, result)
            else:
                loop.call_soon_threadsafe(made.set_exception, failed)

    threading.Thread(target=run, daemon=True).start()
    return await made


def application(viewer: Viewer, token: str) -> Starlette:
    """The server of a viewer, as an ASGI application.

    Args:
        token: the first part of every address.

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
        given = _arguments(await request.body())
        if given is None:
            return Response(status_code=400)
        merged = {**viewer.options.arguments, **given}
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
    """The arguments that a page sends; None if it is nothing of the kind."""
    try:
        given = json.loads(body) if len(body) <= MAX_BODY else None
    except (ValueError, RecursionError):
        return None
    if not isinstance(given, dict) or not all(isinstance(text, str) for text in given.values()):
        return None
    return given


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
        port: to listen at; a free one if 0.
        opened: called with the address when the page is to be had.

    Raises:
        UrdfkitError: the robot's file is missing, the port is taken, or a library is missing.
        KeyboardInterrupt: Ctrl-C.
    """
    with needing("the viewer", "report"):
        import uvicorn

    try:
        listening = socket.create_server((HOST, port))  # a browser that comes early waits
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
