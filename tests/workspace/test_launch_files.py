"""The launch files that may start a robot."""

from pathlib import Path

import pytest

from tests.workspaces import add_files
from urdfkit.workspace.launch_files import launch_files
from urdfkit.workspace.resolve import Resolver

ENTRY = "def generate_launch_description(): return open('arm.urdf')\n"


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({"launch/a.launch.py": ENTRY}, True),
        ({"launch/bringup.py": ENTRY}, True),
        ({"launch/bringup.py": "arm = 1\n"}, False),  # a module that launch files import
        ({"launch/bringup.py": ENTRY, "launch/__init__.py": ""}, False),
        ({"launch/a.launch.py": ENTRY, "launch/__init__.py": ""}, True),
        ({"launch/a.launch.py": ENTRY.replace("arm", "leg")}, False),
        ({"scripts/bringup.py": ENTRY}, False),
    ],
)
def test_which_files_are_read(tmp_path: Path, files: dict[str, str], found: bool) -> None:
    add_files(tmp_path, files)
    assert bool(list(launch_files(str(tmp_path), "arm", Resolver()))) is found
