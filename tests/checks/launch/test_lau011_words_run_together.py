"""LAU011: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported


@pytest.mark.parametrize(
    ("pieces", "word", "help"),
    [
        ("'xacro', path", "path", "write 'xacro ' with a blank"),
        ("FindExecutable(name='xacro'), path", "path", "write 'xacro ' with a blank"),
        ("'xacro ', path, 'sim:=true'", "'sim:=true'", "write ' sim:=' with a blank before it"),
        ("'xacro ', path, ' a:=', path, 'b:=1'", "'b:=1'", "write ' b:=' with a blank before it"),
    ],
)
def test_pieces_that_become_one_word(tmp_path: Path, pieces: str, word: str, help: str) -> None:
    text = f"path = LaunchConfiguration('model')\nCommand([{pieces}])"
    (found,) = reported(tmp_path, "LAU011", "a.launch.py", text)
    assert (found.span.text, found.help) == (word, help)


@pytest.mark.parametrize(
    "command",
    [
        "['xacro ', path, ' sim:=true']",
        "['xacro', ' ', path, ' ', 'sim:=', sim]",
        "['xacro ', '/opt/xacro', '/robot.xacro']",
        "[*pieces, 'sim:=true']",
        "'xacro robot.xacro'",
        "",
    ],
)
def test_parted_or_unknown_pieces_are_calm(tmp_path: Path, command: str) -> None:
    assert reported(tmp_path, "LAU011", "a.launch.py", f"Command({command})") == []
