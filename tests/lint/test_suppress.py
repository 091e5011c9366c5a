"""Ignore comments: at an element, in a macro, at a call, for a file; and those that hit nothing."""

import pytest

from urdfkit import Report, check
from urdfkit.lint import rule_index
from urdfkit.lint.config_reader import load
from urdfkit.lint.ignore_comments import ignores
from urdfkit.text.source import Source

PLAIN = """<robot name="r">
  <link name="a"/>
  <link name="b"/>
  {comment}
  <joint name="j" type="fixed">
    <parent link="a"/>
    <child link="b"/>
    <axis xyz="1 0 0"/>
  </joint>
</robot>
"""

MACRO = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="tip" params="of">
    {in_macro}
    <joint name="to_${{of}}" type="fixed">
      <parent link="base"/>
      <child link="${{of}}"/>
      <axis xyz="1 0 0"/>
    </joint>
    <link name="${{of}}"/>
  </xacro:macro>
  <link name="base"/>
  {at_first_call}
  <xacro:tip of="left"/>
  <xacro:tip of="right"/>
</robot>
"""


def run(text: str) -> Report:
    source = Source("r.xacro" if "xacro" in text else "r.urdf", text.encode())
    return check(source, select=["CFG", "JNT", "TRE"])


def codes(report: Report) -> list[str]:
    return [diagnostic.code for diagnostic in report.diagnostics]


def test_a_comment_ends_where_its_element_does():
    source = Source("r.urdf", b"<robot><!-- urdfkit: ignore[JNT] --><a/><b/></robot>")
    (comment,) = ignores(source)
    assert source.data[comment.start : comment.end] == b"<a/>"


def test_a_former_code_suppresses_and_is_noted(monkeypatch):
    monkeypatch.setattr(rule_index, "_redirects", {"TRE999": "JNT020"})
    (found,) = run(PLAIN.format(comment="<!-- urdfkit: ignore[TRE999] -->")).diagnostics
    assert (found.code, found.severity.value) == ("CFG002", "info")
    assert found.message.startswith("TRE999 is now JNT020")


PER_FILE = '[[per-file-ignores]]\nfiles = ["*"]\ncodes = ["no-limit-on-continuous"]'

#: JNT021 was an info about limits of continuous joints; JNT002 reports missing limits as well.
FORMER = """<!-- urdfkit: ignore[JNT021] --><robot name="r">
<link name="a"/><link name="b"/><link name="c"/><link name="d"/>
<joint name="j" type="revolute"><parent link="a"/><child link="b"/></joint>
<joint name="k" type="continuous"><parent link="b"/><child link="c"/>
<limit effort="1" velocity="1"/></joint>
<joint name="l" type="continuous"><parent link="b"/><child link="d"/></joint></robot>"""


def test_a_former_code_suppresses_no_error(tmp_path):
    text = FORMER.replace("<!-- urdfkit: ignore[JNT021] -->", "")
    whole = check(Source("r.urdf", text.encode()), select=["JNT002"])
    assert [d.severity.value for d in whole.diagnostics] == ["error", "info"]
    comment = check(Source("r.urdf", FORMER.encode()), select=["JNT002"])
    option = check(Source("r.urdf", text.encode()), select=["JNT"], ignore=["JNT021"])
    file = tmp_path / "urdfkit.toml"
    for setting in ('ignore = ["JNT021"]', PER_FILE):
        file.write_text(setting)
        report = check(Source("r.urdf", text.encode()), config=load(str(file)))
        assert [d.severity.value for d in report.diagnostics if d.code == "JNT002"] == ["error"]
    for report in (comment, option):
        assert [d.severity.value for d in report.diagnostics if d.code == "JNT002"] == ["error"]
    assert (comment.suppressed, option.suppressed) == (1, 1)


@pytest.mark.parametrize("word", ["JNT020", "JNT", "ignored-axis-or-limit", "TRE001, JNT020"])
def test_a_comment_suppresses_what_it_names_in_the_element_below(word):
    assert "JNT020" in codes(run(PLAIN.format(comment="")))
    report = run(PLAIN.format(comment=f"<!-- urdfkit: ignore[{word}] it is a spare -->"))
    assert codes(report) == []
    assert report.suppressed == 1


def test_a_comment_before_the_root_holds_for_the_file():
    comment = "<!-- urdfkit: ignore[JNT020] exported -->\n"
    assert codes(run(comment + PLAIN.format(comment=""))) == []


def test_a_comment_does_not_reach_beyond_its_element():
    text = PLAIN.format(comment="").replace(
        '<link name="b"/>', '<!-- urdfkit: ignore[JNT020] no -->\n  <link name="b"/>'
    )
    assert codes(run(text)) == ["CFG001", "JNT020"]


def test_in_a_macro_it_holds_for_all_calls():
    text = MACRO.format(in_macro="<!-- urdfkit: ignore[JNT020] -->", at_first_call="")
    assert codes(run(text)) == []


def test_at_a_call_it_holds_for_that_call():
    text = MACRO.format(in_macro="", at_first_call="<!-- urdfkit: ignore[JNT020] -->")
    (finding,) = run(text).diagnostics
    assert finding.code == "JNT020"
    assert [call.element for call in finding.calls] == ["joint/to_right/axis"]
    assert "to_right" in finding.message


def test_all_calls_suppressed_leave_nothing():
    text = MACRO.format(in_macro="", at_first_call="<!-- urdfkit: ignore[JNT020] -->").replace(
        '<xacro:tip of="right"/>', '<!-- urdfkit: ignore[JNT020] --><xacro:tip of="right"/>'
    )
    assert codes(run(text)) == []


def test_a_comment_that_hits_nothing_is_reported_at_its_place():
    (finding,) = [
        d
        for d in run(PLAIN.format(comment="<!-- urdfkit: ignore[TRE003] -->")).diagnostics
        if d.code.startswith("CFG")
    ]
    assert (finding.code, finding.span.line, finding.span.column) == ("CFG001", 4, 3)


def test_an_unknown_code_is_reported_with_the_nearest():
    report = run(PLAIN.format(comment="<!-- urdfkit: ignore[JNT0200] -->"))
    assert codes(report) == ["CFG002", "JNT020"]
    assert "JNT020" in report.diagnostics[0].message
    assert report.diagnostics[0].span.text == "JNT0200"


def test_a_rule_that_did_not_run_makes_no_comment_idle():
    text = PLAIN.format(comment="<!-- urdfkit: ignore[JNT020] -->")
    source = Source("r.urdf", text.encode())
    assert codes(check(source, select=["TRE", "CFG"])) == []


def test_codes_and_reason_are_read():
    source = Source("r.urdf", b"<robot><!-- urdfkit: ignore[A, B-c]  why not  --><link/></robot>")
    (comment,) = ignores(source)
    assert [code for code, _ in comment.codes] == ["A", "B-c"]
    assert [span.text for _, span in comment.codes] == ["A", "B-c"]
    assert comment.reason == "why not"
    assert source.data[comment.start : comment.end] == b"<link/>"


@pytest.mark.parametrize("data", [b"<robot><!-- urdfkit: ignore[A] --><link></robot>", b""])
def test_a_broken_file_has_no_ignores(data):
    assert ignores(Source("r.urdf", data)) == ()


def test_a_comment_that_only_names_urdfkit_suppresses_nothing() -> None:
    assert ignores(Source("r.urdf", b"<robot><!-- urdfkit was here --></robot>")) == ()
