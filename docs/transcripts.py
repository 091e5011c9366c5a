"""Run the commands that README and ``docs/commands`` show, and write below them what they print.

In a block of the kind ``console`` a line that begins with ``$`` is run by a shell in the folder
of the project; what follows is its output.

Usage: python docs/transcripts.py
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "docs" / "commands"
README = ROOT / "README.md"

_BLOCK = re.compile(r"(?<=^```console\n).*?(?=^```$)", re.DOTALL | re.MULTILINE)
_PRELUDE = f'urdfkit() {{ "{sys.executable}" -m urdfkit "$@"; }}; '


def with_output(page: str) -> str:
    """A page with the output of its commands as it is now."""
    return _BLOCK.sub(lambda block: _run_block(block.group()), page)


def _run_block(block: str) -> str:
    commands = [line[2:] for line in block.splitlines() if line.startswith("$ ")]
    return "".join(f"$ {command}\n{_run(command)}" for command in commands)


def _run(command: str) -> str:
    environment = {key: value for key, value in os.environ.items() if key != "FORCE_COLOR"}
    done = subprocess.run(
        ["sh", "-c", _PRELUDE + command],
        check=False,
        cwd=ROOT,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    return done.stdout.replace(f"{ROOT}/", "")


def main() -> None:
    """Write all pages."""
    for page in (README, *FOLDER.glob("*.md")):
        page.write_text(with_output(page.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    main()
