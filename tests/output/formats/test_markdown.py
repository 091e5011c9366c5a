"""Markdown, as an independent reader renders it."""

from html.parser import HTMLParser
from pathlib import Path

import pytest

import urdfkit
from tests.conftest import MODELS
from tests.output.formats.made import diagnostic, report, span
from urdfkit.lint.grouping import grouped
from urdfkit.lint.report import Crashed, Report
from urdfkit.output.formats.markdown import MAX_ROWS, render
from urdfkit.text.diagnostic import Call, Severity
from urdfkit.text.markdown import MAX_TEXT
from urdfkit.text.source import Source

markdown_it = pytest.importorskip("markdown_it")

PLAIN = Source("urdf/robot.urdf", b'<robot name="r">\n  <link name="arm"/>\n</robot>\n')
#: What the format itself writes; anything else would come from a robot's file.
OWN_TAGS = set("h3 table thead tbody tr th td strong code sub br p details summary".split())


class _Reader(HTMLParser):
    """Gathers the cells of tables, the texts outside of them, and the tags."""

    def __init__(self) -> None:
        super().__init__()
        self.rows: list[list[str]] = []
        self.outside = ""
        self.tags: set[str] = set()
        self._in_cell = False

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.tags.add(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")
            self._in_cell = True
        if tag == "br":
            self.handle_data("\n")

    def handle_endtag(self, tag: str) -> None:
        self._in_cell = self._in_cell and tag not in ("td", "th")

    def handle_data(self, data: str) -> None:
        if self._in_cell:
            self.rows[-1][-1] += data
        else:
            self.outside += data


def read(checked: Report) -> _Reader:
    reader = _Reader()
    html = markdown_it.MarkdownIt("commonmark", {"html": True}).enable("table")
    reader.feed(html.render(render(checked)))
    assert reader.tags <= OWN_TAGS
    return reader


def rows(checked: Report) -> list[list[str]]:
    """The cells of all rows but the heads."""
    return [row for row in read(checked).rows if row != ["", "where", "what"]]


def test_a_row_for_every_finding_the_worst_first() -> None:
    checked = report(
        diagnostic(span(PLAIN, "robot"), severity=Severity.INFO, message="a hint"),
        diagnostic(span(PLAIN, "link"), severity=Severity.WARNING, message="doubtful"),
        diagnostic(
            span(PLAIN, "arm"),
            severity=Severity.ERROR,
            message="bad",
            help="correct it",
            code="ABC124",
        ),
    )
    assert rows(checked) == [
        ["error ABC124", "urdf/robot.urdf:2:15", "bad\ncorrect it"],
        ["warning ABC123", "urdf/robot.urdf:2:4", "doubtful"],
        ["info ABC123", "urdf/robot.urdf:1:2", "a hint"],
    ]
    outside = " ".join(read(checked).outside.split())
    assert outside.startswith("urdfkit: 1 error, 1 warning, 1 info in 1 file 1 info ")
    assert outside.endswith("Explain a code: urdfkit explain ABC124")


def test_nothing_found_is_a_heading() -> None:
    assert render(report()) == "### urdfkit: no findings in 1 file\n"


def test_a_crash_is_reported_as_a_bug_of_urdfkit() -> None:
    crash = Crashed("ABC003", "one.urdf", "ValueError: boom")
    assert "ABC003 crashed on one.urdf: ValueError: boom." in read(report(crashed=(crash,))).outside


def test_several_calls_are_counted() -> None:
    calls = (Call("a", (), "x"), Call("b", (), "y"), Call("c", (), "z"))
    ((_, _, what),) = rows(report(diagnostic(span(PLAIN, "arm"), calls=calls)))
    assert what.endswith("(expanded from 3 places)")


@pytest.mark.parametrize(
    "text",
    [
        "<img src=x onerror=alert(1)> &lt; <b>",
        "a | b \\| c",
        "`code` **bold** _x_ ~~gone~~ ![p](http://evil/x.png) [l](javascript:1)",
        "</details></table><script>x</script>",
        "package://a_b/meshes/c_d.dae $x$ {{ y }}",
        "<!-- urdfkit -->",
        "1. one\\",
        "轮子 🦾",
    ],
)
def test_what_looks_like_markup_is_shown_as_it_is(text: str) -> None:
    source = Source(f"{text.replace('/', '')}.urdf", b"<robot/>")
    found = diagnostic(span(source, "robot"), message=text, help=text)
    ((_, where, what),) = rows(report(found))
    assert what == f"{text}\n{text}"
    assert where == f"{source.path}:1:2"


def test_nobody_is_mentioned_and_nothing_is_linked() -> None:
    """GitHub finds these in the text, whatever the markup around them."""
    text = "@team #12 https://evil.example www.evil.example"
    rendered = render(report(diagnostic(span(PLAIN, "arm"), message=text)))
    assert not any(live in rendered for live in ("@team", "#12", "https://", "www."))
    ((_, _, what),) = rows(report(diagnostic(span(PLAIN, "arm"), message=text)))
    assert what.replace("\u200b", "") == text


def test_control_characters_and_line_ends_stay_in_their_cell() -> None:
    found = diagnostic(span(PLAIN, "arm"), message="a\nb\x1b[31m\u202ec")
    ((_, _, what),) = rows(report(found))
    assert what == "a b\\x1b[31m\\u202ec"


def test_it_fits_a_summary() -> None:
    """GitHub takes 1 MiB; names in a robot may be as long as a file."""
    findings = [
        diagnostic(span(PLAIN, "arm"), message="|" * 5000 + "!" * number, help="<" * 5000)
        for number in range(300)
    ]
    reported = rows(report(*findings))
    assert len(reported) == MAX_ROWS + 1
    assert reported[-1] == ["", "", "and 100 more"]
    assert all(len(row[2]) < 3 * MAX_TEXT for row in reported)
    assert len(render(report(*findings)).encode()) < 2**20


@pytest.mark.parametrize(
    "model", sorted(MODELS.rglob("*.urdf")) + sorted(MODELS.rglob("*.xacro")), ids=lambda p: p.name
)
def test_reports_of_the_models(model: Path) -> None:
    checked = urdfkit.check(model)
    reported = rows(checked)
    assert sorted(row[0] for row in reported) == sorted(
        f"{d.severity.value} {d.code}" for d in grouped(checked.diagnostics)
    )
