"""Names that try to leave the place where an editor shows them."""

import re
from pathlib import Path
from xml.etree import ElementTree
from xml.sax.saxutils import quoteattr

import pytest

from tests.payloads import NOT_XML, PAYLOADS, UNSAFE, named

#: What hovers show is Markdown; what stands in an editor is XML.
WRITTEN = [name for name in PAYLOADS if name not in ("controls", "CSI", "OSC 8", "OSC 52", "title")]


@pytest.mark.parametrize(
    "payload",
    [one for one in PAYLOADS.values() if "$(" not in one],  # which is no name, but not expanded
)
def test_a_completion_inserts_a_name_as_text(payload: str, tmp_path: Path) -> None:
    """Names of files, and of links that were expanded."""
    pytest.importorskip("pygls")
    from tests.lsp.edited import Edited
    from urdfkit.lsp import completion, features, outline
    from urdfkit.lsp.text import PositionEncoding

    mesh = f"{payload.replace('/', '_')}.stl"
    (tmp_path / mesh).touch()
    body = f"""<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<link name={named(payload)}/>
<link name="m"><visual><geometry><mesh filename="FILE"/></geometry></visual></link>
<joint name="j" type="fixed"><parent link="LINK"/><child link="m"/></joint></robot>"""
    places = PositionEncoding("utf-16")
    for place, name in (("FILE", mesh), ("LINK", payload)):
        edited = Edited(tmp_path / "r.urdf.xacro", body.replace(place, "|"))
        markup, offset = edited.markup, edited.offset
        offers = completion.complete(edited.robot, markup, offset)
        (offer,) = [one for one in offers if one.text == name]
        item = features._item(places, markup.source, offset, offer, snippets=True)
        assert item.text_edit is not None
        assert not UNSAFE.search(item.label)
        data, inserted = markup.source.data, item.text_edit.new_text
        text = data[: offer.start].decode() + inserted + data[offset:].decode()
        if not NOT_XML.search(payload):
            elements = list(ElementTree.fromstring(text).iter())
            assert len(elements) == 9
            assert name in [value for one in elements for value in one.attrib.values()]
        for entry in outline.outline(edited.robot, markup):
            assert not UNSAFE.search(features._symbol(places, entry).name)


@pytest.mark.parametrize("name", WRITTEN)
def test_a_hover_shows_names_as_they_are(name: str, tmp_path: Path) -> None:
    pytest.importorskip("pygls")
    from tests.lsp.edited import Edited
    from urdfkit.lsp.hover import hover
    from urdfkit.lsp.server import Server

    payload, image = quoteattr(PAYLOADS[name]), quoteattr(f"package://{PAYLOADS[name]}/a.png")
    text = f"""<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:property name="p" value={payload}/>
<link name={payload}/>
<link name="${{p}}2"/>
<material name="m"><texture filename={image}/></material>
<joint name={payload} type={payload}><parent link={payload}/><child link="${{p}}2"/></joint>
</robot>"""
    (tmp_path / "r.urdf.xacro").write_text(text)
    edited = Edited(tmp_path / "r.urdf.xacro", text)
    edited.workspace.check(edited.path)
    found = edited.workspace.diagnostics(edited.path)
    published = [Server().diagnostic(one) for one in found]
    assert published
    assert not [one.message for one in published if UNSAFE.search(one.message)]
    shown = {
        hover(edited.robot, edited.markup, offset, found)
        for offset in range(0, len(text.encode()), 3)
    }
    assert any("pwned" in one or "a" in one for one in shown)
    for one in shown:
        plain = re.sub(r"(`+)[^`\n]+\1|\\[!-/:-@\[-`{-~]", "", one)
        assert not re.search(r"\]\((?!https?://)|<|`|!\[|javascript:|pwned", plain), plain
        assert not UNSAFE.search(one), one
