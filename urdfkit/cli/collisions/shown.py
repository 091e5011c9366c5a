"""A collision matrix as text, Markdown and JSON."""

from collections.abc import Iterator, Sequence
from typing import Any

from urdfkit.core.words import counted, few
from urdfkit.physics.collision.matrix import (
    NEAR_MISS,
    ClosestApproach,
    Matrix,
    PairResult,
    PairVerdict,
)
from urdfkit.physics.collision.srdf_matrix import MatrixComparison
from urdfkit.text.markdown import escape, table
from urdfkit.text.terminal import columns, printable, wrap

VERSION = 1

_MEANING = {
    PairVerdict.ADJACENT: "connected by a joint",
    PairVerdict.DEFAULT: "in collision in the initial pose",
    PairVerdict.ALWAYS: "in collision in more than 95 % of the samples",
    PairVerdict.SOMETIMES: "can collide: must be checked",
    PairVerdict.NEVER: "no collision found",
    PairVerdict.UNKNOWN: "coal crashed on this pair",
}

#: Most pairs in a list of text; the rest are counted. JSON contains all.
_MOST = 30
#: Most links in a sentence about omitted shapes.
_MOST_LINKS = 8
_WIDTH = 80


def text(matrix: Matrix, comparison: MatrixComparison | None) -> str:
    """The result as text for a terminal."""
    return "\n".join(_lines(matrix, comparison)) + "\n"


def _lines(matrix: Matrix, comparison: MatrixComparison | None) -> Iterator[str]:
    yield _title(matrix)
    if matrix.pairs:
        yield ""
    for verdict, meaning in _MEANING.items():
        if pairs := matrix.of(verdict):
            yield f"{len(pairs):>6}  {verdict.value:<9}  {meaning}"
    for title, pairs in _lists(matrix, comparison):
        yield ""
        yield title
        shown = pairs[:_MOST]
        firsts = _aligned([pair.first for pair in shown])
        seconds = _aligned([pair.second for pair in shown])
        for first, second, pair in zip(firsts, seconds, shown, strict=True):
            line = f"  {first}  {second}  {_frequency(pair):>7}  {_distance(pair.nearest)}"
            yield line.rstrip()
            if pair.is_near_miss and pair.nearest:
                yield f"      {wrap(_pose(pair.nearest), _WIDTH, indent=6, used=6)}"
        if len(pairs) > _MOST:
            yield f"  and {len(pairs) - _MOST} more"
    for note in _notes(matrix, comparison):
        yield ""
        yield wrap(printable(note), _WIDTH)


def _aligned(names: Sequence[str]) -> list[str]:
    """Names padded to the width of the widest."""
    cells = [printable(name) for name in names]
    wide = max(map(columns, cells))
    return [cell + " " * (wide - columns(cell)) for cell in cells]


def markdown(matrix: Matrix, comparison: MatrixComparison | None) -> str:
    """The result as Markdown."""
    sections = [f"### Collisions of {escape(_title(matrix))}\n"]
    counts = [
        (verdict.value, str(len(pairs)), meaning)
        for verdict, meaning in _MEANING.items()
        if (pairs := matrix.of(verdict))
    ]
    sections.append(table(("pairs", "", ""), counts))
    for title, pairs in _lists(matrix, comparison):
        rows = [
            (escape(p.first), escape(p.second), _frequency(p), _distance(p.nearest)) for p in pairs
        ]
        sections.append(f"**{escape(title)}**\n")
        sections.append(table(("link", "link", "collide", "nearest"), rows))
    sections += [f"{escape(note)}\n" for note in _notes(matrix, comparison)]
    return "\n".join(sections)


def as_json(matrix: Matrix, comparison: MatrixComparison | None) -> dict[str, Any]:
    """The result for JSON."""
    document: dict[str, Any] = {
        "version": VERSION,
        "robot": matrix.robot,
        "samples": matrix.samples,
        "asked": matrix.asked,
        "counted": matrix.counted,
        "seed": matrix.seed,
        "applies_units": matrix.applies_units,
        "pairs": [_pair(pair) for pair in matrix.pairs],
        "omitted": [shape._asdict() for shape in matrix.omitted],
        "parts": list(matrix.parts),
    }
    if comparison is not None:
        document["compared"] = {
            "agreed": comparison.agreed,
            "hidden": [[pair.first, pair.second] for pair in comparison.hidden],
            "watched": [[pair.first, pair.second] for pair in comparison.watched],
        }
    return document


def _pair(pair: PairResult) -> dict[str, Any]:
    return {
        "links": [pair.first, pair.second],
        "verdict": pair.verdict.value,
        "moves": pair.moves,
        "frequency": pair.frequency,
        "distance": pair.nearest.distance if pair.nearest else None,
        "pose": pair.nearest.pose if pair.nearest else None,
    }


def _title(matrix: Matrix) -> str:
    links = {name for pair in matrix.pairs for name in (pair.first, pair.second)}
    name = printable(matrix.robot) or "(no name)"
    if not matrix.pairs:
        return f"{name}: {_why_no_pairs(matrix)}"
    return (
        f"{name}: {counted(len(matrix.pairs), 'pair')} of {counted(len(links), 'link')}, "
        f"{matrix.samples} samples, seed {matrix.seed}"
    )


def _why_no_pairs(matrix: Matrix) -> str:
    if len(matrix.links) > 1:
        return "no two links with collision geometry are connected by joints"
    if matrix.links:
        return f"only link '{printable(matrix.links[0])}' has collision geometry"
    return f"no link has {'usable ' * bool(matrix.omitted)}collision geometry"


def _lists(
    matrix: Matrix, comparison: MatrixComparison | None
) -> list[tuple[str, list[PairResult]]]:
    """The lists of pairs that need attention, with titles."""
    often = sorted(matrix.of(PairVerdict.SOMETIMES), key=lambda pair: -(pair.frequency or 0))
    named = [
        ("collide in the initial pose", matrix.of(PairVerdict.DEFAULT)),
        ("always collide", matrix.of(PairVerdict.ALWAYS)),
        ("can collide", often),
        (f"never collide, but come closer than {1000 * NEAR_MISS:g} mm", matrix.near_misses),
    ]
    if comparison is not None:
        named += [
            ("disabled in the SRDF, but can collide", list(comparison.hidden)),
            ("not disabled in the SRDF, but could be", list(comparison.watched)),
        ]
    return [(title, pairs) for title, pairs in named if pairs]


def _notes(matrix: Matrix, comparison: MatrixComparison | None) -> Iterator[str]:
    rare = [pair for pair in matrix.pairs if pair.is_seldom]
    if rare:
        yield (
            f"{len(rare)} of the pairs that collide in the initial pose rarely collide "
            "elsewhere. An SRDF would disable them as 'Default', and MoveIt would miss collisions: "
            "choose a collision-free initial pose with --pose or --joint."
        )
    if matrix.parts:
        yield (
            f"{len(matrix.parts)} parts, with roots {few(matrix.parts, _MOST)}: links of different "
            "parts are not compared, since no joint bounds their relative pose."
        )
    if 0 < matrix.samples < matrix.asked:
        yield f"Stopped after {matrix.samples} of {matrix.asked} samples: converged."
    if comparison is not None:
        differences = len(comparison.hidden) + len(comparison.watched)
        yield (
            f"The SRDF disables {counted(comparison.agreed, 'pair')} correctly and differs "
            f"from this matrix in {differences or 'none'}."
        )
    if matrix.units:
        treatment = "applied" if matrix.applies_units else "ignored, as MoveIt does"
        yield (
            f"{len(matrix.units)} collision meshes state another unit than the metre, which was "
            f"{treatment} (--units)."
        )
    yield from _omitted(matrix)


def _omitted(matrix: Matrix) -> Iterator[str]:
    """The omitted shapes, those with one reason together."""
    causes: dict[tuple[int, str], list[str]] = {}
    for shape in matrix.omitted:
        causes.setdefault((shape.number + 1, shape.reason), []).append(f"'{shape.link}'")
    for (number, reason), links in causes.items():
        word = "link" if len(links) == 1 else "links"
        yield f"omitted: collision {number} of {word} {few(links, _MOST_LINKS)}: {reason}"


def _frequency(pair: PairResult) -> str:
    if pair.frequency is None or pair.verdict in (PairVerdict.NEVER, PairVerdict.ADJACENT):
        return ""
    return f"{100 * pair.frequency:.1f} %" if pair.frequency else "rarely"


def _distance(nearest: ClosestApproach | None) -> str:
    if nearest is None:
        return ""
    if nearest.distance < 0:
        return f"{-1000 * nearest.distance:.1f} mm deep"
    distance = 1000 * nearest.distance
    return f"{distance:.2g} mm apart" if distance < 100 else f"{distance:.0f} mm apart"


def _pose(nearest: ClosestApproach) -> str:
    return "at " + ", ".join(f"{printable(n)} {v:.3g}" for n, v in nearest.pose.items())
