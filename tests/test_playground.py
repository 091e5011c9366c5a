"""The playground in a browser: the same findings as the command line, fixes, links and zips."""

import importlib.util
import json
import os
import shutil
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest

from docs.playground.build import EXAMPLES, build
from tests.conftest import CORPUS, MODELS, needs_corpus
from tests.output.report.browsers import Page, browser, needs_browser

pytestmark = needs_browser

BROKEN = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="mass" value="-1"/>
  <link name="a">
    <inertial>
      <mass value="${mass}"/>
      <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>
    </inertial>
  </link>
  <link name="b"/>
  <joint name="j" type="fixed"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>
</robot>
"""


class Quiet(SimpleHTTPRequestHandler):
    def log_message(self, format: str, *args: Any) -> None:
        """Nothing."""


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Where the playground is served."""
    site = tmp_path_factory.mktemp("site")
    shutil.copy(MODELS.parent / "docs" / "playground" / "index.html", site)
    build(site)
    if not (site / "playground.js").is_file():
        pytest.skip("npm is not installed, or reaches no registry")
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(site)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}/"
    server.shutdown()
    server.server_close()


@pytest.fixture(scope="module")
def page(address: str) -> Iterator[Page]:
    with browser() as opened:
        opened.driver.get(address)
        yield opened


def status(page: Page) -> str:
    return str(page.find("#status").text)


def wait(page: Page, holds: Callable[[], bool]) -> None:
    """Until the page has done what it was told."""
    from selenium.webdriver.support.ui import WebDriverWait

    WebDriverWait(page.driver, 120).until(lambda _: holds(), status(page))


def is_checked(page: Page) -> bool:
    return status(page).startswith("errors: ")


def findings(page: Page) -> list[str]:
    """Path, line, severity and code of each finding."""
    shown = page.driver.find_elements("css selector", "#findings li > small:first-child")
    return [str(one.text).strip() for one in shown]


def printed(directory: Path, named: str = ".") -> list[str]:
    """The same of the command line, in an environment without extras."""
    lean = directory.parent / "lean"
    if not lean.exists():
        lean.mkdir()
        for name in ("click", "urdfkit", "xacro", "yaml"):
            spec = importlib.util.find_spec(name)
            assert spec is not None
            assert spec.origin is not None
            (lean / name).symlink_to(Path(spec.origin).parent)
    done = subprocess.run(
        [sys.executable, "-S", "-m", "urdfkit", "check", named, "--format", "json", "--no-cache"],
        check=False,
        cwd=directory,
        env={**os.environ, "PYTHONPATH": str(lean)},
        capture_output=True,
        text=True,
    )
    assert done.returncode in {0, 1}, done.stderr
    order = ["error", "warning", "info"].index
    found = sorted(json.loads(done.stdout)["diagnostics"], key=lambda one: order(one["severity"]))
    return [f"{one['path']}:{one['line']} {one['severity']} {one['code']}" for one in found]


def test_the_robot_is_drawn_next_to_its_findings(page: Page, address: str) -> None:
    page.driver.get("about:blank")
    page.driver.get(address)
    wait(page, lambda: is_checked(page) and bool(page.find("#scale").text))
    assert page.find("#scale").text == "grid 0.1 m"
    page.find("#view canvas").click()  # in the middle of the view: a link with findings
    chosen = page.driver.find_elements("css selector", "#findings li.chosen")
    assert chosen
    assert all("waking_robot_new.xacro" in one.text for one in chosen)
    assert [one for one in page.errors if "favicon" not in one] == []


@pytest.mark.parametrize(("size", "count"), [(400_000_000, 1), (1, 30_000)])
def test_a_zip_that_a_browser_cannot_hold_is_rejected(
    size: int, count: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import zipfile

    from docs.playground import browser as served

    class Sent(bytes):
        def to_bytes(self) -> bytes:
            return bytes(self)

    monkeypatch.setattr(served, "ROOT", tmp_path / "robot")
    monkeypatch.setattr(zipfile.ZipFile, "extractall", lambda *_: pytest.fail("it was unpacked"))
    with zipfile.ZipFile(tmp_path / "bomb.zip", "w", zipfile.ZIP_DEFLATED) as file:
        for number in range(count):
            with file.open(f"{number}.stl", "w") as member:
                for _ in range(max(size // 10_000_000, 1)):
                    member.write(bytes(min(size, 10_000_000)))
    with pytest.raises(ValueError, match="the playground takes"):
        served.unpack(Sent((tmp_path / "bomb.zip").read_bytes()))


def zipped(work: Path) -> Path:
    """A zip of what is in a directory, next to it."""
    return Path(shutil.make_archive(str(work), "zip", work))


def drop(page: Page, path: Path) -> None:
    """Open a file as if it were chosen, once the robot that the page starts with is checked."""
    wait(page, lambda: is_checked(page))
    page.driver.execute_script("document.getElementById('status').textContent = ''")
    page.find("#open").send_keys(str(path))
    wait(page, lambda: is_checked(page))


@pytest.mark.parametrize("example", EXAMPLES)
def test_an_example_has_the_findings_of_the_command_line(
    page: Page, example: str, tmp_path: Path
) -> None:
    from selenium.webdriver.support.ui import Select

    wait(page, lambda: is_checked(page))
    name = example.rpartition("/")[2]
    page.driver.execute_script("document.getElementById('status').textContent = ''")
    Select(page.find("#example")).select_by_visible_text(name)
    if name == "gazebo_pkg":  # chosen from the start: nothing changes
        page.driver.execute_script(
            "document.getElementById('example').dispatchEvent(new Event('change'))"
        )
    wait(page, lambda: is_checked(page))
    package = tmp_path / "work"
    package.mkdir()
    shutil.copytree(MODELS / example, package / name)
    assert findings(page) == printed(package)
    if name == "gazebo_pkg":
        assert len(findings(page)) > 40


def test_a_zip_is_a_package(page: Page, tmp_path: Path) -> None:
    work = tmp_path / "work"
    (work / "arm").mkdir(parents=True)
    (work / "arm" / "arm.xacro").write_text(
        BROKEN.replace("<link", '<xacro:include filename="macros.xacro"/>\n  <link')
    )
    (work / "arm" / "macros.xacro").write_text("<robot><!-- é --><link name='c'/></robot>")
    drop(page, zipped(work))
    assert findings(page) == printed(work)
    assert "arm/arm.xacro:6 error INE001" in findings(page)


@needs_corpus
@pytest.mark.parametrize("name", ["anymal_c_simple_description", "linorobot2", "turtlebot3"])
def test_a_public_robot_has_the_findings_of_the_command_line(
    page: Page, name: str, tmp_path: Path
) -> None:
    work = tmp_path / "work"
    shutil.copytree(CORPUS / name, work / name)
    drop(page, zipped(work))
    assert findings(page) == printed(work)


def test_a_robot_is_typed_fixed_and_linked(page: Page, address: str, tmp_path: Path) -> None:
    model = tmp_path / "work" / "robot.xacro"
    model.parent.mkdir()
    model.write_text(BROKEN)
    drop(page, model)
    before = findings(page)
    assert before == printed(model.parent, model.name)
    assert page.driver.find_elements("css selector", ".cm-lint-marker-error")
    assert '<mass value="-1"/>' in page.find("#expanded").get_attribute("textContent")

    assert "robot.xacro:10 info JNT020" in findings(page)
    page.driver.execute_script("document.getElementById('status').textContent = ''")
    page.find("#findings button").click()
    wait(page, lambda: is_checked(page))
    assert not [one for one in findings(page) if "JNT020" in one]
    assert "<axis" not in page.find(".cm-content").text

    page.find("#link").click()
    wait(page, lambda: "#" in page.driver.current_url)
    fixed = findings(page)
    linked = page.driver.current_url
    page.driver.get("about:blank")
    page.driver.get(linked)
    wait(page, lambda: is_checked(page))
    assert findings(page) == fixed
