import pytest

from tests.naming import naming
from tests.xacros import marked, reported


def test_an_attribute_that_the_tag_does_not_know() -> None:
    body = '<xacro:property name="a" value="1" unit="m"/><link name="l${a}"/>'
    (found,) = reported("XAC017", body)
    assert found.span.text == "m"
    assert found.message == "xacro:property: unknown attribute(s): unit"


def test_an_include_without_a_match() -> None:
    (found,) = reported("XAC017", '<xacro:include filename="*.none"/><link name="a"/>')
    assert found.span.text == "*.none"
    assert found.message == naming("Include", "*.none")


def test_the_models_own_warning() -> None:
    (found,) = reported("XAC017", "\n<link name=\"l${xacro.warning('two wheels only')}\"/>")
    assert (found.span.line, found.message) == (3, "two wheels only")


def test_a_model_may_say_something() -> None:
    assert reported("XAC017", "<link name=\"l${xacro.message('hello')}\"/>") == []


def test_nothing_to_warn_of() -> None:
    assert reported("XAC017", '<xacro:property name="a" value="1"/><link name="l${a}"/>') == []


@pytest.mark.parametrize(
    ("name", "value", "what"),
    [
        ("e", "0.2", "2.71828"),
        ("pi", "3", "3.14159"),
        ("len", "2", "len()"),
        ("dist", "2", "dist()"),
    ],
)
def test_a_property_that_hides_a_name(name: str, value: str, what: str) -> None:
    body = f'<xacro:property name="{name}" value="{value}"/>\n<link name="l${{{name}}}"/>'
    (found,) = reported("XAC017", body)
    assert (found.span.line, found.span.column, found.span.text) == (2, 23, name)
    assert found.message == naming(name, what)


def test_a_parameter_is_reported_once_at_the_macro() -> None:
    body = (
        '<xacro:macro name="m" params="mee e *pi">\n<link name="l${e}"/></xacro:macro>\n'
        '<xacro:m mee="1" e="1"><x/></xacro:m>\n<xacro:m mee="2" e="2"><x/></xacro:m>'
    )
    (found,) = reported("XAC017", body)
    assert (found.span.line, found.span.column, found.span.text) == (2, 35, "e")
    assert found.message == naming("e", "m", "constant e", "2.71828")


@pytest.mark.parametrize(
    ("name", "value"),
    [("pi", "3.1415926535897931"), ("pi", "3.14159265"), ("e", "2.718281828"), ("radius", "1")],
)
def test_the_constant_itself_and_other_names(name: str, value: str) -> None:
    body = f'<xacro:property name="{name}" value="{value}"/><link name="l${{{name}}}"/>'
    assert marked(reported("XAC017", body)) == []
