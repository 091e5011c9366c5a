"""The extension in VS Code itself: code-server, which is VS Code behind a web page, in a browser.

It runs where `code-server` is on the PATH (``npm install --global code-server``) and URDFKIT_VSIX
names the packaged extension; ``.ci/run`` packages it.
"""

import json
import os
import re
import shutil
import socket
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote
from urllib.request import urlopen

import pytest

from tests.output.report.browsers import Page, browser, needs_browser
from urdfkit import check
from urdfkit.text.diagnostic import Severity

pytest.importorskip("pygls")

CODE_SERVER = shutil.which("code-server")
VSIX = os.environ.get("URDFKIT_VSIX", "")
pytestmark = [
    needs_browser,
    pytest.mark.skipif(not CODE_SERVER, reason="code-server is not installed"),
    pytest.mark.skipif(not VSIX, reason="URDFKIT_VSIX names no packaged extension"),
]
#: Seconds that VS Code may take to start, and to answer.
PATIENCE = 120

ROBOT = "urdf/waking_robot_new.xacro"


@pytest.fixture
def address(tmp_path: Path) -> Iterator[str]:
    """VS Code with nothing but the extension."""
    assert CODE_SERVER
    home = tmp_path / "home"
    directories = ["--user-data-dir", str(home), "--extensions-dir", str(home / "extensions")]
    (home / "User").mkdir(parents=True)
    settings = {
        "urdfkit.path": str(Path(sys.executable).with_name("urdfkit")),
        "workbench.startupEditor": "none",
    }
    (home / "User" / "settings.json").write_text(json.dumps(settings))
    subprocess.run(
        [CODE_SERVER, *directories, "--install-extension", VSIX], check=True, timeout=120
    )
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        place = f"127.0.0.1:{free.getsockname()[1]}"
    options = ["--auth", "none", "--bind-addr", place, "--disable-telemetry"]
    options += ["--disable-update-check", "--disable-workspace-trust"]
    with subprocess.Popen([CODE_SERVER, *directories, *options]) as server:
        try:
            until(lambda: answers(f"http://{place}/healthz"))
            yield place
        finally:
            server.terminate()


def answers(url: str) -> bool:
    try:
        with urlopen(url, timeout=5):
            return True
    except OSError:
        return False


def until(question: Callable[[], Any]) -> Any:
    """The first answer that is not empty."""
    end = time.monotonic() + PATIENCE
    while not (answer := question()):
        assert time.monotonic() < end, "VS Code takes too long"
        time.sleep(0.5)
    return answer


def shown(page: Page, selector: str) -> str:
    """The text of what a selector finds; empty without it."""
    found = page.driver.find_elements("css selector", selector)
    return "\n".join(one.text for one in found)


def look_at(page: Page, address: str, package: Path) -> None:
    """Open the robot, and wait for what is wrong with it."""
    reported = Counter(one.severity for one in check(package / ROBOT).diagnostics)
    wanted = [str(reported[one]) for one in (Severity.ERROR, Severity.WARNING, Severity.INFO)]
    payload = quote(json.dumps([["openFile", f"vscode-remote://{address}{package / ROBOT}"]]))
    page.driver.get(f"http://{address}/?directory={package}&payload={payload}")
    until(lambda: shown(page, "#status\\.problems").split()[:3] == wanted)
    assert mode(page) == "URDF"


def open_file(page: Page, path: Path) -> None:
    """Open another file."""
    from selenium.webdriver.common.keys import Keys

    press(page, Keys.CONTROL, "o", Keys.NULL)
    until(lambda: shown(page, ".quick-input-widget"))
    press(page, Keys.CONTROL, "a", Keys.NULL)
    press(page, str(path))

    def opened() -> bool:
        time.sleep(1)  # until the list of files is filled, nothing happens
        if shown(page, ".quick-input-widget"):
            press(page, Keys.ENTER)
        return path.name in shown(page, ".tab.active")

    until(opened)


def go_to(page: Page, line: int, column: int) -> None:
    """Put the cursor somewhere."""
    from selenium.webdriver.common.keys import Keys

    press(page, Keys.CONTROL, "g", Keys.NULL)
    until(lambda: shown(page, ".quick-input-widget"))
    press(page, f"{line}:{column}", Keys.ENTER)
    until(lambda: cursor(page) == f"Ln {line}, Col {column}")


def mode(page: Page) -> str:
    return shown(page, "#status\\.editor\\.mode")


def cursor(page: Page) -> str:
    return shown(page, "#status\\.editor\\.selection")


def press(page: Page, *keys: str) -> None:
    page.driver.switch_to.active_element.send_keys(*keys)


def test_findings_hover_and_definition_in_vscode(gazebo_pkg: Path, address: str) -> None:
    from selenium.webdriver.common.keys import Keys

    text = (gazebo_pkg / ROBOT).read_text(encoding="utf-8")
    with browser() as page:
        look_at(page, address, gazebo_pkg)
        go_to(page, text.count("\n", 0, text.index('<parent link="base_link"')) + 1, 22)
        press(page, Keys.CONTROL, "k", "i", Keys.NULL)
        assert "base_link" in until(lambda: shown(page, ".monaco-hover"))
        press(page, Keys.ESCAPE, Keys.F12)
        given = text.count("\n", 0, text.index('<link name="base_link"')) + 1
        until(lambda: cursor(page).startswith(f"Ln {given},"))


def test_a_joint_in_yaml_leads_to_the_robot_in_vscode(gazebo_pkg: Path, address: str) -> None:
    from selenium.webdriver.common.keys import Keys

    text = (gazebo_pkg / ROBOT).read_text(encoding="utf-8")
    name = re.findall(r'<joint name="(\w+)" type="continuous"', text)[0]
    (gazebo_pkg / "config").mkdir()
    (gazebo_pkg / "config" / "wheels.yaml").write_text(f"drive:\n  joints: [{name}]\n")
    with browser() as page:
        look_at(page, address, gazebo_pkg)
        open_file(page, gazebo_pkg / "config" / "wheels.yaml")
        until(lambda: mode(page) == "YAML")
        go_to(page, 2, 13)
        given = text.count("\n", 0, text.index(f'<joint name="{name}"')) + 1

        press(page, Keys.F12)
        until(lambda: mode(page) == "URDF" and cursor(page).startswith(f"Ln {given},"))
