"""Many findings of one cause, shown as one.

People read them so, in a terminal, a pull request or a page. A program gets each by itself: an
editor marks every place, and a baseline must know the thirty-first as new.
"""

from collections.abc import Iterator, Sequence

from urdfkit.core.words import more_like_this
from urdfkit.text.diagnostic import Diagnostic, Fix, Related

#: Findings that are alike and still shown one by one.
MAX_SINGLE = 2
#: Of the others, those whose places are shown.
MAX_NOTES = 20
#: Rules whose findings in several files have one cause outside of them: a package is not found.
_ACROSS_FILES = frozenset(("XAC011",))


def grouped(diagnostics: Sequence[Diagnostic]) -> tuple[Diagnostic, ...]:
    """Findings, with those of a file that are alike in the place of the first of them."""
    return tuple(_as_one(group) if len(group) > 1 else group[0] for group in groups(diagnostics))


def groups(diagnostics: Sequence[Diagnostic]) -> Iterator[list[Diagnostic]]:
    """The findings that are shown as one, in the order of the first of each."""
    alike: dict[object, list[Diagnostic]] = {}
    for number, one in enumerate(diagnostics):
        key: object = number
        if one.group_key:
            path = "" if one.code in _ACROSS_FILES else one.span.source.path
            key = (one.code, one.severity, one.group_key, path, one.variants)
        alike.setdefault(key, []).append(one)
    for group in alike.values():
        most = 1 if group[0].code in _ACROSS_FILES else MAX_SINGLE
        yield from [group] if len(group) > most else ([one] for one in group)


def _as_one(group: list[Diagnostic]) -> Diagnostic:
    first, *others = group
    return first._replace(
        message=first.message + more_like_this(len(others)),
        related=first.related + tuple(_note(other, first) for other in others[:MAX_NOTES]),
        fix=_together([one.fix for one in group]),
    )


def _note(other: Diagnostic, first: Diagnostic) -> Related:
    """The note about another one: its help, too, if that is its own."""
    if other.code in _ACROSS_FILES:
        return Related(other.span, without_search(other.message))
    own = other.help if other.help != first.help else ""
    return Related(other.span, f"{other.message}: {own}" if own else other.message)


def without_search(message: str) -> str:
    """A message without the places that were searched, which is long and the same in others."""
    return message.partition("; searched: ")[0].partition("; tried ")[0]


def _together(fixes: list[Fix | None]) -> Fix | None:
    """The fixes of all as one; none if one of them has none."""
    known = [fix for fix in fixes if fix is not None]
    if not known or len(known) < len(fixes):
        return None
    edits = dict.fromkeys(edit for fix in known for edit in fix.edits)  # two may share a fix
    title = known[0].title + more_like_this(len(known) - 1)
    return Fix(title, tuple(edits), all(fix.safe for fix in known))
