"""Finding packages and files without ROS."""

from __future__ import annotations

from collections.abc import Mapping

from urdfkit.errors import PackageNotFound


class Resolver:
    def __init__(self, packages: Mapping[str, str]) -> None:
        self.packages = dict(packages)

    def package(self, name: str, near: str) -> str:
        raise PackageNotFound(name, ())
