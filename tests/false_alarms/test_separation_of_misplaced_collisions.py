"""RCT014 takes no separation from a collision that is far from its wheel: GEO004 speaks of it."""

from pathlib import Path

import pytest

from tests.checks.drives.test_rct014_wrong_wheel_dimensions import drive, reported, robot


@pytest.mark.parametrize(("shift", "count"), [(0.03, 1), (0.19, 1), (0.21, 0)])
def test_a_diffbot_from_solidworks(tmp_path: Path, shift: float, count: int) -> None:
    """Its collisions are 0.15 m beside wheels of 0.033 m: "write 0.4402" for a right 0.17."""
    assert len(reported(tmp_path, drive(0.8 + shift, 0.1), robot(shift=shift))) == count
