"""Shipped models, as words of a command line."""

from tests import conftest

ARM, GRIPPER, MISSION = map(str, (conftest.ARM, conftest.GRIPPER, conftest.MISSION))
