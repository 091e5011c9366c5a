"""Every element is where an oracle says it is: in which file, where, and through which calls.

The oracle knows nothing of urdfkit. It writes into copies of the files, before the stock xacro
expands them, what each element shall tell about itself: an attribute with its own place and with
the value of a variable that every include and every macro call extends by its place.
"""

import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple
from xml.parsers import expat
from xml.sax.saxutils import unescape

import pytest

from tests.conftest import CORPUS, manifest, needs_corpus
from tests.xacro import models, stock
from urdfkit.text.document import Element, Tag
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import expand

PLACE = "urdfkit_location"
WAY = "urdfkit_way"

XACRO_TAGS = frozenset(
    "xacro:" + name
    for name in "arg attribute call element if include insert_block macro property unless".split()
)


class StartTag(NamedTuple):
    """A start tag, as expat sees it."""

    name: str
    attributes: dict[str, str]
    start: int
    depth: int


def start_tags(data: bytes) -> list[StartTag]:
    """All start tags of a file.

    Raises:
        ExpatError: it is not well formed.
    """
    tags: list[StartTag] = []
    depth = 0
    parser = expat.ParserCreate()

    def start(name: str, attributes: dict[str, str]) -> None:
        nonlocal depth
        tags.append(StartTag(name, attributes, parser.CurrentByteIndex, depth))
        depth += 1

    def end(_: str) -> None:
        nonlocal depth
        depth -= 1

    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.Parse(data, True)
    return tags


def scan_tag(data: bytes, start: int) -> tuple[int, dict[str, tuple[int, int]]]:
    """The end of a start tag, and where the values of its attributes stand, byte by byte."""
    values: dict[str, tuple[int, int]] = {}
    quote = opened = 0
    name = word = b""
    for at in range(start, len(data)):
        byte = data[at : at + 1]
        if quote:
            if ord(byte) == quote:
                values[name.decode()] = (opened, at)
                quote, word = 0, b""
        elif byte in (b'"', b"'"):
            quote, opened = ord(byte), at + 1
        elif byte == b">":
            return at + 1, values
        elif byte == b"=":
            name = word.split()[-1]
        else:
            word += byte
    raise ValueError("the tag does not end")


def marked(data: bytes, file: str, *, checked: bool = False) -> bytes:
    """The file whose elements tell where they come from.

    Args:
        data: of the file.
        file: its name in the places.
        checked: it is the one that is expanded, and so begins the way.
    """
    inserts: list[tuple[int, str]] = []
    for tag in start_tags(data):
        after_name = tag.start + 1 + len(tag.name.encode())
        here = f"{file}#{tag.start}"
        if tag.name in ("xacro:macro", "xacro:include"):
            inserts += _around(data, tag, here)
        elif tag.name == "xacro:call" or (
            tag.name.startswith("xacro:") and tag.name not in XACRO_TAGS
        ):
            inserts.append((after_name, f' {WAY}="${{{WAY}}}>{here}"'))
        elif tag.depth == 0:
            inserts.append((after_name, f' {PLACE}="{here}|"'))
            end, _ = scan_tag(data, tag.start)
            if checked and data[end - 2 : end] != b"/>":
                inserts.append((end, _set(WAY, "")))
        elif not tag.name.startswith("xacro:") or tag.name == "xacro:element":
            inserts.append((after_name, f' {PLACE}="{here}|${{{WAY}}}"'))
    for offset, text in sorted(inserts, reverse=True):
        data = data[:offset] + text.encode() + data[offset:]
    return data


def _around(data: bytes, tag: StartTag, here: str) -> Iterator[tuple[int, str]]:
    """What a macro's definition and an include need."""
    end, values = scan_tag(data, tag.start)
    if tag.name == "xacro:macro":
        if "params" in values:
            yield values["params"][1], f" {WAY}"
        else:
            yield tag.start + len("<xacro:macro"), f' params="{WAY}"'
        return
    if data[end - 2 : end] != b"/>":
        end = data.index(b">", data.index(b"</xacro:include", end)) + 1
    kept = f"{WAY}_{here.replace('#', '_')}"
    yield tag.start, _set(kept, f"${{{WAY}}}") + _set(WAY, f"${{{WAY}}}+{here}")
    yield end, _set(WAY, f"${{{kept}}}")


def _set(name: str, value: str) -> str:
    return f'<xacro:property name="{name}" value="{value}" lazy_eval="false"/>'


class Oracle:
    """A directory of xacro files and a copy of it in which every element tells its place."""

    def __init__(self, plain: Path, copy: Path, packages: dict[str, str]) -> None:
        self.plain = plain
        self.marked = copy
        self.packages = packages
        files = [file for file in plain.rglob("*") if file.is_file()]
        self.names = {str(file): f"f{number}" for number, file in enumerate(files)}
        for file in files:
            twin = self._copy_of(file)
            twin.parent.mkdir(parents=True, exist_ok=True)
            try:
                twin.write_bytes(marked(file.read_bytes(), self.names[str(file)]))
            except expat.ExpatError:
                shutil.copyfile(file, twin)

    def _copy_of(self, file: Path) -> Path:
        return self.marked / file.relative_to(self.plain)

    def places(self, file: Path, arguments: dict[str, str]) -> list[tuple[str, str]] | None:
        """Tag and place of all elements as the oracle tells them; None if xacro fails."""
        data = file.read_bytes()
        try:
            text = marked(data, self.names[str(file)], checked=True)
        except expat.ExpatError:
            return None
        copy = self._copy_of(file)
        as_included = copy.read_bytes()
        copy.write_bytes(text)
        packages = {
            name: str(self.marked / Path(directory).relative_to(self.plain))
            for name, directory in self.packages.items()
        }
        outcome = stock.expand(copy, arguments, packages)
        copy.write_bytes(as_included)
        if outcome.text is None:
            return None
        return [
            (tag.name, tag.attributes.pop(PLACE, "not marked"))
            for tag in start_tags(outcome.text.encode())
        ]

    def ours(self, file: Path, arguments: dict[str, str]) -> list[tuple[str, str]]:
        """The same as urdfkit tells it."""
        xacro = expand(Source.read(file), Resolver(self.packages, {}), arguments)
        assert xacro.document is not None, xacro.first_error
        return [(e.tag, self._place(e)) for e in xacro.document.root.walk()]

    def _place(self, element: Element) -> str:
        way = "".join(
            {"macro": ">", "include": "+"}[step.kind] + self._at(step.span.source, step.span.start)
            for step in element.via
        )
        return f"{self._at(element.tag_at.source, element.tag_at.start)}|{way}"

    def _at(self, source: Source, start: int) -> str:
        return f"{self.names[str(Path(source.path).resolve())]}#{start}"


def compare(oracle: Oracle, file: Path, arguments: dict[str, str]) -> list[str]:
    """The places of all elements, which were found to be the same; none if it does not expand."""
    expected = oracle.places(file, arguments)
    if expected is None:
        return []
    got = oracle.ours(file, arguments)
    mismatches = [pair for pair in zip(expected, got, strict=True) if pair[0] != pair[1]]
    assert mismatches == []
    return [place for _, place in expected]


@pytest.fixture(scope="module")
def corpus(tmp_path_factory: pytest.TempPathFactory) -> Oracle:
    """The corpus and its packages as they are installed."""
    directory = tmp_path_factory.mktemp("oracle").resolve()
    plain = directory / "plain"
    packages = stock.install(plain / "installed")
    for file in CORPUS.rglob("*"):
        if file.suffix in stock.SUFFIXES and file.is_file():
            copy = plain / "corpus" / file.relative_to(CORPUS)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, copy)
    return Oracle(plain, directory / "marked", packages)


@needs_corpus
def test_every_element_of_the_corpus_is_at_its_place(corpus: Oracle) -> None:
    """All models with their arguments, and all other files that expand without any."""
    places: list[str] = []
    done: set[Path] = set()
    for robot in manifest():
        if robot.facts["kind"] == "xacro":
            file = corpus.plain / "corpus" / robot.path.relative_to(CORPUS)
            found = compare(corpus, file, robot.arguments)
            done.add(file)
            assert bool(found) == robot.facts["expands"], file
            places += found
    assert len(places) == 21475
    assert sum(">" in place for place in places) > 12_000
    assert sum("+" in place for place in places) > 8_000
    for original in sorted(CORPUS.rglob("*.xacro")):
        file = corpus.plain / "corpus" / original.relative_to(CORPUS)
        places += compare(corpus, file, {}) if file not in done else []
    assert len(places) > 22_000


#: The mark would be a parameter that the macro does not have.
NOT_TO_BE_MARKED = {"element of a call"}


@pytest.mark.parametrize("name", sorted(models.BODIES.keys() - NOT_TO_BE_MARKED))
def test_every_element_of_a_small_model_is_at_its_place(name: str, tmp_path: Path) -> None:
    (tmp_path / "plain").mkdir()
    file = models.write(tmp_path / "plain", models.document(models.BODIES[name]))
    oracle = Oracle(tmp_path / "plain", tmp_path / "marked", {})
    expands = stock.expand(file).error is None
    assert bool(compare(oracle, file, {})) == expands


@needs_corpus
def test_every_attribute_of_the_corpus_is_at_its_place() -> None:
    """What stands at the place is, once unescaped, the value that expat gives."""
    attributes = 0
    for file in sorted(CORPUS.rglob("*")):
        if file.suffix not in (".xacro", ".urdf", ".xml") or not file.is_file():
            continue
        source = Source.read(file)
        try:
            tags = start_tags(source.data)
        except expat.ExpatError:
            continue
        for tag in tags:
            spans = Tag(source, tag.start, tag.start).attribute_spans()
            end, values = scan_tag(source.data, tag.start)
            assert {name: span[1:] for name, span in spans.items()} == values
            assert {name: _unescaped(span.text) for name, span in spans.items()} == tag.attributes
            assert Tag(source, tag.start, tag.start).span[1:] == (tag.start, end)
            attributes += len(spans)
    assert attributes > 39_000


def _unescaped(text: str) -> str:
    """An attribute's value as XML reads it."""
    return unescape(re.sub(r"\r\n|[\r\n\t]", " ", text), {"&quot;": '"', "&apos;": "'"})
