from __future__ import annotations

from tests.reported import messages, places


def test_a_slash_at_the_beginning_of_a_link() -> None:
    robot = '<link name="/base"/>\n<link name="robot/base"/>\n<joint name="/j" type="fixed"/>'
    assert messages("NAM007", robot) == ["link '/base': tf2 refuses frames that begin with '/'"]
    assert places("NAM007", robot) == [(2, "/base")]
