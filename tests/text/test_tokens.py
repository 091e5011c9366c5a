"""The tokens of texts, well-formed or not."""

import pytest

from urdfkit.text.tokens import TokenKind, tokens


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        ("<?xml version='1.0'?>\n<a/>", "instruction text empty"),
        ('<!DOCTYPE a [<!ENTITY b "c">]><a></a >', "doctype start end"),
        ("<a><!-- <b> --><![CDATA[ </a> ]]></a>", "start comment cdata end"),
        ("<?a <b> ?><a b='>' c=\"'\">t</a>", "instruction start text end"),
        ("<a b=1 <c d='x <e", "unfinished unfinished unfinished"),
        ("<? <!DOCTYPE [ <a", "instruction instruction unfinished"),
        ("<!-- <a>", "comment"),
    ],
)
def test_kinds(text: str, kinds: str):
    found = list(tokens(text.encode()))
    assert [one.kind for one in found] == [TokenKind(kind) for kind in kinds.split()]
    assert "".join(one.text for one in found) == text


def test_attributes_that_are_being_written():
    (tag,) = tokens(b"<x:a b='1' c = \"2\" d e='")
    assert tag.name == "x:a"
    assert tag.pairs == [("b", "1"), ("c", "2"), ("d", ""), ("e", "")]
    assert [one.value is None for one in tag.attributes] == [False, False, True, False]
