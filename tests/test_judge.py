"""What a report says of rules that could not look."""

from __future__ import annotations

import pytest

from urdfkit import Report, Source, check, rules

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
    assert {"URD001", "TRE006", "MSH001"} <= set(by_code)
    assert not [code for code in by_code if code.startswith(("XML", "XAC", "CFG"))]


def test_a_xacro_that_does_not_expand() -> None:
    report = check(Source("r.urdf.xacro", BROKEN_XACRO))
    assert [found.code for found in report.diagnostics] == ["XAC001"]
    by_code = skipped(report)
    assert set(by_code.values()) == {"the xacro does not expand"}
    assert {"URD001", "TRE006", "XAC004"} <= set(by_code)
    assert not set(by_code) & rules.TOLD_BY_READING


def test_only_chosen_rules_are_skipped() -> None:
    report = check(Source("r.urdf", b"<robot"), select=["XML001", "TRE006"])
    assert list(skipped(report)) == ["TRE006"]
