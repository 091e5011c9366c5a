"""Real robots: what a program rejects has an error about the cause, what it takes has none."""

import pytest

from tests.consumers import update
from tests.consumers.comparison import Robot, label, robots, verdict
from tests.consumers.reading import PROGRAMS, is_installed, oracle

VERDICTS = update.read()


@pytest.mark.parametrize("robot", robots(), ids=label)
@pytest.mark.parametrize("name", PROGRAMS)
def test_a_real_robot(name: str, robot: Robot) -> None:
    if not is_installed(name):
        pytest.skip(f"pip install {oracle(name).PACKAGE}")
    found = verdict(name, robot)
    if found is None:
        pytest.skip("not a whole robot")
    assert str(found) == VERDICTS[name]["robots"][label(robot)], found.refusal


@pytest.mark.parametrize("name", PROGRAMS)
def test_the_cause_of_a_refusal_is_an_error(name: str) -> None:
    said = VERDICTS[name]["robots"].values()
    assert [one for one in said if "not told" in one or one.startswith("taken; error")] == []


def test_the_page_has_the_table() -> None:
    assert update.PAGE.read_text(encoding="utf-8") == update.page(VERDICTS)
