"""A comparison as text for a terminal."""

from collections.abc import Iterable, Iterator
from math import degrees

from urdfkit.core.words import counted, spaced
from urdfkit.output.comparison import KINDS, Comparison
from urdfkit.output.comparison.frames import MovedLink
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.terminal import columns, printable, wrap

#: Most lines of a kind that are shown; JSON has all.
MAX_LINES = 20


def render(comparison: Comparison, *, width: int = 80) -> str:
    """Differences by kind; one line if there are none."""
    head = f"{printable(comparison.before)} -> {printable(comparison.after)}"
    return "\n".join([head, *_body(comparison, width)]) + "\n"


def _body(comparison: Comparison, width: int) -> Iterator[str]:
    if not (comparison.kinds or comparison.new_findings or comparison.fixed_findings):
        yield "no differences"
    if comparison.total_differs:
        yield "\ntotal"
        yield from _total(comparison, width)
    for kind in KINDS:
        lines = [str(change) for change in comparison.differences if change.kind == kind]
        if lines:
            yield f"\n{kind}"
            yield from _some(wrap(printable(line), width - 2, indent=4) for line in lines)
    if comparison.moved:
        yield "\nlinks that moved, all joints at zero"
        yield from _moved(comparison.moved)
    if comparison.new_findings or comparison.fixed_findings:
        yield "\nfindings"
        lines = [
            *_findings("+", comparison.new_findings, width),
            *_findings("-", comparison.fixed_findings, width),
        ]
        yield from _some(lines)
    for note in comparison.notes:
        yield f"\nnote: {note}"


def _some(lines: Iterable[str]) -> Iterator[str]:
    every = list(lines)
    yield from (f"  {line}" for line in every[:MAX_LINES])
    if len(every) > MAX_LINES:
        yield f"  and {len(every) - MAX_LINES} more"


def _moved(moved: Iterable[MovedLink]) -> Iterator[str]:
    """A table of links that moved relative to their parents, and the number of links carried."""
    own = [move for move in moved if not move.carried]
    carried = [move for move in moved if move.carried]
    names = [printable(move.link) for move in own]
    size = max(map(columns, names[:MAX_LINES]), default=4)
    yield f"  {'link':<{size}}  {'mm':>9}  {'deg':>8}"
    yield from _some(
        f"{name}{' ' * (size - columns(name))}  {1000 * movement.distance:>9.3f}"
        f"  {degrees(movement.angle):>8.3f}"
        for name, movement in zip(names, own, strict=True)
    )
    if carried:
        yield f"  and {counted(len(carried), 'child link')} with them"


def _total(comparison: Comparison, width: int) -> Iterator[str]:
    """Mass and centre of mass of the whole robot."""
    old, new = comparison.whole.mass, comparison.whole_after.mass
    yield f"  mass            {old:g} kg -> {new:g} kg ({new - old:+.4g} kg)"
    if comparison.centers:
        places = [spaced(center, 4) for center in comparison.centers]
        moved = 1000 * comparison.center_moved
        text = f"{places[0]} -> {places[1]} m ({moved:.4g} mm)"
    else:
        reason = comparison.whole.reason or comparison.whole_after.reason
        text = f"not compared: {reason or 'one has no mass'}"
    yield f"  centre of mass  {wrap(text, width - 18, indent=18)}"


def _findings(sign: str, findings: Iterable[Diagnostic], width: int) -> Iterator[str]:
    for finding in findings:
        words = f"{finding.span}: {finding.severity.value} {finding.code} {finding.message}"
        yield f"{sign} {wrap(printable(words), width - 4, indent=6)}"
