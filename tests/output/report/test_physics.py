"""How much a report computes."""

import pytest

from tests.massive import BALL, context, link, shape
from urdfkit.errors import Unavailable
from urdfkit.output.report.physics import collisions

BODY = shape("collision", BALL)


def test_collisions_of_very_many_pairs_are_left_to_their_command() -> None:
    robot = context("".join(link(f"l{number}", BODY) for number in range(143)))
    with pytest.raises(Unavailable, match="too many pairs of 143 links; see 'urdfkit collisions'"):
        collisions(robot)
