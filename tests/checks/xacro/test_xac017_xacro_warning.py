from __future__ import annotations

from tests.xacros import reported


def test_an_attribute_that_the_tag_does_not_know() -> None:
    body = '<xacro:property name="a" value="1" unit="m"/><link name="l${a}"/>'
    (found,) = reported("XAC017", body)
    assert found.span.text == "m"
    assert found.message == "xacro:property: unknown attribute(s): unit"


def test_an_include_without_a_match() -> None:
    (found,) = reported("XAC017", '<xacro:include filename="*.none"/><link name="a"/>')
    assert found.span.text == "*.none"
    assert found.message == 'Include tag\'s filename spec "*.none" matched no files.'


def test_the_models_own_warning() -> None:
    (found,) = reported("XAC017", "\n<link name=\"l${xacro.warning('two wheels only')}\"/>")
    assert (found.span.line, found.message) == (3, "two wheels only")


def test_a_model_may_say_something() -> None:
    assert reported("XAC017", "<link name=\"l${xacro.message('hello')}\"/>") == []


def test_nothing_to_warn_of() -> None:
    assert reported("XAC017", '<xacro:property name="a" value="1"/><link name="l${a}"/>') == []
