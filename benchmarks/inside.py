"""Time one job of one tool inside its process, imports and first run left out.

Usage: inside.py TOOL REPEATS FILE [NAME:=VALUE...]; prints the CPU seconds of every repeat.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable

Job = Callable[[], object]


def urdfkit(file: str, arguments: dict[str, str]) -> Job:
    """Read, expand and check."""
    from urdfkit import check

    return lambda: check(file, arguments=arguments)


def xacro(file: str, arguments: dict[str, str]) -> Job:
    """Expand, and write the result as text."""
    import xacro

    return lambda: xacro.process_file(file, mappings=dict(arguments)).toprettyxml(indent="  ")


def yourdfpy(file: str, arguments: dict[str, str]) -> Job:
    """Load without meshes."""
    from yourdfpy import URDF

    assert not arguments
    return lambda: URDF.load(
        file, build_scene_graph=False, load_meshes=False, load_collision_meshes=False
    )


def pinocchio(file: str, arguments: dict[str, str]) -> Job:
    """Build the model."""
    from pinocchio import buildModelFromUrdf

    assert not arguments
    return lambda: buildModelFromUrdf(file)


TOOLS = {job.__name__: job for job in (urdfkit, xacro, yourdfpy, pinocchio)}


def main(tool: str, repeats: str, file: str, *arguments: str) -> None:
    """Run once to warm up, then measure."""
    job = TOOLS[tool](file, dict(argument.split(":=", 1) for argument in arguments))
    job()
    for _ in range(int(repeats)):
        start = time.process_time()
        job()
        print(time.process_time() - start)


if __name__ == "__main__":
    main(*sys.argv[1:])
