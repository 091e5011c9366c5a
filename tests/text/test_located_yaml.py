import pytest
import yaml

from urdfkit.text.located_yaml import MAX_BYTES, MAX_LEVELS, Value, load, syntax_error
from urdfkit.text.source import Source


def texts(node: object) -> object:
    if isinstance(node, dict):
        return {key: texts(value) for key, value in node.items()}
    if isinstance(node, list):
        return [texts(value) for value in node]
    return node.text if isinstance(node, Value) else node


def test_values_know_their_places() -> None:
    source = Source("c.yaml", "# \u00e9\na: {b: [1, 'two']}\n".encode())
    node = load(source)
    assert texts(node) == {"a": {"b": ["1", "two"]}}
    assert isinstance(node, dict)
    inner = node["a"]
    assert isinstance(inner, dict)
    assert isinstance(inner["b"], list)
    one, two = inner["b"]
    assert isinstance(one, Value)
    assert isinstance(two, Value)
    assert (one.span.line, one.span.column, one.span.text) == (2, 9, "1")
    assert two.span.text == "'two'"


@pytest.mark.parametrize(
    "text",
    ["a: [", "\t- x", "[" * (MAX_LEVELS + 1) + "]" * (MAX_LEVELS + 1), "a: " + "b" * MAX_BYTES],
    ids=["unfinished", "tab", "deep", "large"],
)
def test_what_is_no_list_of_parameters_is_nothing(text: str) -> None:
    assert load(Source("c.yaml", text.encode())) is None


@pytest.mark.parametrize(
    ("text", "line", "reason"),
    [
        ("a: 1\nopen:false\nb: 2\n", 2, "no space after the colon"),
        ("a: 1\nopen\nb: 2\n", 2, "could not find expected ':'"),
    ],
)
def test_the_location_of_a_line_without_a_value(text: str, line: int, reason: str) -> None:
    error = syntax_error(Source("c.yaml", text.encode()))
    assert error is not None
    assert (error[0].line, error[1]) == (line, reason)


def test_aliases_are_not_followed() -> None:
    assert texts(load(Source("c.yaml", b"a: &x [1]\nb: *x\n"))) == {"a": ["1"], "b": None}


def test_a_key_that_comes_again_goes_on_as_in_ros_2() -> None:
    text = b"/**:\n  a: {x: 1}\n/**:\n  b: 2\n  a: {y: 3}\nc: 1\nc: 2\n"
    found = texts(load(Source("c.yaml", text)))
    assert found == {"/**": {"a": {"x": "1", "y": "3"}, "b": "2"}, "c": "2"}


@pytest.mark.parametrize(
    ("text", "value"),
    [("true", True), ("False", False), ("yes", True), ("Off", False), ("n", False), ("1", None)],
)
def test_booleans_are_those_of_ros(text: str, value: bool | None) -> None:
    """``enabled: no`` disables a layer of a costmap as well as ``enabled: false``."""
    found = load(Source("c.yaml", f"enabled: {text}\n".encode()))
    assert isinstance(found, dict)
    switch = found["enabled"]
    assert isinstance(switch, Value)
    assert switch.boolean is value


@pytest.mark.parametrize(
    ("text", "in_ros", "in_python"),
    [
        ("a: 1\t# Hz\n", None, 4),
        ("a:\t1\n", None, 2),
        ("a:\n\tb: 1\n", 3, 3),
        ("a: [1\nb: 2\n", 7, 7),
        ('a: "\t"\n', None, None),
    ],
)
def test_tabs_are_an_error_where_the_reader_has_one(
    text: str, in_ros: int | None, in_python: int | None
) -> None:
    source = Source("c.yaml", text.encode())
    for is_python, expected in ((False, in_ros), (True, in_python)):
        error = syntax_error(source, in_python=is_python)
        assert (error and error[0].start) == expected


@pytest.mark.parametrize("encoding", ["latin-1", "utf-8", "utf-16"])
def test_a_byte_that_is_no_text_is_an_error_as_in_libyaml(encoding: str) -> None:
    """Also in a comment: the node does not start."""
    data = "a: 1  # Gr\xf6\xdfe\n".encode(encoding)
    error = syntax_error(Source("c.yaml", data))
    try:
        yaml.safe_load(data)
    except yaml.YAMLError:
        assert error is not None
        assert error[0].start == 10
    else:
        assert error is None
