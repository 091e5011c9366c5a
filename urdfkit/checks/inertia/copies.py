"""Merges findings about copies of one tensor."""

from collections.abc import Callable, Iterable

from urdfkit.core.words import few, listed
from urdfkit.lint.rules import Finding, Findings, Fix, Related
from urdfkit.robot.inertials.diagnosis import MAX_RELATED
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.text.editing.edits import from_macro


def together(
    findings: Iterable[tuple[LinkInertia, Finding]],
    by: Callable[[LinkInertia], object] = lambda inertia: inertia.tensor,
) -> Findings:
    """One finding for all copies of a tensor: that of the worst copy.

    Tensors in macros are not merged here: the engine merges the calls of a macro.

    Args:
        by: the key that copies have in common.
    """
    groups: dict[object, list[tuple[LinkInertia, Finding]]] = {}
    for inertia, finding in findings:
        if from_macro(inertia.at):
            yield finding
        else:
            groups.setdefault(by(inertia), []).append((inertia, finding))
    for group in groups.values():
        group.sort(key=lambda pair: -pair[1].weight)
        (_, worst), *others = group
        if not others:
            yield worst
            continue
        yield worst._replace(
            message=f"{worst.message} ({and_more(others)})",
            related=tuple(Related(other.span, other.message) for _, other in others[:MAX_RELATED]),
            fix=_merged([finding.fix for _, finding in group if finding.fix]),
        )


def _merged(fixes: list[Fix]) -> Fix | None:
    if len(fixes) < 2:
        return fixes[0] if fixes else None
    edits = tuple(edit for fix in fixes for edit in fix.edits)
    return Fix(f"write the tensors of {len(fixes)} shapes", edits)


def and_more(others: list[tuple[LinkInertia, Finding]]) -> str:
    """Such as ``also 'b', 'c' and 3 more``."""
    names = [f"'{inertia.link.name}'" for inertia, _ in others]
    return f"also {few(names, 2) if len(names) > 3 else listed(names)}"
