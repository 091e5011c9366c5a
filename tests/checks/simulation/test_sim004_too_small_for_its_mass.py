"""Robots of the wrong size."""

import pytest

pytest.importorskip("mujoco")

from tests.naming import naming
from tests.simulated import simulated
from urdfkit.checks.simulation.sim004_too_small_for_its_mass import BAD


def test_a_robot_in_thousandths_of_millimetres_is_one_finding() -> None:
    """It is thrown by its effort, too, which is a consequence."""
    (found,) = simulated(BAD)
    assert found.code == "SIM004"
    assert found.message == naming("1 kg", "0.568 mm", "5.5e+09 kg/m³", "1e+06")
