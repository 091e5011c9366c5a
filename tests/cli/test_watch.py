"""``check --watch`` as a program: what changes is checked again, and Ctrl-C ends it."""

import os
import queue
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tests.xacros import HEAD
from urdfkit.cli import main, result_cache

pytestmark = pytest.mark.skipif(os.name == "nt", reason="Windows sends no SIGINT to one process")
#: Seconds that a test waits for a check.
PATIENCE = 60


class Watching:
    """A check that watches; its lines as they come."""

    def __init__(self, directory: Path, *words: str) -> None:
        program = (
            "import signal, sys\n"
            "signal.signal(signal.SIGINT, signal.default_int_handler)  # shells' jobs ignore it\n"
            "from urdfkit.cli import main\n"
            "sys.exit(main(sys.argv[1:]))"
        )
        self.process = subprocess.Popen(
            (sys.executable, "-c", program, "check", *words, "--watch", "--format", "concise"),
            cwd=directory,
            env={**os.environ, "PYTHONPATH": str(ROOT), "URDFKIT_CACHE_DIR": ""},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self._lines: queue.Queue[str] = queue.Queue()
        self._reader = threading.Thread(target=self._read)
        self._reader.start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        with self.process.stdout:
            for line in self.process.stdout:
                self._lines.put(line)

    def end(self) -> None:
        self.process.kill()
        self.process.wait()
        self._reader.join()

    def until(self, text: str) -> list[str]:
        """The lines up to one with a text."""
        lines = [self._lines.get(timeout=PATIENCE)]
        while text not in lines[-1]:
            lines.append(self._lines.get(timeout=PATIENCE))
        return lines


@pytest.fixture
def project(tmp_path: Path) -> Path:
    (tmp_path / "parts.xacro").write_text(f'{HEAD}<link name="a"/></robot>')
    (tmp_path / "r.xacro").write_text(f'{HEAD}<xacro:include filename="parts.xacro"/></robot>')
    return tmp_path


@pytest.fixture
def watching(project: Path) -> Iterator[Watching]:
    process = Watching(project, "r.xacro")
    yield process
    process.end()


def test_an_include_that_is_changed_removed_and_restored(watching: Watching, project: Path) -> None:
    assert not any("NAM001" in line for line in watching.until("watching "))
    parts, text = project / "parts.xacro", f'{HEAD}<link name="a"/><link name="a"/></robot>'
    parts.write_text(text)
    watching.until("NAM001")
    parts.unlink()
    watching.until("XAC001")
    parts.write_text(text)
    watching.until("NAM001")
    (project / "r.xacro").unlink()
    watching.until("error: r.xacro: file not found")  # and it goes on
    watching.until("watching ")
    watching.process.send_signal(signal.SIGINT)
    assert watching.process.wait(PATIENCE) == 130


@pytest.mark.parametrize("words", [["-"], ["r.urdf", "--fix"], ["r.urdf", "--add-ignore"]])
def test_unwatchable_inputs(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", *words, "--watch"]) == 2
    assert capsys.readouterr().err.startswith("error: --watch ")


def test_a_watched_check_is_not_cached() -> None:
    assert result_cache.cache_key(["check", "r.xacro", "--watch"]) is None
