import pytest

from tests.output.formats.made import diagnostic, macro, report, span
from urdfkit.lint.report import Crashed
from urdfkit.output import formats
from urdfkit.text.diagnostic import Call, Edit, Fix, Related, Severity
from urdfkit.text.source import Source

render = formats.get("text")

ROBOT = Source("robot.urdf", b'<robot name="r">\n  <link name="arm"/>\n</robot>\n')
ARM = span(ROBOT, '"arm"')
CALLS = Source("robot.xacro", b"<x>\n<a/>\n<b/>\n<c/>\n</x>")


def shown(*found: object, **changes: object) -> str:
    """The text of a report, without the hints and the summary."""
    return render(report(*found, **changes)).partition("\nExplain a code:")[0]  # type: ignore[arg-type]


def test_errors_come_first_and_in_full_and_warnings_are_brief() -> None:
    warning = diagnostic(
        span(ROBOT, "<robot"), help="make it shorter", related=(Related(ARM, "the arm"),)
    )
    error = diagnostic(ARM, severity=Severity.ERROR, related=(Related(ARM, "the arm"),))
    assert render(report(warning, error)) == (
        """\
robot.urdf:2:14: error ABC123 link 'arm': 2 m is over 1 m
    2 | <link name="arm"/>
      |            ^^^^^
  note: line 2:14: the arm

robot.urdf:1:1: warning ABC123 link 'arm': 2 m is over 1 m
  help: make it shorter

Explain a code: urdfkit explain ABC123
1 error, 1 warning in 1 file
"""
    )


@pytest.mark.parametrize(
    ("message", "whole"),
    [("link {}", 5), ("link {}: " + 9 * "the mesh ", 3)],
    ids=["short", "long"],
)
def test_of_many_long_notes_only_the_first_have_their_messages(message: str, whole: int) -> None:
    related = tuple(Related(ARM, message.format(number)) for number in range(5))
    text = shown(diagnostic(ARM, severity=Severity.ERROR, related=related))
    assert text.count("  note: line 2:14: link") == whole
    assert ("  note: 2 more places: line 2:14, line 2:14" in text) == (whole < 5)


def test_nothing_found() -> None:
    assert render(report()) == "no findings in 1 file\n"


def test_infos_are_one_line() -> None:
    found = [
        diagnostic(ARM, severity=Severity.INFO, code=code)
        for code in ("ABC001", "ABC002", "ABC002", *(f"XYZ{number:03}" for number in range(6)))
    ]
    assert render(report(*found)) == (
        """\
Not shown: 9 infos (ABC002, ABC001, XYZ000, XYZ001, XYZ002, XYZ003 and 2 more);
  --info shows them
Explain a code: urdfkit explain ABC001
9 infos in 1 file
"""
    )


def test_the_code_to_explain_is_that_of_the_worst_finding() -> None:
    info = diagnostic(ARM, severity=Severity.INFO, code="ABC001")
    warning = diagnostic(ARM, code="ABC002")
    assert "urdfkit explain ABC002\n" in render(report(info, warning))


def test_what_was_searched_is_left_to_the_full_format() -> None:
    found = diagnostic(ARM, message="package 'p' is not found; searched: /a, /b")
    assert " ".join(shown(found).split()) == (
        "robot.urdf:2:14: warning ABC123 package 'p' is not found"
    )


def test_a_fix_stands_for_the_help() -> None:
    found = diagnostic(ARM, help="make it shorter", fix=Fix("write 'leg'", (Edit(ARM, "leg"),)))
    assert shown(found).splitlines()[1:] == ["  fix: write 'leg'"]


def test_findings_that_are_alike_are_one_with_the_places_of_the_others() -> None:
    found = [
        diagnostic(span(CALLS, f"<{name}/>"), message=f"link '{name}'", group_key="key")
        for name in "abc"
    ]
    assert shown(*found).splitlines() == [
        "robot.xacro:2:1: warning ABC123 link 'a'",
        "  2 more like this: line 3:1, line 4:1",
    ]


def test_a_call_in_the_file_of_the_finding_is_a_line() -> None:
    way = (macro("inner", span(ROBOT, "<robot")),)
    found = diagnostic(ARM, calls=(Call("m", way, "e"),))
    assert shown(found).splitlines()[1:] == ["  expanded from macro 'inner' at line 1:1"]


@pytest.mark.parametrize(("calls", "more"), [("a", ""), ("ab", " and 1 more place")])
def test_the_innermost_call_of_a_macro_is_named(calls: str, more: str) -> None:
    ways = [(macro("outer", ARM), macro("inner", span(CALLS, f"<{name}/>"))) for name in calls]
    found = diagnostic(ARM, calls=tuple(Call("m", way, "e") for way in ways))
    assert shown(found).splitlines()[1:] == [
        f"  expanded from macro 'inner' at robot.xacro:2:1{more}"
    ]


def test_a_long_place_of_a_call_is_on_a_line_of_its_own() -> None:
    deep = Source(f"{'d' * 50}/robot.xacro", CALLS.data)
    found = diagnostic(ARM, calls=(Call("m", (macro("inner", span(deep, "<a/>")),), "e"),))
    assert shown(found).splitlines()[1:] == [
        "  expanded from macro 'inner' at",
        f"    {deep.path}:2:1",
    ]


def test_the_variants_that_have_a_finding_are_a_line() -> None:
    assert "\n  variants: left, right" in shown(diagnostic(ARM, variants=("left", "right")))


def test_a_crash_follows_the_findings() -> None:
    crashed = (Crashed("ABC001", "a.urdf", "ValueError: boom"),)
    text = shown(diagnostic(ARM), crashed=crashed)
    assert text.split("\n\n")[1].startswith("a.urdf: ABC001 failed with ValueError: boom.")


def test_colours_only_when_asked_for() -> None:
    found = diagnostic(ARM, help="h")
    assert "\x1b" not in render(report(found))
    assert "\x1b[1;33mwarning\x1b[0m" in render(report(found), color=True)


def test_notes_of_findings_that_are_alike_name_what_they_are_about() -> None:
    message = "link '{}': the visual mesh '{}.stl' does not exist"
    offers = {"a": "use one", "b": "use one", "c": "use another"}
    errors = (
        diagnostic(
            ARM,
            severity=Severity.ERROR,
            message=message.format(name, name),
            help=help,
            group_key="lost",
        )
        for name, help in offers.items()
    )
    lines = shown(*errors).splitlines()
    assert "  note: line 2:14: link 'b'" in lines
    assert "  note: line 2:14: link 'c': use another" in lines
