"""What is known of ``<mujoco>`` is what MuJoCo reads."""

from collections.abc import Iterator

import pytest

from tests.reported import fixed, messages
from urdfkit.text.schema import Grammar
from urdfkit.text.urdf_extensions import grammar_of


def words_of(grammar: Grammar, place: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], str]]:
    """The attributes below an element that take words: the tags to them, and the words."""
    for name, rule in grammar.attributes.items():
        if "|" in rule.type:
            yield (*place, name), rule.type
    for tag, child in grammar.children.items():
        yield from words_of(child, (*place, tag))


def found() -> list[tuple[tuple[str, ...], str]]:
    grammar = grammar_of("robot", "mujoco")
    assert grammar is not None
    return list(words_of(grammar, ()))


def robot(place: tuple[str, ...], value: str) -> str:
    """A robot with one attribute in ``<mujoco>``."""
    *tags, name = place
    text = f'<{tags[-1]} {name}="{value}"/>'
    for tag in reversed(tags[:-1]):
        text = f"<{tag}>{text}</{tag}>"
    return f'<robot name="r"><mujoco>{text}</mujoco><link name="a"/></robot>'


def refusal(robot: str) -> str:
    """What MuJoCo says against a robot; empty if it takes it."""
    mujoco = pytest.importorskip("mujoco")
    try:
        mujoco.MjModel.from_xml_string(robot)
    except ValueError as error:
        return str(error)
    return ""


WORDS = found()


@pytest.mark.parametrize(("place", "words"), WORDS, ids=["/".join(place) for place, _ in WORDS])
def test_mujoco_knows_these_words(place: tuple[str, ...], words: str) -> None:
    # Some words want another setting next to them.
    assert [word for word in words.split("|") if "keyword" in refusal(robot(place, word))] == []
    assert "invalid keyword" in refusal(robot(place, "yes"))


def compiler(value: str) -> str:
    return robot(("compiler", "strippath"), value)


def test_another_word_is_reported() -> None:
    assert messages("URD005", compiler("yes")) == [
        "<mujoco>: strippath of <compiler> is 'yes', not true or false"
    ]
    assert messages("URD005", compiler("false")) == []
    assert compiler("true") in fixed("URD005", compiler("True"))


def test_what_ros2_control_reads_is_known() -> None:
    text = '<robot name="r"><mujoco_inputs><raw_inputs/></mujoco_inputs><link name="a"/></robot>'
    assert messages("URD001", text) == []
