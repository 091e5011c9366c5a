"""Packages and files on disk, for tests of what is found where."""

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest


def add_package(directory: Path, name: str) -> Path:
    """Make a ROS package and return its directory."""
    directory.mkdir(parents=True, exist_ok=True)
    text = f"<package>\n  <!-- <name>wrong</name> -->\n  <name> {name} </name>\n</package>\n"
    (directory / "package.xml").write_text(text, encoding="utf-8")
    return directory


def add_file(path: Path, data: bytes | str = b"") -> Path:
    """Make a file, with the directories around it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data if isinstance(data, bytes) else data.encode())
    return path


def add_files(directory: Path, files: Mapping[str, bytes] | Mapping[str, str]) -> None:
    """Make files, by their paths in a directory."""
    for name, data in files.items():
        add_file(directory / name, data)


def record_listings(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The directories that are listed from now on."""
    listed: list[str] = []
    scandir = os.scandir

    def recording(path: str) -> Any:
        listed.append(path)
        return scandir(path)

    monkeypatch.setattr(os, "scandir", recording)
    return listed


def mesh_link(*filenames: str, link: str = "arm") -> str:
    """A link with a visual for each mesh."""
    visuals = "".join(
        f'<visual><geometry><mesh filename="{name}"/></geometry></visual>\n' for name in filenames
    )
    return f'<link name="{link}">\n{visuals}</link>'
