"""Robots with meshes, in a folder of their own, for tests of the rules about meshes."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from urdfkit import engine
from urdfkit.diagnostic import Diagnostic
from urdfkit.examples import whole_robot
from urdfkit.meshes import samples

#: A solid that nothing is wrong with.
SOUND = samples.stl(samples.box((0, 0, 0), (0.1, 0.1, 0.3)))


def mesh(name: str, role: str = "collision", more: str = "", origin: str = "") -> str:
    """A visual or a collision with a mesh."""
    geometry = f'<geometry><mesh filename="{name}"{more}/></geometry>'
    return f"<{role}>{origin}{geometry}</{role}>"


def link(*parts: str, name: str = "arm") -> str:
    return f'<link name="{name}">{"".join(parts)}</link>'


def told(
    folder: Path,
    code: str,
    robot: str,
    files: Mapping[str, bytes],
    targets: tuple[str, ...] = (),
) -> list[Diagnostic]:
    """What a rule says about the inside of a robot that lies in a folder with some files."""
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    (folder / "robot.urdf").write_text(whole_robot(robot), encoding="utf-8")
    report = engine.check(folder / "robot.urdf", select=[code], targets=targets, cache=False)
    assert report.crashed == ()
    assert report.skipped == ()
    return list(report.diagnostics)


def messages(folder: Path, code: str, robot: str, files: Mapping[str, bytes]) -> list[str]:
    """The messages of a rule, in the order of the file."""
    return [found.message for found in told(folder, code, robot, files)]
