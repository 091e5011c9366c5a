"""What forbids a fix, by hand-made reports of a check before it and one after it."""

from types import SimpleNamespace
from typing import Any

import pytest

from tests.naming import naming
from urdfkit.lint.context import Context
from urdfkit.lint.findings import without_inconsistent_fixes
from urdfkit.lint.fix_guard import RegressionGuard, _is_used, ineffective, regression
from urdfkit.lint.report import Crashed, Report, Skipped
from urdfkit.lint.rules import Finding
from urdfkit.text.diagnostic import Call, Confidence, Diagnostic, Edit, Fix, Severity
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

SOURCE = Source("r.urdf", b"<robot/>")
ONE_LINK = '<link name="a"/>'
TWO_LINKS = '<link name="a"/><link name="b"><visual/></link>'


def found(code: str, *elements: str, source: Source = SOURCE) -> Diagnostic:
    calls = tuple(Call("", (), element) for element in elements)
    span = Span(source, 0, 1)
    confidence = Confidence.MEASURED
    return Diagnostic(code, "x", Severity.ERROR, confidence, "message", span, calls, (), "", None)


def report(
    *errors: Diagnostic, skipped: tuple[str, ...] = (), crashed: tuple[str, ...] = ()
) -> Report:
    return Report(
        ("r.urdf",),
        errors,
        tuple(Skipped(code, "r.urdf", "") for code in skipped),
        tuple(Crashed(code, "r.urdf", "") for code in crashed),
        (),
        errors=(errors,),
    )


def judged(
    before: Report,
    after: Report,
    old: str | None = ONE_LINK,
    new: str | None = TWO_LINKS,
    *,
    may_reveal: bool = True,
) -> str:
    def robots(body: str | None) -> list[Context | None]:
        if body is None:
            return [None]
        source = Source("r.urdf", f'<robot name="r">{body}</robot>'.encode())
        return [Context(source, Resolver(environment={}))]

    return regression(
        before, after, lambda: robots(old), lambda: robots(new), may_reveal=may_reveal
    )


def test_a_rule_that_cannot_look_any_more_forbids_a_fix() -> None:
    lost = report(skipped=("ABC001",))
    assert judged(report(), lost) == "dropped: with it, r.urdf could not be checked any more"
    assert judged(lost, lost) == ""


def test_a_rule_that_fails_forbids_a_fix() -> None:
    failed = report(crashed=("ABC001",))
    assert judged(report(), failed) == "dropped: with it, ABC001 fails"
    assert judged(failed, failed) == ""


@pytest.mark.parametrize(
    "after",
    [
        report(found("ABC001", "link/a")),
        report(skipped=("ABC001",)),
        report(crashed=("ABC001",)),
    ],
)
def test_so_does_each_of_these_in_a_robot_that_nobody_asked_for(
    after: Report, monkeypatch: pytest.MonkeyPatch
) -> None:
    checker: Any = SimpleNamespace(
        guard_others=lambda texts, files: after if texts else report(), robots=lambda *_: [None]
    )
    guard = RegressionGuard(checker)
    monkeypatch.setattr(guard, "_others", lambda changed, known: ["other.urdf"])
    assert guard.regression({}, {"part.xacro": b""}, [], may_reveal=True) != ""


def test_an_error_of_a_rule_that_could_not_look_before_was_there() -> None:
    after = report(found("ABC001", "link/a"))
    assert judged(report(), after) == naming("skipped", "ABC001")
    assert judged(report(skipped=("ABC001",)), after) == ""


@pytest.mark.parametrize(
    ("elements", "is_revealed"),
    [
        (["link/b"], True),
        (["link/b@name"], True),
        (["link/b/visual"], True),
        (["link/a"], False),
        (["link/b", "link/a"], False),
        ([], False),
    ],
)
def test_an_error_of_elements_that_were_hidden_was_there(
    elements: list[str], is_revealed: bool
) -> None:
    after = report(found("ABC001", *elements))
    assert judged(report(), after) == ("" if is_revealed else naming("skipped", "ABC001"))


def test_in_a_robot_that_worked_nothing_may_come_to_light() -> None:
    after = report(found("ABC001", "link/b"))
    assert judged(report(), after, may_reveal=False) == naming("skipped", "ABC001")


def test_an_element_with_another_name_was_not_hidden() -> None:
    after = report(found("ABC001", "link/b"))
    assert judged(report(), after, new='<link name="b"/>') == naming("skipped", "ABC001")


@pytest.mark.parametrize(("old", "new"), [(None, TWO_LINKS), (ONE_LINK, None), (None, None)])
def test_nothing_was_hidden_in_a_robot_that_cannot_be_read(
    old: str | None, new: str | None
) -> None:
    after = report(found("ABC001", "link/b"))
    assert judged(report(), after, old, new) == naming("skipped", "ABC001")


def test_only_robots_with_a_new_error_are_compared() -> None:
    """The others may hide nothing: it takes reading both versions to know."""

    def unread() -> list[Context]:
        raise AssertionError("nothing is new")

    one = report(found("ABC001", "link/a"))
    assert regression(one, one, unread, unread) == ""


PART = Source("part.xacro", b"<robot/>")


@pytest.mark.parametrize(
    ("errors", "reason"),
    [
        ([found("XML001", source=PART), found("XAC001")], ""),  # rov_example_base.xacro
        ([found("XML001"), found("XAC001")], naming("skipped", "XAC001")),  # still unread
        ([found("XML001"), found("XML001")], naming("skipped", "XML001")),
    ],
)
def test_a_file_that_is_not_well_formed_hides_what_it_includes(
    errors: list[Diagnostic], reason: str
) -> None:
    assert judged(report(found("XML001")), report(*errors)) == reason
    assert judged(report(), report(*errors)).startswith("skipped: it would add X")


def test_a_file_that_is_not_well_formed_may_be_no_robot() -> None:
    part = report(skipped=("",))
    assert judged(report(found("XML001")), part) == ""
    assert judged(report(found("XML001", source=PART)), part) != ""


def test_one_more_error_of_a_code_forbids_a_fix() -> None:
    one, two = report(found("ABC001", "link/a")), report(*[found("ABC001", "link/a")] * 2)
    assert judged(one, two) == naming("skipped", "ABC001")
    assert judged(two, one) == ""


def test_a_fix_that_leaves_its_finding_is_useless() -> None:
    one = found("ABC001", "link/a")
    assert ineffective(report(one), report(one), [one]) == "skipped: it does not remove the finding"
    assert ineffective(report(one), report(), [one]) == ""
    assert ineffective(report(one, one), report(one), [one]) == ""


@pytest.mark.parametrize(
    ("edit", "is_used"),
    [((5, 10), False), ((9, 11), True), ((19, 21), True), ((20, 25), False), ((10, 10), False)],
)
def test_an_edit_concerns_a_robot_by_the_start_tags_that_it_changes(
    edit: tuple[int, int], is_used: bool
) -> None:
    tags = {"r.urdf": [(0, 5), (10, 20), (25, 30)]}
    assert _is_used(("r.urdf", *edit, ""), tags) is is_used
    assert not _is_used(("other.urdf", *edit, ""), tags)


@pytest.mark.parametrize(("uses", "is_fixed"), [(1, True), (2, False)])
def test_every_use_of_a_text_must_ask_for_the_fix_and_other_findings_need_none(
    uses: int, is_fixed: bool
) -> None:
    source = Source("r.urdf", f'<robot name="r">{TWO_LINKS}</robot>'.encode())
    _, link, other, *_ = Context(source, Resolver(environment={})).document.root.walk()
    fix = Fix("remove it", (Edit(Span(source, *link.span[1:]), ""),))
    asks, only_tells = Finding(link, "message", fix=fix), Finding(other, "message")
    found = without_inconsistent_fixes([asks, only_tells], {link.tag_at: uses, other.tag_at: 1})
    assert found == [asks if is_fixed else asks._replace(fix=None), only_tells]
