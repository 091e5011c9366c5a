"""Run the commands that README and ``docs`` show, and write below them what they print.

In a block of the kind ``console`` a line that begins with ``$`` is run by a shell in the directory
of the project; what follows is its output. A page that says "commands run beside a copy of ..."
tells one story: its commands run one after the other in a directory with that copy.

Usage: python docs/transcripts.py
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from importlib.metadata import entry_points
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DIRECTORY = ROOT / "docs" / "commands"
README = ROOT / "README.md"
CHINESE = ROOT / "README.zh.md"
#: All pages but those of the rules, which ``generate.py`` writes.
PAGES = [README, CHINESE, *sorted(DIRECTORY.glob("*.md")), *sorted(DIRECTORY.parent.glob("*.md"))]

_BLOCK = re.compile(r"(?<=^```console\n).*?(?=^```$)", re.DOTALL | re.MULTILINE)
#: All commands of such a page run in one directory, which holds a copy of a package.
_COPY = re.compile(r"<!-- commands run beside a copy of (\S+) -->")


def _is_installed() -> bool:
    return any(point.name == "urdfkit" for point in entry_points(group="pytest11"))


_HERE = f'PYTHONPATH="{ROOT}" PYTHONSAFEPATH=1 "{sys.executable}" -m'
_WITHOUT_TIMES = r'sed "s/^=* *\(.* passed\) in .*/\1/"'
#: A checkout that is not installed has to name the plugin.
_PLUGIN = "" if _is_installed() else "-p urdfkit.pytest_plugin"
_PRELUDE = (
    f'urdfkit() {{ {_HERE} urdfkit "$@"; }}; '
    f'pytest() {{ {_HERE} pytest {_PLUGIN} -p no:cacheprovider "$@" | {_WITHOUT_TIMES}; }}; '
)


def with_output(page: str) -> str:
    """A page with the output of its commands as it is now."""
    given = _COPY.search(page)
    if given is None:
        return _BLOCK.sub(lambda block: _run_block(block.group()), page)
    with tempfile.TemporaryDirectory() as scratch:
        shutil.copytree(ROOT / given[1], Path(scratch, Path(given[1]).name))
        text = _BLOCK.sub(lambda block: _run_lines(_commands(block.group()), scratch), page)
        return text.replace(f"{scratch}/", "")


def _run_block(block: str) -> str:
    """One shell runs all commands of a block: a directory that is entered stays.

    Where it says /tmp, it is a directory of its own: several blocks may be run at a time.
    """
    with tempfile.TemporaryDirectory() as scratch:
        commands = {one: one.replace("/tmp/", f"{scratch}/") for one in _commands(block)}
        return _run_lines(commands, str(ROOT)).replace(scratch, "/tmp")


def _commands(block: str) -> dict[str, str]:
    """The commands as they are shown and as they are run."""
    return {line[2:]: line[2:] for line in block.splitlines() if line.startswith("$ ")}


def _run_lines(commands: dict[str, str], directory: str) -> str:
    lines = [f"printf '$ %s\\n' {shlex.quote(shown)}; {run}" for shown, run in commands.items()]
    return _run("; ".join(lines), directory)


def _run(command: str, directory: str) -> str:
    environment = {key: value for key, value in os.environ.items() if key != "FORCE_COLOR"}
    done = subprocess.run(
        ["sh", "-c", _PRELUDE + command],
        check=False,
        cwd=directory,
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
