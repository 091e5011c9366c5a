"""What all formats have in common."""

import inspect
from importlib import import_module

import pytest

from tests.output.formats.made import diagnostic, report, span
from urdfkit.output import formats
from urdfkit.text.source import Source

FOUND = diagnostic(span(Source("robot.urdf", b"<robot/>"), "robot"), code="TRE003")


def test_the_directory_is_the_catalogue() -> None:
    assert formats.names() == sorted(formats.names())
    assert {"json", "statistics", "text"} <= set(formats.names())


def test_an_unknown_format_is_a_key_error() -> None:
    for name in ("yaml", "_paths", "__init__", ""):
        with pytest.raises(KeyError):
            formats.get(name)


@pytest.mark.parametrize("name", formats.names())
def test_every_format_obeys_the_law(name: str) -> None:
    module = import_module(f"urdfkit.output.formats.{name}")
    written = module.stream if hasattr(module, "stream") else module.render
    signature = str(inspect.signature(written)).replace("'", "").replace("urdfkit.lint.report.", "")
    assert signature.startswith("(report: Report, *, color: bool = False, width: int = 80) -> ")
    render = formats.get(name)
    for checked in (report(rules=("TRE003",)), report(FOUND, rules=("TRE003",))):
        text = render(checked)
        assert text == "" or (text.endswith("\n") and not text.endswith("\n\n"))
        assert text == render(checked), "it depends on the report alone"
        assert "\x1b" not in text
        quiet = "".join(formats.stream(name, checked, quiet=True))
        assert (quiet == text) is not hasattr(module, "findings")
    assert written.__doc__
    assert module.__doc__


@pytest.mark.parametrize(
    "name", sorted({*formats.names()} - {"full", "json", "statistics", "text"})
)
def test_a_format_without_a_place_for_variants_has_them_in_the_message(name: str) -> None:
    found = FOUND._replace(variants=("left", "right"))
    assert "over 1 m (variants: left, right)" in formats.get(name)(report(found, rules=("TRE003",)))
