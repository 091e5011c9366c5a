"""LAU034: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported


@pytest.mark.parametrize(("text", "count"), [("c = 'd' + a", 1), ("c = ['d', a]", 0)])
def test_a_text_and_a_substitution(tmp_path: Path, text: str, count: int) -> None:
    text = f"a = LaunchConfiguration('b')\n{text}\n"
    found = reported(tmp_path, "LAU034", "a.launch.py", text)
    start = "a string and a LaunchConfiguration cannot be added"
    assert [one.message.startswith(start) for one in found] == [True] * count
