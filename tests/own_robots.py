"""The robots of the project that conversions and simulations are tried with."""

import pytest

from tests.conftest import MODELS, ROOT

CARRIERS = ROOT / "tests" / "carriers"
ROVER = CARRIERS / "rover" / "urdf" / "rover.urdf.xacro"
PICKER = CARRIERS / "picker" / "urdf" / "picker.urdf"
OWN = [ROVER, PICKER, *sorted((MODELS / "good").rglob("*.urdf"))]

own_robots = pytest.mark.parametrize("path", OWN, ids=lambda path: path.stem)
