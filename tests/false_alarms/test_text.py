"""Texts that are no XML: what is said of them, and what mends them."""

from __future__ import annotations

import pytest

from tests.reported import fixed, reported
from urdfkit import Source, check

ROBOT = '<robot name="r">\n{}<link name="a"/>\n</robot>\n'


@pytest.mark.parametrize(
    ("comment", "mended"),
    [
        ("<!-- roslaunch --wait --screen -->", "<!-- roslaunch - -wait - -screen -->"),
        ("<!------ sensors ------>", "<!--==== sensors ====-->"),
        ("<!-- a ---->", "<!-- a ==-->"),
        ("<!-- a --->", "<!-- a -->"),
        ("<!-- a\n---\nb -->", "<!-- a\n===\nb -->"),
    ],
)
def test_hyphens_in_a_comment_are_named_and_mended(comment: str, mended: str) -> None:
    robot = ROBOT.format(comment).encode()
    (found,) = reported("XML001", robot)
    assert found.span.source.data[found.span.start :].startswith(b"-")
    assert found.fix is not None
    assert fixed("XML001", robot.decode()) == ROBOT.format(mended)
    assert check(Source("r.urdf", ROBOT.format(mended).encode()), select=["XML"]).ok


@pytest.mark.parametrize(("count", "what"), [(1, "a NUL byte is"), (7, "7 NUL bytes are")])
def test_nul_bytes_are_one_finding(count: int, what: str) -> None:
    (found,) = reported("XML001", ROBOT.format("").encode() + count * b"\0")
    assert found.message == f"{what} not allowed in XML"
    assert (found.span.line, found.span.column) == (4, 1)
    assert found.help.startswith("remove")
