"""How long the language server takes from a key stroke to its findings.

Usage: python benchmarks/editor.py [--strokes N] [--lines N]

A generated xacro with one macro call for each link is opened, and a digit in its middle is changed
again and again: the milliseconds from `didChange` to `publishDiagnostics`, on the clock and of the
server's processor time. The wait before a check, which spares one for each letter of a word, is
listed apart. Then keys come faster than checks: the last findings must be those of the last text.
"""

import argparse
import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any, BinaryIO

from urdfkit.lsp.server import DEBOUNCE

#: Milliseconds of processor time from a key stroke to its findings, without the wait: the median.
BOUND = 150

HEAD = """\
<?xml version="1.0"?>
<robot name="tower" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="side" value="0.1"/>
  <xacro:macro name="inertial" params="mass">
    <inertial>
      <mass value="${mass}"/>
      <inertia ixx="${mass / 6 * side**2}" ixy="0" ixz="0"
               iyy="${mass / 6 * side**2}" iyz="0" izz="${mass / 6 * side**2}"/>
    </inertial>
  </xacro:macro>
  <link name="link_0"/>
"""
LINK = """\
  <joint name="joint_{n}" type="revolute">
    <parent link="link_{parent}"/>
    <child link="link_{n}"/>
    <origin xyz="{x} 0 ${{1.5 * side}}" rpy="0 0 0"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1.5" upper="1.5" effort="900" velocity="2"/>
  </joint>
  <link name="link_{n}">
    <visual>
      <geometry>
        <box size="${{side}} ${{side}} ${{side}}"/>
      </geometry>
    </visual>
    <collision>
      <geometry>
        <box size="${{side}} ${{side}} ${{side}}"/>
      </geometry>
    </collision>
    <xacro:inertial mass="1.{n:03}"/>
  </link>
"""


def model(lines: int) -> str:
    """A xacro with about so many lines: several arms of six links on one base."""
    count = (lines - HEAD.count("\n")) // LINK.count("\n")
    links = (_link(n) for n in range(1, count + 1))
    return HEAD + "".join(links) + "</robot>\n"


def _link(n: int) -> str:
    is_first = n % 6 == 1
    return LINK.format(n=n, parent=0 if is_first else n - 1, x=n / 20 if is_first else 0)


class Client:
    """An editor with one file."""

    def __init__(self, file: Path) -> None:
        command = [sys.executable, "-m", "urdfkit", "lsp"]
        self.server = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        assert self.server.stdin is not None
        assert self.server.stdout is not None
        self._input: BinaryIO = self.server.stdin  # type: ignore[assignment]
        self._output: BinaryIO = self.server.stdout  # type: ignore[assignment]
        self.uri = file.as_uri()
        self._version = 0
        self._send("initialize", {"processId": None, "rootUri": None, "capabilities": {}}, id=1)
        self._receive()
        self._send("initialized", {})
        document = {"languageId": "xml", "version": 0, "text": file.read_text(encoding="utf-8")}
        self._send("textDocument/didOpen", {"textDocument": {"uri": self.uri, **document}})

    def _send(self, method: str, params: dict[str, Any], **more: int) -> None:
        body = json.dumps({"jsonrpc": "2.0", "method": method, "params": params, **more}).encode()
        self._input.write(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        self._input.flush()

    def _receive(self) -> dict[str, Any]:
        length = 0
        while line := self._output.readline().strip():
            if line.lower().startswith(b"content-length:"):
                length = int(line.split(b":")[1])
        message: dict[str, Any] = json.loads(self._output.read(length))
        return message

    def replace(self, line: int, start: int, end: int, text: str) -> None:
        """Type over a piece of a line."""
        self._version += 1
        place = {
            "start": {"line": line, "character": start},
            "end": {"line": line, "character": end},
        }
        document = {"uri": self.uri, "version": self._version}
        change = {"textDocument": document, "contentChanges": [{"range": place, "text": text}]}
        self._send("textDocument/didChange", change)

    def findings(self) -> list[dict[str, Any]]:
        """The next findings that are published for the file."""
        while True:
            message = self._receive()
            params = message.get("params", {})
            is_ours = message.get("method") == "textDocument/publishDiagnostics"
            if is_ours and params["uri"] == self.uri:
                found: list[dict[str, Any]] = params["diagnostics"]
                return found

    def processor_time(self) -> float:
        """Seconds of all threads of the server; 0 where the system does not say."""
        threads = Path(f"/proc/{self.server.pid}/task").glob("*/schedstat")
        return sum(int(thread.read_text().split()[0]) for thread in threads) / 1e9

    def close(self) -> None:
        self.server.kill()
        self.server.wait()


def strokes(client: Client, line: int, column: int, count: int) -> list[tuple[float, float]]:
    """Clock and processor milliseconds of some key strokes, each after the findings of the last."""
    found = []
    for number in range(count):
        start, worked = time.perf_counter(), client.processor_time()
        client.replace(line, column, column + 1, str(number % 9 + 1))
        client.findings()
        clock = time.perf_counter() - start
        found.append((1e3 * (clock - DEBOUNCE), 1e3 * (client.processor_time() - worked)))
    return found


def burst(client: Client, line: int, column: int, count: int) -> tuple[float, float]:
    """Milliseconds after the last of many fast key strokes, of which the last makes an error.

    Keys come every 40 ms. Answers the time to the findings of the last text, and how many times
    findings were published.
    """
    for _ in range(count - 1):
        client.replace(line, column, column + 1, "7")
        time.sleep(0.04)
    client.replace(line, column, column + 1, "x")
    start, published = time.perf_counter(), 1
    while not any(one["code"] == "URD005" for one in client.findings()):
        published += 1
    return 1e3 * (time.perf_counter() - start - DEBOUNCE), published


def main() -> int:
    """Measure, print, and answer 1 if the bound is exceeded."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--strokes", type=int, default=30)
    parser.add_argument("--lines", type=int, default=2000)
    options = parser.parse_args()
    text = model(options.lines)
    with tempfile.TemporaryDirectory() as directory:
        file = Path(directory, "tower.urdf.xacro")
        file.write_text(text, encoding="utf-8")
        lines = text.split("\n")
        line = next(n for n, one in enumerate(lines) if n > len(lines) // 2 and "effort" in one)
        column = lines[line].index("effort") + len('effort="')
        client = Client(file)
        try:
            print(f"{len(lines)} lines, {len(client.findings())} findings")
            strokes(client, line, column, 3)
            times = strokes(client, line, column, options.strokes)
            late, published = burst(client, line, column, 20)
        finally:
            client.close()
    clock, processor = (sorted(one[n] for one in times) for n in (0, 1))
    print(f"wait before a check        {1e3 * DEBOUNCE:6.0f} ms")
    for name, values in (("clock", clock), ("processor", processor)):
        middle = statistics.median(values)
        row = f"least {values[0]:6.0f}   median {middle:6.0f}   most {values[-1]:6.0f}"
        print(f"findings after it, {name:10}{row} ms")
    print(
        f"20 keys in 0.8 s: the last findings {late:.0f} ms after the last, published {published}"
    )
    median = statistics.median(processor) or statistics.median(clock)
    verdict = "pass" if median <= BOUND else "OVER"
    print(f"{verdict}  key stroke to findings, median: {median:.0f} of {BOUND} ms")
    return int(median > BOUND)


if __name__ == "__main__":
    sys.exit(main())
