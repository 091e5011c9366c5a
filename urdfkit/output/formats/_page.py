"""Findings as text: locations, source lines, macro calls, notes, fixes."""

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise, takewhile

from urdfkit.core.grouping import by_key
from urdfkit.core.words import counted, few
from urdfkit.lint.grouping import without_search
from urdfkit.text.diagnostic import Call, Confidence, Diagnostic, Severity
from urdfkit.text.document import Step
from urdfkit.text.source import Span, shown
from urdfkit.text.terminal import CYAN, RED, YELLOW, columns, frame, painted, printable, wrap

#: Calls of one macro, and steps of one trace, that are shown.
MAX_CALLS = 8
#: Most notes longer than a line that are shown with their messages.
MAX_NOTES = 3
#: Least number of common words at the end of two messages that are not repeated.
CLAUSE = 4
#: Colours of severities.
COLORS = {Severity.ERROR: RED, Severity.WARNING: YELLOW, Severity.INFO: CYAN}

_STEPS = {
    "macro": "expanded from macro '{}' at",
    "include": "included at",
    "launch": "launched from",
}
_GUTTER = 8  # columns before a line of source


class TextPage:
    """Formats findings for a width, with or without colours."""

    def __init__(self, color: bool, width: int) -> None:
        self.color = color
        self.width = max(width, 40)
        self._paths: dict[str, str] = {}

    def finding(self, diagnostic: Diagnostic) -> str:
        """A finding with its source line, expansion traces, notes, help and fix."""
        blocks = [
            self.head(diagnostic),
            *self._frame(diagnostic.span, diagnostic.severity),
            *self._traces(diagnostic),
            *self._notes(diagnostic),
        ]
        if diagnostic.variants:
            blocks.append(self._labelled("variants", ", ".join(diagnostic.variants)))
        title = diagnostic.fix.title if diagnostic.fix else ""
        if diagnostic.help and diagnostic.help != title:
            blocks.append(self._labelled("help", diagnostic.help))
        if title:
            blocks.append(self._labelled("fix", title))
        return _lines(blocks)

    def brief(self, group: Sequence[Diagnostic]) -> str:
        """Similar findings in a few lines: locations, message, and fix or help."""
        first, *similar = group
        blocks = [self.head(first._replace(message=without_search(first.message)))]
        if macros := [
            step for step in (first.calls[0].via if first.calls else ()) if step.kind == "macro"
        ]:
            more = f" and {counted(len(first.calls) - 1, 'more place')}" if first.calls[1:] else ""
            where = self._near(macros[-1].span, first.span) + more
            blocks.append(self._step("macro", macros[-1].name, where))
        if similar:
            places = few(self._places([item.span for item in similar], first.span), MAX_CALLS)
            blocks.append(self._labelled(f"{len(similar)} more like this", places))
        if first.variants:
            blocks.append(self._labelled("variants", ", ".join(first.variants)))
        if first.fix:
            blocks.append(self._labelled("fix", first.fix.title))
        elif first.help:
            blocks.append(self._labelled("help", first.help))
        return _lines(blocks)

    def head(self, diagnostic: Diagnostic) -> str:
        """Location, severity, code and message."""
        place, severity = self.place(diagnostic.span), diagnostic.severity
        remarks = [f"for {name}" for name in diagnostic.targets]
        if diagnostic.confidence is not Confidence.MEASURED:
            remarks.append(diagnostic.confidence.value)
        message = diagnostic.message + (f" ({', '.join(remarks)})" if remarks else "")
        used = columns(f"{place}: {severity.value} {diagnostic.code} ")
        kind = f"{self.paint(severity.value, COLORS[severity])} {self.paint(diagnostic.code, '1')}"
        return f"{self.paint(place, '1')}: {kind} {self.wrap(message, indent=4, used=used)}"

    def _notes(self, diagnostic: Diagnostic) -> Iterator[str]:
        """Notes on related locations; locations with the same message share a note.

        Of many notes that are longer than a line, only the first have their messages.
        """
        notes: list[tuple[str, list[Span]]] = []
        by_message = by_key((related.message, related.span) for related in diagnostic.related)
        for message, spans in by_message.items():
            places = self._places(spans, diagnostic.span)
            text = (
                f"{message}: {few(places, MAX_CALLS)}" if spans[1:] else f"{places[0]}: {message}"
            )
            notes.append((text, spans))
        is_long = any(columns(f"  note: {text}") > self.width for text, _ in notes)
        shown = MAX_NOTES if is_long and len(notes) > MAX_NOTES + 1 else len(notes)
        for text, _ in notes[:shown]:
            yield self._labelled("note", text)
        if more := [span for _, spans in notes[shown:] for span in spans]:
            where = few(self._places(more, diagnostic.span), MAX_CALLS)
            yield self._labelled("note", f"{counted(len(more), 'more place')}: {where}")

    def _places(self, spans: Sequence[Span], near: Span) -> list[str]:
        return [self._near(span, last) for last, span in pairwise((near, *spans))]

    def _frame(self, span: Span, severity: Severity) -> Iterator[str]:
        line, carets = frame(span, self.width - _GUTTER)
        if line:
            yield f"{span.line:>5} | {line}"
            yield f"      | {self.paint(carets, COLORS[severity])}"

    def _labelled(self, label: str, text: str) -> str:
        used = 2 + len(f"{label}: ")
        return f"  {self.paint(f'{label}:', '1')} {self.wrap(text, indent=used, used=used)}"

    def _traces(self, diagnostic: Diagnostic) -> Iterator[str]:
        """Expansion traces, innermost step first.

        Steps that all calls share are printed once: inner steps before the calls, outer steps
        after them.
        """
        traces = [call.via[::-1] for call in diagnostic.calls]
        if len(traces) < 2 and not any(traces):
            return
        inner = _shared(traces)
        own = [trace[inner:] for trace in traces]
        outer = _shared([trace[::-1] for trace in own])
        yield from self._steps(traces[0][:inner])
        if len(traces) > 1:
            heading = "expanded from {} places" if any(own) else "{} findings here"
            yield f"  {heading.format(len(traces))}:"
            for call, trace in zip(diagnostic.calls[:MAX_CALLS], own, strict=False):
                yield self._call(call, trace[: len(trace) - outer], diagnostic)
            if len(traces) > MAX_CALLS:
                yield f"    and {len(traces) - MAX_CALLS} more"
        yield from self._steps(own[0][len(own[0]) - outer :])

    def _call(self, call: Call, trace: Sequence[Step], diagnostic: Diagnostic) -> str:
        """One of several calls: its location, and the part of its message that is new."""
        places = [self._near(step.span, diagnostic.span) for step in trace[:MAX_CALLS]]
        is_same = call.message == diagnostic.message
        text = call.element if is_same else _difference(call.message, diagnostic.message)
        where = ", from ".join(places)
        # A path that is longer than a line is not moved to the next line.
        return "    " + self.wrap(f"{where}: {text}" if where else text, indent=6, used=4).lstrip()

    def _steps(self, trace: Sequence[Step]) -> Iterator[str]:
        for number, step in enumerate(trace):
            if MAX_CALLS <= number < len(trace) - 1:  # the outermost step is always shown
                if number == MAX_CALLS:
                    yield f"  ... {counted(len(trace) - MAX_CALLS - 1, 'more call')} ..."
                continue
            yield self._step(step.kind, step.name, self.place(step.span))

    def _step(self, kind: str, name: str, where: str) -> str:
        return f"  {self.wrap(f'{_STEPS[kind].format(name)} {where}', indent=4, used=2)}"

    def _near(self, span: Span, other: Span) -> str:
        """A location; without the path if the other location, shown before, has the same path."""
        if span.source.path != other.source.path:
            return self.place(span)
        return f"line {span.line}:{span.column}"

    def place(self, span: Span) -> str:
        return f"{self.path(span.source.path)}:{span.line}:{span.column}"

    def path(self, path: str) -> str:
        """A path as it is shown; cached, as many findings share a path."""
        if path not in self._paths:
            self._paths[path] = printable(shown(path))
        return self._paths[path]

    def wrap(self, text: str, *, indent: int, used: int = 0) -> str:
        return wrap(printable(text), self.width, indent=indent, used=used)

    def paint(self, text: str, code: str) -> str:
        return painted(text, code) if self.color else text


def _lines(blocks: Iterable[str]) -> str:
    return "".join(f"{line.rstrip()}\n" for block in blocks for line in block.split("\n"))


def _difference(message: str, other: str) -> str:
    """A message without the clause at its end that another message ends with, too."""
    words, others = without_search(message).split(" "), without_search(other).split(" ")
    pairs = zip(words[::-1], others[::-1], strict=False)
    shared = len(list(takewhile(lambda pair: pair[0] == pair[1], pairs)))
    return " ".join(words[: len(words) - shared] if shared >= CLAUSE else words).rstrip(":;,")


def _shared(traces: Sequence[Sequence[Step]]) -> int:
    """Number of first steps that all traces share."""
    shared = min(map(len, traces))
    while any(trace[:shared] != traces[0][:shared] for trace in traces):
        shared -= 1
    return shared
