"""Draws the packages of urdfkit in docs/architecture.md: layers, lines of code, and imports.

``python docs/layers.py`` writes the drawing anew, from ``pyproject.toml`` and the imports; grimp,
which comes with import-linter, reads them.
"""

import re
import sys
from pathlib import Path

import grimp

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "architecture.md"

_DRAWING = re.compile(r"```mermaid\n.*?```\n", re.DOTALL)


def layers() -> list[list[str]]:
    """The packages of each layer, the highest first."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    contracts = settings["tool"]["importlinter"]["contracts"]
    (order,) = (one["layers"] for one in contracts if one["type"] == "layers")
    return [layer.split(" | ") for layer in order]


def lines(package: str) -> int:
    """Lines of Python in a package or module of urdfkit."""
    place = ROOT / "urdfkit" / package
    files = place.rglob("*.py") if place.is_dir() else [place.with_suffix(".py")]
    return sum(len(file.read_text(encoding="utf-8").splitlines()) for file in files)


def drawing() -> str:
    """The layers as a Mermaid flow chart; an arrow is drawn to the next layers that are used."""
    graph = grimp.build_graph("urdfkit", exclude_type_checking_imports=False)
    order = [name for layer in layers() for name in layer]
    uses: dict[str, set[str]] = {name: set() for name in order}
    for module in graph.modules:
        own = module.split(".")[1:2]
        for used in graph.find_modules_directly_imported_by(module) if own else ():
            uses.get(own[0], set()).update(used.split(".")[1:2])
    rows = ["flowchart TD"]
    rows += [f'  {name}["{name}<br/>{round(lines(name), -2):,} lines"]' for name in order]
    for name in order:
        below = [other for other in order if other in uses[name] - {name}]
        # What is reached through another package below is not drawn again.
        direct = [o for o in below if not any(o in _reached(b, uses) for b in below if b != o)]
        rows += [f"  {name} --> {other}" for other in direct]
    return "```mermaid\n" + "\n".join(rows) + "\n```\n"


def _reached(start: str, uses: dict[str, set[str]]) -> set[str]:
    """The packages that one uses, directly and through others."""
    found: set[str] = set()
    waiting = [start]
    while waiting:
        for other in uses.get(waiting.pop(), set()) - found - {start}:
            found.add(other)
            waiting.append(other)
    return found


if __name__ == "__main__":
    text = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(_DRAWING.sub(lambda _: drawing(), text), encoding="utf-8")
