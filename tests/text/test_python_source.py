import ast
import warnings

import pytest

from urdfkit.text.python_source import parse


def test_what_is_no_python_is_a_syntax_error():
    with pytest.raises(SyntaxError) as caught:
        parse(b"a = 1\nb = (", "a.launch.py")
    assert (caught.value.filename, caught.value.lineno) == ("a.launch.py", 2)


@pytest.mark.parametrize("text", [b"a = '\0'", b"-" * 100_000 + b"1", b"a = '\xff'"])
def test_so_is_what_python_gives_up(text: bytes):
    with pytest.raises(SyntaxError, match=r"."):
        parse(text)


def test_the_style_of_others_is_not_warned_of():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        tree = parse(rb"pattern = '\d'")
    assert ast.unparse(tree) == r"pattern = '\\d'"
