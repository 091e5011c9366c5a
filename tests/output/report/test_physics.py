"""How much a report computes."""

from __future__ import annotations

import pytest

from tests.massive import BALL, context, link, shape
from urdfkit.output.report.physics import FEWEST, SAMPLES, WORK, samples


@pytest.mark.parametrize(
    ("links", "expected"), [(0, SAMPLES), (1, SAMPLES), (50, SAMPLES), (301, 66), (600, FEWEST)]
)
def test_more_pairs_of_links_are_sampled_less(links: int, expected: int) -> None:
    body = shape("collision", BALL)
    robot = context("".join(link(f"l{number}", body) for number in range(links)) or "<link/>")
    assert samples(robot) == expected
    assert expected * links * (links - 1) / 2 <= max(WORK, FEWEST * 600 * 599 / 2)
