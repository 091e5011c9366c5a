"""Packages that come with ROS, which a robot may use even if ROS is not installed."""

import os
from functools import cache


def comes_with_ros(name: str) -> bool:
    """True for a package of ROS or of a common stack."""
    return name in _names()


@cache
def _names() -> frozenset[str]:
    """The names in ``ros_packages.txt``, a line for each; its comments are no names."""
    with open(f"{os.path.splitext(__file__)[0]}.txt", encoding="utf-8") as file:
        return frozenset(file.read().splitlines())
