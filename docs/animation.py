"""Draw the animation of the README: a terminal with what the commands print, as an SVG.

Usage: python docs/animation.py
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator
from html import escape
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "models" / "gazebo_pkg"
FILE = ROOT / "docs" / "pictures" / "terminal.svg"

#: Seconds that a screen stays, and its commands.
SCREENS = (
    (4, ("check . --select MSH,URD001",)),
    (3, ("mesh generate --model urdf/waking_robot_new.xacro", "fix . --unsafe-fixes")),
    (
        3,
        (
            "check . --select MSH,URD,INE006",
            "tree urdf/waking_robot_new.xacro",
            "render urdf/waking_robot_new.xacro -o robot.png",
        ),
    ),
)
COLUMNS, ROWS = 80, 20
#: Of a character, in px; its width is set for each run, whatever the font.
WIDTH, HEIGHT, MARGIN = 8, 18, 16

_STYLE = """
text { font: 13px ui-monospace, Menlo, Consolas, monospace; fill: #d7dae0; white-space: pre; }
.b { font-weight: bold; fill: #fff; } .r { font-weight: bold; fill: #ff6b68; }
.y { font-weight: bold; fill: #f5b83d; } .p { fill: #6cc070; }
"""
_CLASSES = {"1": "b", "1;31": "r", "1;33": "y", "1;36": "p", "32": "p"}
_RUN = re.compile(r"(?:\x1b\[([\d;]+)m)?([^\x1b]+)(?:\x1b\[0m)?")


def drawn() -> str:
    """The animation: one screen after the other, without end."""
    seconds = sum(length for length, _ in SCREENS)
    with tempfile.TemporaryDirectory() as scratch:
        work = Path(shutil.copytree(PACKAGE, Path(scratch, "gazebo_pkg")))
        screens = [list(_printed(work, commands)) for _, commands in SCREENS]
    size = (COLUMNS * WIDTH + 2 * MARGIN, ROWS * HEIGHT + 2 * MARGIN)
    keys, parts, begin = [_STYLE], [], 0
    for number, ((length, _), lines) in enumerate(zip(SCREENS, screens, strict=True)):
        first, last = (100 * second / seconds for second in (begin, begin + length))
        begin += length
        hidden = f"0%, {first:.4g}%, {last:.4g}%, 100% {{ visibility: hidden; }}"
        shown = f"{first + 0.01:.4g}% {{ visibility: visible; }}"
        keys.append(f"@keyframes s{number} {{ {hidden} {shown} }}\n")
        keys.append(f"#s{number} {{ animation: s{number} {seconds}s step-end infinite; }}\n")
        parts += [f'<g id="s{number}">', *map(_line, range(ROWS), lines), "</g>"]
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size[0]} {size[1]}">',
            f"<style>{''.join(keys)}</style>",
            f'<rect width="{size[0]}" height="{size[1]}" rx="8" fill="#1e2127"/>',
            *parts,
            "</svg>\n",
        ]
    )


def _printed(work: Path, commands: Iterable[str]) -> Iterator[str]:
    """The lines of a screen: commands and what they print, with escape sequences."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "COLUMNS": str(COLUMNS)}
    environment |= {"FORCE_COLOR": "1", "NO_COLOR": ""}
    for command in commands:
        yield f"\x1b[32m$\x1b[0m \x1b[1murdfkit {command}\x1b[0m"
        words = [sys.executable, "-m", "urdfkit", *command.split()]
        done = subprocess.run(
            words, check=False, cwd=work, env=environment, capture_output=True, encoding="utf-8"
        )
        assert done.returncode in (0, 1), done.stderr
        yield from done.stdout.rstrip("\n").split("\n")


def _line(row: int, line: str) -> str:
    """A line as runs of one colour, each at its column."""
    column, runs = 0, []
    for style, text in _RUN.findall(line):
        x, width = MARGIN + column * WIDTH, len(text) * WIDTH
        column += len(text)
        if text.strip():
            name = f' class="{_CLASSES[style]}"' if style else ""
            place = f'x="{x}" textLength="{width}" lengthAdjust="spacingAndGlyphs"'
            runs.append(f"<tspan {place}{name}>{escape(text, quote=False)}</tspan>")
    return (
        f'<text y="{MARGIN + (row + 1) * HEIGHT - 5}" xml:space="preserve">{"".join(runs)}</text>'
    )


if __name__ == "__main__":
    FILE.write_text(drawn(), encoding="utf-8")
