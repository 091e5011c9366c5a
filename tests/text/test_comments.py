import pytest

from urdfkit.text.comments import blank_comments, comments, without_comments


@pytest.mark.parametrize(
    ("data", "rest"),
    [
        (b"<a/>", b"<a/>"),
        (b"<a><!-- one --></a>", b"<a></a>"),
        (b"<!-- one\n<b/> -->\n<a/><!-- two -->", b"\n<a/>"),
        (b"<a/><!-- without an end <b/>", b"<a/>"),
        (b"<!---->x<!---->", b"x"),
    ],
)
def test_comments_are_taken_out_or_blanked(data: bytes, rest: bytes) -> None:
    assert without_comments(data) == rest
    blanked = blank_comments(data)
    assert len(blanked) == len(data)
    assert blanked.replace(b" ", b"").replace(b"\n", b"") == rest.replace(b"\n", b"")
    assert all(data[found.start() :].startswith(b"<!--") for found in comments(data))


def test_comments_without_end_take_linear_time() -> None:
    assert len(comments(b"<!--" * 1_000_000)) == 1
