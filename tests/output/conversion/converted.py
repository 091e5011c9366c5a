"""What the tests of every format ask of a conversion."""

from pathlib import Path

import pytest

from tests.conftest import CorpusRobot
from urdfkit import convert
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.conversion.result import Conversion


def results(made: Conversion) -> dict[str, str]:
    """What became of each part."""
    return {entry.part: f"{entry.result.value}: {entry.note}" for entry in made.entries}


def assert_whole(robot: Context, made: Conversion) -> None:
    """The proof holds, and each element and attribute but namespaces has a result."""
    assert made.proof.holds
    parts = {entry.part for entry in made.entries}
    for element in robot.document.root.walk():
        assert element.path in parts
        names = (name for name in element.attributes if not name.startswith("xmlns"))
        assert all(f"{element.path}@{name}" in parts for name in names)


def of_corpus(entry: CorpusRobot, out: Path, format: str) -> Conversion:
    """A robot in a format; the test is skipped if the robot cannot be converted."""
    try:
        made = convert(entry.read(), out, to=format)
    except UrdfkitError as error:
        pytest.skip(str(error))
    assert made.proof.holds
    return made
