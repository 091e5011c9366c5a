"""Draws the packages of urdfkit for docs/architecture.md: layers, lines of code, and imports.

``python docs/layers.py`` draws them anew, from ``pyproject.toml`` and the imports; grimp, which
comes with import-linter, reads them. The drawing is an SVG, since a browser needs a script from
elsewhere for one in Mermaid.
"""

import sys
from pathlib import Path

import grimp

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).resolve().parents[1]
PICTURE = ROOT / "docs" / "pictures" / "packages.svg"

#: Distances of columns and rows, and half sides of a box, in pixels.
_COLUMN, _ROW, _HALF_WIDTH, _HALF_HEIGHT = 130, 70, 56, 20
_HEAD = """\
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}"
 width="{width:g}" height="{height:g}" font-family="sans-serif">
<title>The packages of urdfkit, their lines of code, and their imports</title>
<style>
rect {{ fill: #eceff1; stroke: #607d8b }}
text {{ fill: #263238; font-size: 13px; text-anchor: middle }}
.count {{ fill: #546e7a; font-size: 11px }}
path {{ fill: none; stroke: #78909c; stroke-width: 1.5 }}
marker path {{ fill: #78909c; stroke: none }}
</style>
<marker id="end" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">
<path d="M0 0 L8 4 L0 8 z"/></marker>"""


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


def imports() -> dict[str, list[str]]:
    """The packages that each one uses; not those that it also reaches through others."""
    graph = grimp.build_graph("urdfkit", exclude_type_checking_imports=False)
    order = [name for layer in layers() for name in layer]
    uses: dict[str, set[str]] = {name: set() for name in order}
    for module in graph.modules:
        own = module.split(".")[1:2]
        for used in graph.find_modules_directly_imported_by(module) if own else ():
            uses.get(own[0], set()).update(used.split(".")[1:2])
    direct: dict[str, list[str]] = {}
    for name in order:
        below = [other for other in order if other in uses[name] - {name}]
        direct[name] = [
            o for o in below if not any(o in _reached(b, uses) for b in below if b != o)
        ]
    return direct


def drawing() -> str:
    """The packages as an SVG: each above those that it uses, with its lines of code."""
    uses = imports()
    places = _places(uses)
    left, right = (end(x for x, _ in places.values()) for end in (min, max))
    top = max(row for _, row in places.values())
    center = {
        name: (_COLUMN * (x - left + 0.5), _ROW * (top - row + 0.5))
        for name, (x, row) in places.items()
    }
    arrows = [_arrow(center[name], center[used]) for name in uses for used in uses[name]]
    boxes = [_box(name, *center[name]) for name in uses]
    head = _HEAD.format(width=_COLUMN * (right - left + 1), height=_ROW * (top + 1))
    return "\n".join([head, *arrows, *boxes, "</svg>\n"])


def _places(uses: dict[str, list[str]]) -> dict[str, tuple[float, int]]:
    """Column and row of each package; it stands above the middle of those that it uses."""
    rows: dict[str, int] = {}
    for name in reversed(uses):  # those that others use first
        rows[name] = 1 + max((rows[used] for used in uses[name]), default=-1)
    places: dict[str, tuple[float, int]] = {}
    for row in sorted(set(rows.values())):
        wanted: dict[str, tuple[float, int]] = {}
        for name in (name for name in uses if rows[name] == row):
            columns = [places[used][0] for used in uses[name]] or [0.0]
            # What a package far above uses stands on the left, where nothing is in between.
            above = max((rows[user] for user in uses if name in uses[user]), default=row)
            wanted[name] = (sum(columns) / len(columns), row - above)
        taken: list[float] = []
        ordered = sorted(wanted, key=lambda name: wanted[name])
        for name in ordered:
            taken.append(max([wanted[name][0], *(x + 1 for x in taken[-1:])]))
        shift = (sum(wanted[name][0] for name in ordered) - sum(taken)) / len(taken)
        places |= {name: (x + shift, row) for name, x in zip(ordered, taken, strict=True)}
    return places


def _arrow(start: tuple[float, float], end: tuple[float, float]) -> str:
    (x, y), (u, v) = start, end
    line = f"M{x:g} {y + _HALF_HEIGHT:g} L{u:g} {v - _HALF_HEIGHT - 2:g}"
    return f'<path d="{line}" marker-end="url(#end)"/>'


def _box(name: str, x: float, y: float) -> str:
    corner = f'x="{x - _HALF_WIDTH:g}" y="{y - _HALF_HEIGHT:g}"'
    count = f"{round(lines(name), -2):,} lines"
    return (
        f'<rect {corner} width="{2 * _HALF_WIDTH}" height="{2 * _HALF_HEIGHT}" rx="4"/>'
        f'<text x="{x:g}" y="{y - 3:g}">{name}</text>'
        f'<text x="{x:g}" y="{y + 13:g}" class="count">{count}</text>'
    )


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
    PICTURE.write_text(drawing(), encoding="utf-8")
