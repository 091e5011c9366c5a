"""The matcher of other tests: what it must not let pass."""

import pytest

from tests.naming import naming, values

MESSAGE = "joint 'j': effort 4.9 N·m of <limit> in arm/a.xacro is below 1 x 2 m, as -p of a node"


def test_values_in_their_order() -> None:
    assert values(MESSAGE) == ["j", "4.9 N·m", "<limit>", "arm/a.xacro", "1 x 2 m", "-p"]
    assert naming("j", "effort", "4.9 N·m", "<limit>", "arm/a.xacro", "1 x 2 m", "-p") == MESSAGE


@pytest.mark.parametrize(
    "wrong", ["joint 'a'", "joint", "joint 'j' of 'k'", "a joint", "joint 'j' 2"]
)
def test_another_text_is_another(wrong: str) -> None:
    assert wrong != naming("j")


def test_a_short_name_is_not_found_in_words() -> None:
    assert naming("a") != "a link without a name"
    assert naming("effort", "j") != "velocity of 'j'"
