"""The output is that of stock xacro byte for byte, and the first error is the same."""

import re
from collections.abc import Mapping
from pathlib import Path

import pytest

from tests.conftest import CORPUS, CorpusRobot, manifest, model_id, needs_corpus
from tests.xacro import models, stock
from tests.xacro.stock import Outcome
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import expand


def ours(
    path: Path, arguments: Mapping[str, str] | None = None, packages: Mapping[str, str] = {}
) -> Outcome:
    """The outcome of urdfkit's expansion."""
    xacro = expand(Source.read(path), Resolver(packages, {}), arguments)
    warnings = tuple(m.text for m in xacro.messages if m.kind == "warning")
    text = xacro.text() if xacro.first_error is None else None
    return Outcome(text, xacro.first_error, warnings)


@pytest.fixture(scope="session")
def packages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    return stock.install(tmp_path_factory.mktemp("installed"))


#: Wanted: what stock xacro says, and what urdfkit says instead. A package that is not found is
#: not reported as a Python error; ``name`` in ur.urdf.xacro has a default that comes after its use;
#: an attribute that is no text is reported where it is set, not when the document is written.
WANTED = (
    (r"<class 'LookupError'>: (\w+) \w+", r"package '{0}' not found; searched: "),
    (r"'(\w+)' object has no attribute 'replace'", r"'x' is a {0}, which xacro cannot write"),
    (r"Undefined substitution argument name", r"\[Errno 2\] No such file .*/ur5x/visual"),
)


def is_wanted(expected: Outcome, got: Outcome) -> bool:
    if expected.error is None or got.error is None:
        return False
    for theirs, mine in WANTED:
        if match := re.fullmatch(theirs, expected.error):
            return re.match(mine.format(*match.groups()), got.error) is not None
    return False


def check(expected: Outcome, got: Outcome) -> None:
    if not is_wanted(expected, got):
        assert got.error == expected.error
        assert got.text == expected.text
        if expected.error is None:
            assert got.warnings == expected.warnings


XACROS = [entry for entry in manifest() if entry.facts["kind"] == "xacro"]


@needs_corpus
@pytest.mark.parametrize("entry", XACROS, ids=model_id)
def test_a_model_of_the_corpus(entry: CorpusRobot, packages: dict[str, str]) -> None:
    expected = stock.expand(entry.path, entry.arguments, packages)
    check(expected, ours(entry.path, entry.arguments, packages))
    assert (expected.error is None) == entry.facts["expands"]


def xacro_files() -> list[Path]:
    return sorted(CORPUS.rglob("*.xacro"))


@needs_corpus
@pytest.mark.parametrize("file", xacro_files(), ids=lambda p: str(p.relative_to(CORPUS)))
def test_a_file_of_the_corpus_without_arguments(file: Path, packages: dict[str, str]) -> None:
    check(stock.expand(file, None, packages), ours(file, None, packages))


@needs_corpus
def test_the_corpus_is_what_it_was() -> None:
    assert len(xacro_files()) == 258


@pytest.mark.parametrize("name", models.BODIES)
def test_a_small_model(name: str, tmp_path: Path) -> None:
    file = models.write(tmp_path, models.document(models.BODIES[name]))
    check(stock.expand(file), ours(file))


@pytest.mark.parametrize("name", models.WHOLE)
def test_a_whole_file(name: str, tmp_path: Path) -> None:
    file = models.write(tmp_path, models.WHOLE[name])
    check(stock.expand(file), ours(file))
