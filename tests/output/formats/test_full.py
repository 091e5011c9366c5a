import os
from pathlib import Path

import pytest

from tests.output.formats.made import diagnostic, macro, report, span
from urdfkit.lint.report import Crashed, Launched, Report, Skipped
from urdfkit.output import formats
from urdfkit.output.formats._summary import summary
from urdfkit.ros.targets import Targets
from urdfkit.text.diagnostic import Call, Confidence, Edit, Fix, Related, Severity
from urdfkit.text.document import Step
from urdfkit.text.source import Source, Span

render = formats.get("full")

PLAIN = Source("robot.urdf", b'<robot name="r">\n  <link name="arm"/>\n</robot>\n')

XACRO = Source(
    "robot.xacro",
    b"""\
<robot xmlns:xacro="x">
  <xacro:macro name="inertial"><inertia ixx="1"/></xacro:macro>
  <xacro:macro name="wheel"><xacro:inertial/></xacro:macro>
  <xacro:wheel n="1"/>
  <xacro:wheel n="2"/>
  <xacro:inertial/>
</robot>
""",
)
INERTIA = span(XACRO, '<inertia ixx="1"/>')
INNER = macro("inertial", span(XACRO, "<xacro:inertial/>"))
OTHER = macro("inertial", span(XACRO, "<xacro:inertial/>", 2))
WHEELS = [macro("wheel", span(XACRO, f'<xacro:wheel n="{n}"/>')) for n in (1, 2)]
TOP = Source("top.xacro", b'<robot>\n<xacro:include filename="robot.xacro"/></robot>')
INCLUDED = Step(
    "include", "robot.xacro", span(TOP, '<xacro:include filename="robot.xacro"/>'), None
)


def body(text: str) -> str:
    """The text of a report with one finding, without the lines that every report ends with."""
    return text[: text.index("\nExplain a code:")]


def test_a_finding_has_its_place_its_line_and_its_help() -> None:
    found = diagnostic(span(PLAIN, '"arm"'), help="make it shorter")
    assert (
        render(report(found))
        == """\
robot.urdf:2:14: warning ABC123 link 'arm': 2 m is over 1 m
    2 | <link name="arm"/>
      |            ^^^^^
  help: make it shorter

Explain a code: urdfkit explain ABC123
1 warning in 1 file
"""
    )


def test_nothing_found() -> None:
    assert render(report()) == "no findings in 1 file\n"


def test_notes_and_a_fix() -> None:
    at = span(PLAIN, "arm")
    found = diagnostic(
        at,
        related=(
            Related(span(PLAIN, "<robot"), "the robot begins here"),
            Related(span(XACRO, "<robot"), "another begins here"),
        ),
        fix=Fix("write 'leg'", (Edit(at, "leg"),)),
    )
    assert body(render(report(found))).splitlines()[3:] == [
        "  note: line 1:1: the robot begins here",
        "  note: robot.xacro:1:1: another begins here",
        "  fix: write 'leg'",
    ]


def test_a_fix_that_the_help_describes_is_reported_once() -> None:
    at = span(PLAIN, "arm")
    found = diagnostic(at, help="write 'leg'", fix=Fix("write 'leg'", (Edit(at, "leg"),)))
    text = render(report(found))
    assert text.count("write 'leg'") == 1
    assert "\n  fix: write 'leg'\n" in text


@pytest.mark.parametrize("confidence", [Confidence.INFERRED, Confidence.GUESSED])
def test_less_than_certain_is_said(confidence: Confidence) -> None:
    text = render(report(diagnostic(span(PLAIN, "arm"), confidence=confidence)))
    assert text.splitlines()[0].endswith(f"2 m is over 1 m ({confidence.value})")


def test_for_whom_it_is_weighed_is_said_once_with_the_reason() -> None:
    found = diagnostic(span(PLAIN, "arm"), targets=("ros1", "kdl"), confidence=Confidence.GUESSED)
    inferred = Targets(("ros1",), ("ros1: package.xml",))
    checked = report(found, targets=(("a.urdf", inferred), ("b.urdf", inferred)))
    text = render(checked, width=100)
    assert text.splitlines()[0].endswith("2 m is over 1 m (for ros1, for kdl, guessed)")
    assert text.count("Targets: ros1 (package.xml); override with --target\n") == 1
    given = report(found, targets=(("a.urdf", Targets(("ros1",))),))
    assert "Weighed" not in render(given)


def test_an_empty_file_has_no_frame() -> None:
    found = diagnostic(Span(Source("robot.urdf", b""), 0, 0))
    assert body(render(report(found))) == (
        "robot.urdf:1:1: warning ABC123 link 'arm': 2 m is over 1 m\n"
    )


def test_one_call_shows_the_way_from_the_place_outwards() -> None:
    via = (INCLUDED, WHEELS[0], INNER)
    found = diagnostic(INERTIA, calls=(Call("m", via, "e"),))
    assert body(render(report(found))).splitlines()[3:] == [
        "  expanded from macro 'inertial' at robot.xacro:3:29",
        "  expanded from macro 'wheel' at robot.xacro:4:3",
        "  included at top.xacro:2:1",
    ]


def test_several_calls_have_their_own_messages_and_places() -> None:
    calls = (
        Call("link 'a': 9 kg", (OTHER,), "link/a"),
        Call("link 'b': 5 kg", (WHEELS[0], INNER), "link/b"),
    )
    found = diagnostic(INERTIA, message="link 'a': 9 kg", calls=calls)
    assert body(render(report(found))).splitlines()[3:] == [
        "  expanded from 2 places:",
        "    line 6:3: link/a",
        "    line 3:29, from line 4:3: link 'b': 5 kg",
    ]


def test_what_all_calls_share_is_said_once() -> None:
    calls = tuple(
        Call(f"link '{n}': 5 kg", (INCLUDED, wheel, INNER), f"link/{n}")
        for n, wheel in enumerate(WHEELS)
    )
    found = diagnostic(INERTIA, message="link '0': 5 kg", calls=calls)
    assert body(render(report(found))).splitlines()[3:] == [
        "  expanded from macro 'inertial' at robot.xacro:3:29",
        "  expanded from 2 places:",
        "    line 4:3: link/0",
        "    line 5:3: link '1': 5 kg",
        "  included at top.xacro:2:1",
    ]


def test_the_clause_that_messages_end_with_is_said_once() -> None:
    end = "does not exist in package 'arm'"
    calls = tuple(
        Call(f"link '{n}': the mesh {n}.stl {end}; tried meshes/{n}.stl", (wheel,), f"link/{n}")
        for n, wheel in enumerate(WHEELS)
    )
    found = diagnostic(INERTIA, message=calls[0].message, calls=calls)
    assert body(render(report(found))).splitlines()[4:] == [
        "  expanded from 2 places:",
        "    line 4:3: link/0",
        "    line 5:3: link '1': the mesh 1.stl",
    ]


def test_no_punctuation_stands_before_a_clause_that_is_left_out() -> None:
    calls = tuple(
        Call(f"link '{n}': 1 kg m^2 is 871 times too much", (wheel,), f"link/{n}")
        for n, wheel in enumerate(WHEELS)
    )
    found = diagnostic(INERTIA, message=calls[0].message, calls=calls)
    assert body(render(report(found))).splitlines()[-1] == "    line 5:3: link '1'"


def test_places_of_one_message_are_one_note() -> None:
    file = Source("sizes.yaml", b"a: 1\nb: 2\nc: 3\n")
    related = [Related(Span(file, start, start + 1), "given here") for start in (3, 8, 13)]
    related.append(Related(OTHER.span, "the macro"))
    found = diagnostic(INERTIA, related=tuple(related))
    assert body(render(report(found))).splitlines()[3:] == [
        "  note: given here: sizes.yaml:1:4, line 2:4, line 3:4",
        "  note: line 6:3: the macro",
    ]


def test_two_findings_of_one_call() -> None:
    calls = (Call("one", (OTHER,), "a"), Call("two", (OTHER,), "a"))
    found = diagnostic(INERTIA, message="one", calls=calls)
    assert body(render(report(found))).splitlines()[3:] == [
        "  expanded from macro 'inertial' at robot.xacro:6:3",
        "  2 findings here:",
        "    a",
        "    two",
    ]


def test_at_most_eight_calls_are_listed() -> None:
    source = Source("many.xacro", b"<a/>\n" * 100)
    calls = tuple(
        Call(f"link {n}", (macro("m", Span(source, 5 * n, 5 * n + 4)),), f"e{n}")
        for n in range(100)
    )
    lines = body(render(report(diagnostic(INERTIA, message="link 0", calls=calls)))).splitlines()
    assert lines[3] == "  expanded from 100 places:"
    assert lines[4] == "    many.xacro:1:1: e0"
    assert lines[11:] == ["    many.xacro:8:1: link 7", "    and 92 more"]


def test_of_a_long_way_both_ends_are_shown() -> None:
    source = Source("deep.xacro", b"<a/>\n" * 200)
    via = tuple(macro(f"m{n}", Span(source, 5 * n, 5 * n + 4)) for n in range(200))
    lines = body(render(report(diagnostic(INERTIA, calls=(Call("m", via, "e"),))))).splitlines()[3:]
    assert lines[0] == "  expanded from macro 'm199' at deep.xacro:200:1"
    assert lines[7:] == [
        "  expanded from macro 'm192' at deep.xacro:193:1",
        "  ... 191 more calls ...",
        "  expanded from macro 'm0' at deep.xacro:1:1",
    ]


def test_long_texts_keep_to_the_width() -> None:
    found = diagnostic(
        span(PLAIN, "arm"), message="word " * 60 + "end", help="do " * 60, severity=Severity.ERROR
    )
    text = render(report(found), width=80)
    assert max(map(len, text.splitlines())) <= 80
    assert text.startswith("robot.urdf:2:15: error ABC123 word word")
    assert "\n    word word" in text
    assert "\n        do do" in text, "help hangs below itself"


def test_nothing_ends_in_white_space() -> None:
    source = Source("a" * 70 + ".urdf", PLAIN.data)
    text = render(report(diagnostic(span(source, "arm"))))
    assert [line for line in text.splitlines() if line != line.rstrip()] == []


def test_colours_only_when_asked_for() -> None:
    found = diagnostic(span(PLAIN, "arm"), severity=Severity.ERROR, help="h")
    plain, coloured = render(report(found)), render(report(found), color=True)
    assert "\x1b" not in plain
    assert "\x1b[1;31merror\x1b[0m" in coloured
    assert "\x1b[1;31m1 error\x1b[0m in 1 file" in coloured
    assert "\x1b[1;31m^^^" in coloured.replace(" ", "")
    assert _without_colours(coloured) == plain


def _without_colours(text: str) -> str:
    for code in ("0", "1", "1;31", "1;33", "1;36"):
        text = text.replace(f"\x1b[{code}m", "")
    return text


def test_nothing_of_the_robot_steers_the_terminal() -> None:
    evil = "\x1b[2J\n::error::\x07"
    source = Source(f"{evil}.urdf", f"<robot name='{evil}'/>".encode())
    at = Span(source, 0, 15)
    found = diagnostic(
        at,
        message=evil,
        help=evil,
        related=(Related(at, evil),),
        fix=Fix(evil + "!", (Edit(at, evil),)),
        calls=(
            Call(evil, (macro(evil, at),), evil),
            Call(evil + "2", (macro(evil, Span(source, 1, 2)),), evil),
        ),
    )
    text = render(
        report(
            found,
            skipped=(Skipped("ABC123", evil, evil),),
            crashed=(Crashed("ABC123", evil, evil),),
        )
    )
    assert all(char == "\n" or char.isprintable() for char in text)
    assert not any(line.startswith("::") for line in text.splitlines())


def test_paths_are_relative_where_that_is_shorter(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    inside, outside = tmp_path / "a" / "robot.urdf", Path("/x.urdf")
    monkeypatch.chdir(tmp_path)
    texts = [
        render(report(diagnostic(span(Source(str(path), PLAIN.data), "arm"))))
        for path in (inside, outside)
    ]
    assert texts[0].startswith(os.path.join("a", "robot.urdf") + ":2:15: ")
    assert texts[1].startswith("/x.urdf:2:15: ")
    here = render(report(diagnostic(span(Source("./robot.urdf", PLAIN.data), "arm"))))
    assert here.startswith("robot.urdf:2:15: ")


def test_skipped_rules_are_counted_by_reason() -> None:
    checked = report(
        skipped=(
            Skipped("ABC001", "a.urdf", "not a xacro"),
            Skipped("ABC001", "b.urdf", "not a xacro"),
            Skipped("ABC002", "a.urdf", "not a xacro"),
            Skipped("ABC003", "a.urdf", "it cannot be read"),
            Skipped("", "c.xacro", "it needs arguments"),
            Skipped("", "d.xacro", "it needs arguments"),
            *(Skipped("", f"{number}.xacro", "it makes no link") for number in range(4)),
        ),
        suppressed=1,
        tolerated=4,
        files=("a.urdf", "b.urdf"),
    )
    assert render(checked, width=300) == (
        "no new findings in 2 files (1 rule skipped: it cannot be read; 2 rules skipped: not a"
        " xacro; 4 files skipped: it makes no link; c.xacro, d.xacro skipped: it needs arguments;"
        " 1 finding suppressed; 4 findings in the baseline)\n"
    )


def test_a_crash_is_shown_as_our_bug() -> None:
    checked = report(crashed=(Crashed("ABC001", "a.urdf", "ValueError: boom"),))
    assert render(checked, width=200) == (
        "a.urdf: ABC001 failed with ValueError: boom. This is a bug in urdfkit, not in the robot:"
        " please report it with the file.\n"
        "no findings in 1 file (1 rule crashed)\n"
    )


@pytest.mark.parametrize(
    ("severities", "line"),
    [
        ("e", "1 error in 1 file\n"),
        ("ewwi", "1 error, 2 warnings, 1 info in 1 file\n"),
        ("ii", "2 infos in 1 file\n"),
    ],
)
def test_the_summary_counts_by_severity(severities: str, line: str) -> None:
    by_letter = {severity.value[0]: severity for severity in Severity}
    found = [diagnostic(span(PLAIN, "arm"), severity=by_letter[letter]) for letter in severities]
    assert summary(report(*found)) == line


def test_a_deleted_current_directory_is_no_matter(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "gone").mkdir()
    monkeypatch.chdir(tmp_path / "gone")
    (tmp_path / "gone").rmdir()
    assert render(report(diagnostic(span(Source("/a/b.urdf", PLAIN.data), "arm")))).startswith(
        "/a/b.urdf:2:15: "
    )


def test_findings_stand_in_the_order_of_the_report() -> None:
    found = [diagnostic(span(PLAIN, "arm"), message=word) for word in ("two", "one", "three")]
    text = render(Report(("robot.urdf",), tuple(found), (), (), ()))
    messages = [line.partition("ABC123 ")[2] for line in text.splitlines()]
    assert list(filter(None, messages)) == ["two", "one", "three"]


def test_the_variants_that_have_a_finding_are_a_line() -> None:
    found = diagnostic(span(PLAIN, "arm"), help="make it shorter", variants=("left", "right"))
    assert "\n  variants: left, right\n  help: make it shorter\n" in render(report(found))
    assert "variants" not in render(report(found._replace(variants=())))


@pytest.mark.parametrize(
    ("count", "text"),
    [
        (4, "3.xacro with side left of 3.launch"),
        (5, "(5 robots with arguments of 5 launch files, see --show-files)"),
    ],
)
def test_arguments_of_many_robots_are_counted(count: int, text: str) -> None:
    launched = [Launched(f"{n}.xacro", f"{n}.launch", {"side": "left"}) for n in range(count)]
    assert text in render(report(launched=tuple(launched)), width=1000)
