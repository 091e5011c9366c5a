"""Texts that are no XML yet."""

import random

import pytest

from tests.conftest import MISSION
from urdfkit.lsp.markup import MAX_DEPTH, Cursor, Markup, cursor
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml


def at(text: str) -> Cursor:
    before, _, after = text.partition("|")
    markup = Markup(Source("r.urdf", (before + after).encode()))
    return cursor(markup, len(before.encode()))


@pytest.mark.parametrize(
    ("text", "place", "node", "attribute"),
    [
        ("<robot><|", "tag", "", None),
        ("<robot><li|", "tag", "li", None),
        ("<robot><li|nk/></robot>", "tag", "link", None),
        ("<robot></ro|bot>", "end", "robot", None),
        ("<robot></|", "end", "robot", None),
        ("<robot>|</robot>", "text", "robot", None),
        ("<robot>|", "text", "robot", None),
        ("<robot/>|", "nowhere", None, None),
        ("|<robot/>", "nowhere", None, None),
        ("<link |/>", "attribute", "link", None),
        ("<link |", "attribute", "link", None),
        ("<link na|", "attribute", "link", "na"),
        ("<link na|me='a'/>", "attribute", "link", "name"),
        ("<link name|", "attribute", "link", "name"),
        ('<link name="|', "value", "link", "name"),
        ('<link name="a|', "value", "link", "name"),
        ('<link name="|"/>', "value", "link", "name"),
        ("<link name='轮|'/>", "value", "link", "name"),
        ('<a x="1"\n  |\n <b/>', "attribute", "a", None),
        ('<a x="1|\n <b y="2"/>', "value", "a", "x"),
        ("<a><!-- <b | --></a>", "comment", None, None),
        ("<a><!-- |", "comment", None, None),
        ("<a><b>te|xt</b></a>", "text", "b", None),
        ("<a><b></c>|</a>", "text", "b", None),
        ("<a><b></a>|", "nowhere", None, None),
        ("<a><b/>|</a>", "text", "a", None),
    ],
)
def test_where_the_cursor_is(text: str, place: str, node: str | None, attribute: str | None):
    found = at(text)
    assert found.place == place
    assert (found.node.name if found.node else None) == node
    assert (found.attribute.name if found.attribute else None) == attribute


def test_a_tag_that_is_being_written_takes_nothing_in() -> None:
    markup = Markup(Source("r.urdf", b'<robot><link name="a" <joint name="b"/></robot>'))
    assert [(node.name, node.parent and node.parent.name) for node in markup.nodes] == [
        ("robot", None),
        ("link", "robot"),
        ("joint", "robot"),
    ]


def test_it_agrees_with_expat_on_what_is_xml() -> None:
    """Names, nesting and places of all elements and attributes of the mission's model."""
    source = Source.read(MISSION)
    document, _ = read_xml(source)
    assert document is not None
    nodes = Markup(source).nodes
    for node, element in zip(nodes, document.root.walk(), strict=True):
        assert node.name == element.tag
        assert node.span == element.tag_at.whole_span
        assert node.tag_end == element.tag_at.inner_start
        assert (node.parent.name if node.parent else None) == (
            element.parent.tag if element.parent else None
        )
        assert {w.name: w.value_span for w in node.attributes} == dict(
            element.tag_at.attribute_spans()
        )


def test_any_damage_is_read() -> None:
    """Cut at any byte, or with bytes that are not of it: the elements stay inside of the text."""
    data = MISSION.read_bytes()
    chance = random.Random(7)
    for _ in range(150):
        start, end = sorted(chance.choices(range(len(data)), k=2))
        junk = bytes(chance.choices(b"<>/\"'=! -${}\n\x00\xff", k=chance.randrange(8)))
        damaged = data[:start][-2000:] + junk + data[end:][:2000]
        source = Source("r.xacro", damaged)
        markup = Markup(source)
        for node in markup.nodes:
            assert 0 <= node.start < node.tag_end <= node.end <= len(source.data)
        for offset in chance.choices(range(len(source.data) + 1), k=20):
            found = cursor(markup, offset)
            assert found.node is None or found.node.start <= offset <= found.node.end


@pytest.mark.parametrize(
    "text",
    [one * 20_000 for one in ("<", "<a ", "<a>", '<a b="', "<!--", "<?", "<!DOCTYPE[", "?><?")],
)
def test_hostile_texts_are_read_soon(text: str) -> None:
    markup = Markup(Source("r.urdf", text.encode()))
    assert max((node.depth for node in markup.nodes), default=0) <= MAX_DEPTH
    cursor(markup, len(text))
