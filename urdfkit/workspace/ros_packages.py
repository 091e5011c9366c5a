"""Packages that come with ROS, which a robot may use even if ROS is not installed."""

import os
from functools import cache


def comes_with_ros(name: str) -> bool:
    """True for a package of ROS or of a common stack."""
    return name in ros_packages()


@cache
def ros_packages() -> frozenset[str]:
    """The packages of ROS and of common stacks: the lines of ``ros_packages.txt``."""
    with open(f"{os.path.splitext(__file__)[0]}.txt", encoding="utf-8") as file:
        return frozenset(file.read().splitlines())
