"""The viewer as a process: who gets an answer, and what a saved file does."""

import asyncio
import json
import re
import shutil
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.conftest import GRIPPER, MODELS, ROOT
from tests.output.report.browsers import browser, needs_browser

for module in ("jinja2", "numpy", "starlette", "trimesh", "uvicorn"):
    pytest.importorskip(module)

from urdfkit.errors import UnreadableFile
from urdfkit.lint.options import Options
from urdfkit.output.report.translations import Translator
from urdfkit.viewer import server

BASE = MODELS / "good" / "mobile_base"


#: The command, with small images: they are drawn anew after every change.
VIEW = """
import sys
from urdfkit.cli import main
from urdfkit.output.report import data_uris
data_uris.SHEET = data_uris.MARKED = (128, 72)
sys.exit(main(["view", *sys.argv[1:]]))
"""


class Running:
    """A viewer of a copy of a robot."""

    def __init__(self, directory: Path, *more: str) -> None:
        shutil.copytree(BASE, directory / "mobile_base")
        self.robot = directory / "mobile_base" / "urdf" / "mobile_base.urdf.xacro"
        words = [sys.executable, "-c", VIEW, str(self.robot), "--no-open", *more]
        self.process = subprocess.Popen(words, cwd=ROOT, stderr=subprocess.PIPE, text=True)
        assert self.process.stderr
        self.address = self.process.stderr.readline().strip()

    def get(self, path: str = "", body: bytes | None = None, **headers: str) -> tuple[int, bytes]:
        request = urllib.request.Request(self.address + path, body, headers)
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return answer.status, answer.read()
        except urllib.error.HTTPError as error:
            return error.code, error.read()

    def state(self, wanted: Callable[[Any], bool] = lambda state: True) -> Any:
        """The state, as soon as it is one that is wanted."""
        for _ in range(200):
            state = json.loads(self.get("state")[1])
            if wanted(state):
                return state
            time.sleep(0.1)
        raise AssertionError("no such state")

    def after(self, before: Any) -> Any:
        """The state as soon as the robot was read again."""
        return self.state(lambda state: state["shape"] > before["shape"])

    def edit(self, old: str, new: str, file: Path | None = None) -> None:
        path = file or self.robot
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new), encoding="utf-8")

    def end(self) -> None:
        self.process.terminate()
        self.process.wait(10)
        assert self.process.stderr
        self.process.stderr.close()


@pytest.fixture(scope="module")
def viewer(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    running = Running(tmp_path_factory.mktemp("viewer"))
    try:
        yield running
    finally:
        running.end()


def test_it_answers_at_a_local_address_that_nobody_guesses(viewer: Running) -> None:
    match = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/([\w-]{32})/", viewer.address)
    assert match
    status, page = viewer.get()
    assert status == 200
    assert b"mobile_base" in page
    for address in ("../", "../" + "x" * 32 + "/", "../state"):
        assert viewer.get(address)[0] == 404
    assert viewer.get(Host="robots.example.org")[0] == 400
    assert viewer.get(Host=f"127.0.0.1:{match[1]}")[0] == 200


def test_the_page_may_load_from_here_only(viewer: Running) -> None:
    page = viewer.get()[1].decode()
    assert "connect-src &#39;self&#39; blob: data:" in page
    assert "unsafe-eval" not in page


HOST = "Host: 127.0.0.1"

#: Requests as they are on the wire, with ``TOKEN``, and the answers that they may have.
RAW = {
    "the page": (f"GET /TOKEN/ HTTP/1.1|{HOST}", {200}),
    "its head": (f"HEAD /TOKEN/ HTTP/1.1|{HOST}", {200}),
    "no host": ("GET /TOKEN/ HTTP/1.1", {400}),
    "no host of old": ("GET /TOKEN/ HTTP/1.0", {400}),
    "a name": ("GET /TOKEN/ HTTP/1.1|Host: localhost", {400}),
    "a name that leads here": ("GET /TOKEN/ HTTP/1.1|Host: 127.0.0.1.example.org", {400}),
    "a user": ("GET /TOKEN/ HTTP/1.1|Host: 127.0.0.1@example.org", {400}),
    "a number": ("GET /TOKEN/ HTTP/1.1|Host: 2130706433", {400}),
    "two hosts": (f"GET /TOKEN/ HTTP/1.1|Host: example.org|{HOST}", {400}),
    "a proxy": ("GET http://example.org/TOKEN/ HTTP/1.1|Host: example.org", {400}),
    "forwarded": ("GET /TOKEN/ HTTP/1.1|Host: example.org|X-Forwarded-Host: 127.0.0.1", {400}),
    "no token": (f"GET / HTTP/1.1|{HOST}", {404}),
    "half a token": (f"GET /TOKE/ HTTP/1.1|{HOST}", {404}),
    "above": (f"GET /TOKEN/../../../../etc/passwd HTTP/1.1|{HOST}", {404}),
    "above, encoded": (f"GET /TOKEN/%2e%2e/%2e%2e/etc/passwd HTTP/1.1|{HOST}", {404}),
    "slashes, encoded": (f"GET /TOKEN/..%2f..%2fetc%2fpasswd HTTP/1.1|{HOST}", {404}),
    "encoded twice": (f"GET /TOKEN/%252e%252e%252fetc%252fpasswd HTTP/1.1|{HOST}", {404}),
    "absolute": (f"GET //etc/passwd HTTP/1.1|{HOST}", {404}),
    "a NUL": (f"GET /TOKEN/state%00 HTTP/1.1|{HOST}", {404}),
    **{
        f"{method} {path}": (f"{method} /TOKEN/{path} HTTP/1.1|{HOST}|Content-Length: 0", {405})
        for method in ("PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "PROPFIND")
        for path in ("", "state", "arguments")
    },
    "POST": (f"POST /TOKEN/ HTTP/1.1|{HOST}|Content-Length: 0", {405}),
    "GET arguments": (f"GET /TOKEN/arguments HTTP/1.1|{HOST}", {405}),
    "CONNECT": (f"CONNECT 127.0.0.1:22 HTTP/1.1|{HOST}", {400, 404, 405}),
    "nonsense": ("\x16\x03\x01", {400}),
    "a long line": (f"GET /{'a' * 20_000} HTTP/1.1|{HOST}", {400, 404, 414, 431}),
}


@pytest.mark.parametrize("name", RAW)
def test_what_is_sent_to_it(viewer: Running, name: str) -> None:
    request, statuses = RAW[name]
    _, _, port, token = re.split("//|:|/", viewer.address.removeprefix("http:"))[:4]
    data = request.replace("TOKEN", token).replace("|", "\r\n") + "\r\nConnection: close\r\n\r\n"
    with socket.create_connection(("127.0.0.1", int(port)), timeout=60) as wire:
        wire.sendall(data.encode("latin-1"))
        answer = b"".join(iter(lambda: wire.recv(65_536), b""))
    assert int(answer.split(b" ")[1]) in statuses
    assert b"root:" not in answer
    if name == "its head":
        assert b"mobile_base" not in answer
    if 200 in statuses:
        head = answer.partition(b"\r\n\r\n")[0].lower()
        for line in (
            b"content-security-policy: frame-ancestors 'none'",
            b"x-content-type-options: nosniff",
            b"referrer-policy: no-referrer",
            b"cache-control: no-store",
            b"cross-origin-resource-policy: same-origin",
        ):
            assert line in head


def test_it_listens_on_this_machine_alone(viewer: Running) -> None:
    port = int(viewer.address.split(":")[2].partition("/")[0])
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
        one.connect(("192.0.2.1", 9))  # nothing is sent; it only chooses an address
        own = one.getsockname()[0]
    if own.startswith("127."):
        pytest.skip("this machine has no other address")
    with pytest.raises(OSError, match=r"refused|timed out"):
        socket.create_connection((own, port), timeout=5)


@pytest.mark.parametrize("body", [b"", b"[]", b'{"a": 1}', b"{" * 90_000, b" " * 200_000])
def test_nonsense_is_refused(viewer: Running, body: bytes) -> None:
    assert viewer.get("arguments", body or b"\0")[0] == 400


def test_every_file_of_the_robot_is_watched(viewer: Running) -> None:
    before = viewer.state()
    assert before["files"] == 5  # also two of the package
    dimensions = viewer.robot.parents[1] / "config" / "dimensions.yaml"
    viewer.edit("mass: 6.0", "mass: 7.0", dimensions)
    after = viewer.after(before)
    masses = {link["name"]: link.get("mass") for link in after["robot"]["links"]}
    assert masses["base_link"] == 7.0
    included = viewer.robot.parent / "inertials.xacro"
    viewer.edit("</robot>", "</robot><oops>", included)
    broken = viewer.after(after)
    assert broken["readable"] is False
    assert "model" not in broken
    assert "inertials.xacro" in broken["content"]
    viewer.edit("<oops>", "", included)
    assert viewer.after(broken)["readable"] is True


def test_what_takes_a_while_follows(viewer: Running) -> None:
    dimensions = viewer.robot.parents[1] / "config" / "dimensions.yaml"
    viewer.edit("# Lengths", "# All lengths", dimensions)
    whole = viewer.state(lambda state: state["whole"] and state["readable"])
    for section in ("pictures", "statics", "collisions"):
        assert f'<section id="{section}">' in whole["content"]
    same = json.loads(viewer.get(f"state?shown={whole['shape']}")[1])
    assert same["content"] == whole["content"]
    assert "model" not in same
    assert "model" in whole


def test_a_file_that_goes_and_comes_back(viewer: Running) -> None:
    text = viewer.robot.read_text(encoding="utf-8")
    viewer.robot.unlink()
    gone = viewer.state(lambda state: state["error"])
    assert "mobile_base.urdf.xacro" in gone["error"]
    viewer.robot.write_text(text, encoding="utf-8")
    assert viewer.after(gone)["error"] == ""


def test_arguments_are_those_of_the_xacro(viewer: Running) -> None:
    before = viewer.state()
    assert before["declared"] == {"prefix": ""}
    assert viewer.get("arguments", b'{"prefix": "left_"}')[0] == 204
    after = viewer.after(before)
    assert after["declared"] == {"prefix": "left_"}
    assert after["robot"]["links"][0]["name"] == "left_base_footprint"
    viewer.get("arguments", b'{"prefix": ""}')


@needs_browser
def test_an_open_page_follows(viewer: Running) -> None:
    pytest.importorskip("selenium")
    viewer.get("arguments", b'{"prefix": ""}')
    before = viewer.state()
    viewer.edit('velocity="20"', 'velocity="0"')
    viewer.after(before)
    with browser() as page:
        page.open(viewer.address)
        page.run("urdfkit.move('left_wheel_joint', 0.5)")
        shown = "return document.querySelectorAll('.finding:not([hidden])').length"
        assert page.run(shown) > 0
        page.run("document.querySelector('.filter [name=words]').value = 'no such words'")
        before = page.run("return urdfkit.frame('left_wheel')")
        viewer.edit('xyz="0.08 ', 'xyz="0.18 ')
        viewer.edit('effort="5"', 'effort="0"')
        seen = (
            "new Promise((done) => { const look = () => { const at = urdfkit.frame('left_wheel');"
            f" if (Math.abs(at[12] - {before[12]}) > 1e-6) done(at);"
            " else setTimeout(look, 50); }; look(); })"
        )
        after = page.wait(seen)
        assert after[12] - before[12] == pytest.approx(0.1)  # it moved, and
        assert after[:12] == pytest.approx(before[:12])  # the joint is where it was put
        assert page.run(shown) == 0  # and the filter stays
        field = page.find("#arguments input[name=prefix]")
        field.send_keys("r_")
        page.find("#arguments button").click()
        page.wait(
            "new Promise((done) => { const look = () => document.querySelector("
            "'[data-link=r_base_link]') ? done(1) : setTimeout(look, 50); look(); })"
        )
        assert page.errors == []


def test_a_port_that_is_taken_is_said(viewer: Running, capfd: pytest.CaptureFixture[str]) -> None:
    from urdfkit.cli import main

    port = viewer.address.split(":")[2].partition("/")[0]
    assert main(["view", str(viewer.robot), "--no-open", "--port", port]) == 2
    assert f"port {port} of 127.0.0.1" in capfd.readouterr().err
    assert main(["view", "none.urdf", "--no-open"]) == 2


def test_a_port_is_free_as_soon_as_its_viewer_has_ended(tmp_path: Path) -> None:
    first = Running(tmp_path / "first")
    assert first.get("../")[0] == 404  # sooner answered than the page
    first.end()
    again = Running(tmp_path / "again", "--port", first.address.split(":")[2].partition("/")[0])
    try:
        assert again.get("../")[0] == 404
    finally:
        again.end()


@pytest.mark.parametrize(
    ("error", "reported"),
    [
        (UnreadableFile("r.urdf: file not found"), "r.urdf: file not found"),
        (ValueError("boom"), "internal error: ValueError: boom"),
    ],
)
def test_what_fails_is_reported_once_and_does_not_end_the_viewer(
    error: Exception, reported: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = str(GRIPPER)

    async def follow() -> tuple[str, int, str]:
        viewer = server.Viewer(file, Options(), Translator())
        with monkeypatch.context() as broken:
            broken.setattr(server, "read", fail)
            await viewer.refresh()
            await viewer.refresh()
        message, revision = viewer.error, viewer.revision
        await viewer.refresh()
        return message, revision, viewer.error

    def fail(*_: object) -> None:
        raise error

    assert asyncio.run(follow()) == (reported, 2, "")
