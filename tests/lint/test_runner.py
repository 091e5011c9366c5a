"""From what rules say to diagnostics: folding, weighing, and rules that could not look."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.hand_made_rules import run_only
from urdfkit import Report, Source, check
from urdfkit.errors import Unavailable
from urdfkit.lint import rule_index, runner
from urdfkit.lint.context import Context
from urdfkit.lint.findings import MAX_MESSAGE
from urdfkit.lint.rules import Finding, Location, Rule
from urdfkit.ros.targets import Targets
from urdfkit.text.diagnostic import Confidence, Diagnostic, Related, Severity
from urdfkit.text.document import Element
from urdfkit.text.source import Span
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro.origin import DataPlaces

BROKEN_XACRO = b"""\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="${no_such_property}"/>
</robot>
"""


def skipped(report: Report) -> dict[str, str]:
    """The reason by code; a rule is skipped once, and never one that ran."""
    by_code = {skip.code: skip.reason for skip in report.skipped}
    assert len(by_code) == len(report.skipped)
    assert not set(by_code) & set(report.rules)
    return by_code


def test_nothing_is_skipped_of_a_robot_that_can_be_read() -> None:
    assert check(Source("r.urdf", b'<robot name="r"><link name="a"/></robot>')).skipped == ()


@pytest.mark.parametrize("data", [b"", b"<robot><link></robot>"])
def test_a_plain_file_that_cannot_be_read(data: bytes) -> None:
    by_code = skipped(check(Source("r.urdf", data)))
    assert set(by_code.values()) == {"the description cannot be read"}
    assert {"URD001", "TRE003", "MSH001"} <= set(by_code)
    assert not [code for code in by_code if code.startswith(("XML", "XAC00", "CFG"))]


def test_a_xacro_that_does_not_expand() -> None:
    report = check(Source("r.urdf.xacro", BROKEN_XACRO))
    assert [found.code for found in report.diagnostics] == ["XAC001"]
    by_code = skipped(report)
    assert set(by_code.values()) == {"the xacro does not expand"}
    assert {"URD001", "TRE003", "XAC004"} <= set(by_code)
    assert "XAC001" not in by_code


def test_only_chosen_rules_are_skipped() -> None:
    report = check(Source("r.urdf", b"<robot"), select=["XML001", "TRE003"])
    assert list(skipped(report)) == ["TRE003"]


# --- folding and weighing, with rules made by hand

WHEELS = b"""\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wheel" params="n mass">
    <link name="${n}"><inertial><mass value="${mass}"/></inertial></link>
  </xacro:macro>
  <xacro:macro name="axle" params="n mass">
    <xacro:wheel n="${n}_left" mass="${mass}"/>
    <xacro:wheel n="${n}_right" mass="${mass}"/>
  </xacro:macro>
  <link name="base"/>
  <xacro:axle n="front" mass="1"/>
  <xacro:axle n="rear" mass="3"/>
</robot>
"""


def context(data: bytes = WHEELS, **options: Any) -> Context:
    path = "r.xacro" if b"xacro:" in data else "r.urdf"
    return Context(Source(path, data), Resolver(environment={}), **options)


def rule(find: Callable[[Context], Iterator[Finding]], **changes: Any) -> Rule:
    plain = Rule(
        "ABC001", "some-defect", Severity.WARNING, frozenset(), find, "", False, __name__, {}
    )
    return plain._replace(**changes)


def of_links(make: Callable[[str, Element], Finding]) -> Callable[[Context], Iterator[Finding]]:
    """A rule that says something of every link."""
    return lambda one: (make(link.name, link.at) for link in one.model.links)


@pytest.fixture
def judged(monkeypatch: pytest.MonkeyPatch) -> Callable[..., runner.FileResult]:
    """The verdict of some rules made by hand, and no others."""

    def run(*made: Rule, one: Context | None = None) -> runner.FileResult:
        run_only(monkeypatch, made)
        return runner.run_rules(one or context(), [])

    return run


def ways(diagnostic: Diagnostic) -> list[list[str]]:
    return [[step.name for step in call.via] for call in diagnostic.calls]


def test_what_one_macro_caused_is_one_diagnostic_with_its_calls(judged) -> None:
    verdict = judged(rule(of_links(lambda name, at: Finding(at, f"link '{name}'"))))
    base, wheel = verdict.diagnostics
    assert (base.message, ways(base), base.element) == ("link 'base'", [[]], "link/base")
    assert wheel.span.text == '<link name="${n}">'
    assert [call.message for call in wheel.calls] == [
        "link 'front_left'",
        "link 'front_right'",
        "link 'rear_left'",
        "link 'rear_right'",
    ]
    assert ways(wheel) == [["axle", "wheel"]] * 4
    assert wheel.message == wheel.calls[0].message


def test_the_worst_call_comes_first_and_speaks_for_all(judged) -> None:
    weights = {"front_left": 1.0, "front_right": 2.0, "rear_left": 5.0}
    verdict = judged(
        rule(
            of_links(
                lambda name, at: Finding(
                    at,
                    f"link '{name}'",
                    help=f"mend {name}",
                    related=(Related(at.span, name),),
                    confidence=Confidence.GUESSED if name == "rear_left" else Confidence.MEASURED,
                    weight=weights.get(name, 0.0),
                )
            )
        )
    )
    wheel = verdict.diagnostics[1]
    assert [call.message for call in wheel.calls] == [
        "link 'rear_left'",
        "link 'front_right'",
        "link 'front_left'",
        "link 'rear_right'",
    ]
    assert (wheel.message, wheel.help) == ("link 'rear_left'", "mend rear_left")
    assert wheel.related[0].message == "rear_left"
    assert wheel.confidence is Confidence.GUESSED


def test_two_defects_of_one_plain_place_stay_two(judged) -> None:
    def find(one: Context) -> Iterator[Finding]:
        root = one.document.root
        yield from (Finding(root, "first"), Finding(root, "second"))

    assert [d.message for d in judged(rule(find)).diagnostics] == ["first", "second"]


def test_two_places_of_one_macro_that_begin_together_stay_two(judged) -> None:
    def find(one: Context) -> Iterator[Finding]:
        for link in one.model.links:
            start = Span(link.at.span.source, link.at.span.start, link.at.span.start + 5)
            yield Finding(link.at, "whole")
            yield Finding(Location(start, link.at.frame), "start")

    found = judged(rule(find)).diagnostics
    assert [(d.message, len(d.calls)) for d in found] == [
        ("whole", 1), ("start", 1), ("whole", 4), ("start", 4),
    ]  # fmt: skip


def test_two_defects_of_one_place_in_a_robot_of_a_launch_file_stay_two(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def find(one: Context) -> Iterator[Finding]:
        if one.source.path.endswith(".urdf"):
            yield from (Finding(one.document.root, text) for text in ("first", "second"))

    (tmp_path / "r.urdf").write_text('<robot name="r"><link name="a"/></robot>')
    launch = tmp_path / "r.launch"
    launch.write_text(
        f'<launch><param name="robot_description" textfile="{tmp_path}/r.urdf"/></launch>'
    )
    run_only(monkeypatch, [rule(find)])
    found = check(launch).diagnostics
    assert [(d.message, [step.kind for step in d.calls[0].via]) for d in found] == [
        ("first", ["launch"]), ("second", ["launch"]),
    ]  # fmt: skip


def test_two_rules_are_never_folded(judged) -> None:
    find = of_links(lambda name, at: Finding(at, name))
    verdict = judged(rule(find), rule(find, code="ABC002", name="other-defect"))
    assert [(d.code, d.name, len(d.calls)) for d in verdict.diagnostics] == [
        ("ABC001", "some-defect", 1),
        ("ABC001", "some-defect", 4),
        ("ABC002", "other-defect", 1),
        ("ABC002", "other-defect", 4),
    ]


def test_a_place_that_is_no_element_has_no_path(judged) -> None:
    def find(one: Context) -> Iterator[Finding]:
        yield Finding(Location(Span(one.source, 0, 6)), "here")

    (found,) = judged(rule(find)).diagnostics
    assert (found.span.text, found.element, found.calls[0].via) == ("<robot", "", ())


def test_the_help_of_the_rule_stands_in(judged) -> None:
    find = of_links(lambda name, at: Finding(at, name, help="its own" if name == "base" else ""))
    base, wheel = judged(rule(find, help="of the rule")).diagnostics
    assert (base.help, wheel.help) == ("its own", "of the rule")


@pytest.mark.parametrize(
    ("targets", "severity", "affected"),
    [
        ((), Severity.WARNING, ()),
        (("ros2",), Severity.WARNING, ()),
        (("kdl",), Severity.INFO, ("kdl",)),
        (("ros2", "kdl", "mujoco", "drake"), Severity.ERROR, ("mujoco", "drake")),
    ],
)
def test_the_worst_severity_of_a_target_wins(judged, targets, severity, affected) -> None:
    by_target = {"mujoco": Severity.ERROR, "drake": Severity.ERROR, "kdl": Severity.INFO}
    weighed = rule(of_links(lambda name, at: Finding(at, name)), by_target=by_target)
    verdict = judged(weighed, one=context(targets=Targets(targets)))
    assert {(d.severity, d.targets) for d in verdict.diagnostics} == {(severity, affected)}
    assert verdict.targets == Targets(targets)


def test_a_finding_may_have_a_severity_of_its_own(judged) -> None:
    def find(one: Context) -> Iterator[Finding]:
        for link in one.model.links:
            mild = Severity.INFO if link.name in ("base", "rear_left") else None
            yield Finding(link.at, link.name, weight=float(mild is not None), severity=mild)

    weighed = rule(find, by_target={"mujoco": Severity.ERROR})
    base, wheel = judged(weighed, one=context(targets=Targets(("mujoco",)))).diagnostics
    assert (base.severity, base.targets) == (Severity.INFO, ())
    # The calls of one macro are one finding, as bad as the worst of them.
    assert (wheel.severity, wheel.targets) == (Severity.ERROR, ("mujoco",))
    assert wheel.message == "front_left"
    assert wheel.calls[-1].message == "rear_left"


def test_targets_are_inferred_only_where_they_matter(judged) -> None:
    silent = rule(lambda _: iter(()), by_target={"kdl": Severity.ERROR})
    indifferent = rule(of_links(lambda name, at: Finding(at, name)))
    assert judged(silent, indifferent).targets is None


def test_a_part_that_is_not_to_be_had_skips_the_rule(judged) -> None:
    def of_pinocchio(one: Context) -> Iterator[Finding]:
        raise Unavailable("Pinocchio is not installed")

    of_all = rule(of_links(lambda name, at: Finding(at, name)), code="ABC002")
    verdict = judged(rule(of_pinocchio), of_all, one=context(b'<robot><link name="a"/></robot>'))
    assert [(skip.code, skip.path, skip.reason) for skip in verdict.skipped] == [
        ("ABC001", "r.urdf", "Pinocchio is not installed")
    ]
    assert [d.code for d in verdict.diagnostics] == ["ABC002"]
    assert verdict.ran == {"ABC002"}


def test_a_crash_hides_neither_other_rules_nor_what_was_found_before(judged) -> None:
    def half(one: Context) -> Iterator[Finding]:
        yield Finding(one.document.root, "found before")
        raise ZeroDivisionError("boom")

    whole = rule(of_links(lambda name, at: Finding(at, name)), code="ABC002")
    verdict = judged(rule(half), whole)
    ((code, path, error, traceback),) = verdict.crashed
    assert (code, path, error) == ("ABC001", "r.xacro", "ZeroDivisionError: boom")
    assert "in half" in traceback
    assert [d.message for d in verdict.diagnostics] == ["found before", "base", "front_left"]
    assert verdict.ran == {"ABC002"}


def test_a_rule_is_stopped_at_a_thousand_findings(judged) -> None:
    def endless(one: Context) -> Iterator[Finding]:
        while True:
            yield Finding(one.document.root, "again")

    assert len(judged(rule(endless)).diagnostics) == 1000


def test_ten_places_in_data_files_are_listed(judged) -> None:
    def find(one: Context) -> Iterator[Finding]:
        places = tuple(Related(Span(one.source, n, n + 1), "") for n in range(12))
        at = Location(one.document.root.span)
        yield Finding(at, "numbers", data=DataPlaces(places, None))

    (found,) = judged(rule(find)).diagnostics
    assert [note.span.start for note in found.related] == list(range(10))


def test_a_message_is_bounded_whatever_names_are_in_it() -> None:
    robot = f'<robot name="r"><link name="a"/><joint name="{"j" * 5000}" type="fixed"/></robot>'
    found = check(Source("r.urdf", robot.encode())).diagnostics
    assert max(len(one.message) for one in found) == MAX_MESSAGE + len("...")


@pytest.mark.parametrize(
    "mesh", ["package://no_such_package/a.stl", "$(find no_such_package)/a.stl"]
)
def test_packages_may_be_named_in_either_way(mesh: str) -> None:
    """Rules about packages are not passed over where only one of the two is written."""
    text = (
        f"""<link name="a"><visual><geometry><mesh filename="{mesh}"/></geometry></visual></link>"""
    )
    one = Context(Source("r.urdf", f'<robot name="r">{text}</robot>'.encode()), Resolver())
    none = Context(Source("r.urdf", b'<robot name="r"><link name="a"/></robot>'), Resolver())
    assert rule_index.applicable("package", ["PKG001"], one)
    assert not rule_index.applicable("package", ["PKG001"], none)


#: Findings that are worse for a target than otherwise.
WORSE = [
    ("INE004", "gz-harmonic", '<link name="a"/>'),
    (
        "INE005",
        "mujoco",
        """<link name="b"/><joint name="j" type="continuous"><parent link="b"/><child link="a"/>
        </joint><link name="a"><inertial><mass value="1"/>
        <inertia ixx="0" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>""",
    ),
    (
        "GEO001",
        "mujoco",
        '<link name="a"><visual><geometry><box size="0 1 1"/></geometry></visual></link>',
    ),
    ("NAM004", "isaac", '<link name="1a"/>'),
    ("NAM004", "gz-jetty", '<link name="__a__"/>'),
    (
        "JNT015",
        "drake",
        """<link name="a"/><link name="b"/><link name="c"/><joint name="j" type="fixed">
        <parent link="a"/><child link="b"/></joint><joint name="k" type="continuous">
        <parent link="a"/><child link="c"/><mimic joint="j"/></joint>""",
    ),
]


@pytest.mark.parametrize(("code", "target", "parts"), WORSE)
def test_a_finding_names_the_target_that_makes_it_worse(code: str, target: str, parts: str) -> None:
    source = Source("r.urdf", f'<robot name="r">{parts}</robot>'.encode())
    (worse,) = check(source, select=[code], targets=[target, "ros2"]).diagnostics
    (milder,) = check(source, select=[code], targets=["ros2"]).diagnostics
    assert worse.severity.rank < milder.severity.rank
    assert (worse.targets, milder.targets) == ((target,), ())
