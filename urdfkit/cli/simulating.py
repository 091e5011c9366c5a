"""Simulations of a check, with limits of time and memory."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

from urdfkit.cli import options
from urdfkit.core import limits
from urdfkit.core.installation import needing
from urdfkit.output.simulation import simulate

if TYPE_CHECKING:
    from urdfkit.lint.context import Context
    from urdfkit.physics.verdicts import Simulation

#: Default limits: seconds of one simulation, and GiB of the process.
_SECONDS, _GIB = 300.0, 8.0


def simulator(values: Mapping[str, Any]) -> Callable[[Context], Simulation]:
    """The function that simulates each robot of a check; limits the memory of this process.

    Raises:
        UsageError: the options cannot be combined, or a limit is no number.
        MissingLibrary: MuJoCo is not installed.
    """
    if values["fix"] or values["diff"]:
        raise options.UsageError("--simulate cannot be combined with --fix or --diff")
    with needing("--simulate", "simulate", mujoco=4):
        import urdfkit.output.simulation.running  # noqa: F401 - MuJoCo, before reading a robot
    seconds = _limit(values, "timeout", _SECONDS)
    limits.begin_memory(int(_limit(values, "memory", _GIB) * 2**30))
    return partial(_simulated, seconds=seconds)


def _simulated(robot: Context, seconds: float) -> Simulation:
    limits.begin_time(seconds)
    try:
        return simulate(robot)
    finally:
        limits.end_time()


def _limit(values: Mapping[str, Any], key: str, default: float) -> float:
    """The value of an option that is a positive number."""
    word = values[key]
    if word is None:
        return default
    try:
        number = float(word)
    except ValueError:
        number = 0.0
    if not 0.01 <= number <= 1e6:
        raise options.UsageError(f"--{key} {word}: write a number from 0.01")
    return number
