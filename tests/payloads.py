"""Names that try to leave the place where they are shown, and robots that have them."""

import re

import pytest

from urdfkit.cli import main

PAYLOADS = {
    "script": "<script>pwned=1</script>",
    "image": "<img src=x onerror=pwned=1>",
    "end of script": "</script><script>pwned=1</script>",
    "end of CDATA": "]]><script>pwned=1</script>",
    "end of attribute": "\"/><script>pwned=1</script>'",
    "style": "</style></title></textarea><svg onload=pwned=1>",
    "template": "{{pwned}}{%pwned%}__proto__",
    "CSI": "\x1b[2J\x1b[31mpwned",
    "OSC 8": "\x1b]8;;http://pwned\x1b\\here\x1b]8;;\x1b\\",
    "OSC 52": "\x1b]52;c;cHduZWQ=\x07",
    "title": "\x1b]0;pwned\x07",
    "C1": "\x9b2J\x9d0;pwned\x9c",
    "newline": "a\n::error::pwned",
    "return": "a\r::error::pwned\r\n##[error]pwned",
    "controls": "\x01\x08\x08\x7f\x0b\x0c\x85pwned",
    "separators": "a\u2028::error::pwned\u2029b",
    "right to left": "\u202egpj.\u2066exe\u200f\u061cpwned",
    "invisible": "a\u200bb\ufeffc\u00ad",
    "percent": "%0A::error::pwned%0D",
    "command": "::error file=pwned,line=1::pwned",
    "formula": '=cmd|"/c calc"!A1',
    "sum": "@SUM(1+1)*cmd",
    "minus": "-2+3+cmd",
    "backticks": "`pwned` ``` ~~~",
    "pipes": "a|b||c\\|",
    "link": "](javascript:pwned=1)[x](javascript:pwned=1)",
    "picture": "![x](http://pwned/x.png)<http://pwned>",
    "heading": "# pwned\n\n---\n- x",
    "shell": "$(touch pwned);`touch pwned`",
    "Graphviz": 'a"]; b [URL="javascript:pwned"]; //\\',
    "Mermaid": 'a"]; click n0 "javascript:pwned" %% \\',
}

#: What no terminal and no log shall get, besides the end of a line.
UNSAFE = re.compile(
    r"[^\n\S ]|[\x00-\x09\x0b-\x1f\x7f-\x9f]"
    r"|[\xad\u061c\u200b-\u200f\u2028-\u202e\u2066-\u2069\ufeff]"
)
#: What a xacro can make, and XML cannot hold.
NOT_XML = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f]")
#: What GitHub and Azure take for a command in a log.
COMMAND = re.compile(r"^\s*::|##\[|##vso", re.MULTILINE)


def named(name: str) -> str:
    """An attribute's value that is a name after the expansion, whatever XML can hold."""
    text = "".join(char if char.isalnum() else f"\\u{ord(char):04x}" for char in name)
    return f"\"${{'{text}'}}\""


def output(words: list[str], capsys: pytest.CaptureFixture[str]) -> str:
    """What a command prints; nothing else may be steered either."""
    code = main(words)
    out, err = capsys.readouterr()
    assert code in (0, 1), err
    assert not UNSAFE.search(err)
    assert not COMMAND.search(err)
    return out
