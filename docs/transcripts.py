"""Run the commands that README and ``docs`` show, and write below them what they print.

In a block of the kind ``console`` a line that begins with ``$`` is run by a shell in the folder
of the project; what follows is its output.

Usage: python docs/transcripts.py
"""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "docs" / "commands"
README = ROOT / "README.md"
#: All pages but those of the rules, which ``generate.py`` writes.
PAGES = [README, *sorted(FOLDER.glob("*.md")), *sorted(FOLDER.parent.glob("*.md"))]

_BLOCK = re.compile(r"(?<=^```console\n).*?(?=^```$)", re.DOTALL | re.MULTILINE)
_PRELUDE = (
    f'urdfkit() {{ PYTHONPATH="{ROOT}" PYTHONSAFEPATH=1 "{sys.executable}" -m urdfkit "$@"; }}; '
)


def with_output(page: str) -> str:
    """A page with the output of its commands as it is now."""
    return _BLOCK.sub(lambda block: _run_block(block.group()), page)


def _run_block(block: str) -> str:
    """One shell runs all commands of a block: a folder that is entered stays."""
    commands = [line[2:] for line in block.splitlines() if line.startswith("$ ")]
    shown = "; ".join(f"printf '$ %s\\n' {shlex.quote(one)}; {one}" for one in commands)
    return _run(shown)


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
    for page in PAGES:
        page.write_text(with_output(page.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    main()
