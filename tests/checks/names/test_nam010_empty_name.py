from __future__ import annotations

from tests.reported import messages, places, reported


def test_links_and_joints_without_a_name() -> None:
    robot = '<link name=""/>\n<link name=" "/>\n<joint name="" type="fixed"/>'
    assert messages("NAM010", robot) == [
        "a link has an empty name",
        "a link has an empty name",
        "a joint has an empty name",
    ]
    assert places("NAM010", robot) == [(2, ""), (3, " "), (4, "")]


def test_no_name_at_all_is_another_finding() -> None:
    assert reported("NAM010", "<link/>") == []
    assert len(reported("URD003", "<link/>")) == 1
