"""Robots with meshes, in a directory of their own, for tests of the rules about meshes."""

from collections.abc import Mapping
from pathlib import Path

from tests import reported as one_text
from tests.workspaces import add_file, add_files, mesh_link
from urdfkit.lint import engine
from urdfkit.lint.options import Options
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.mesh import samples
from urdfkit.text.diagnostic import Diagnostic, Severity

#: A solid that nothing is wrong with.
SOUND = samples.stl(samples.box((0, 0, 0), (0.1, 0.1, 0.3)))


def mesh(name: str, role: str = "collision", more: str = "", origin: str = "") -> str:
    """A visual or a collision with a mesh."""
    geometry = f'<geometry><mesh filename="{name}"{more}/></geometry>'
    return f"<{role}>{origin}{geometry}</{role}>"


def link(*parts: str, name: str = "arm") -> str:
    return f'<link name="{name}">{"".join(parts)}</link>'


def reported(
    directory: Path,
    code: str,
    robot: str,
    files: Mapping[str, bytes],
    targets: tuple[str, ...] = (),
) -> list[Diagnostic]:
    """What a rule says about the inside of a robot that lies in a directory with some files."""
    add_files(directory, files)
    (directory / "robot.urdf").write_text(whole_robot(robot), encoding="utf-8")
    options = Options(select=[code], targets=tuple(targets), cache=False)
    report = engine.check(directory / "robot.urdf", options=options)
    assert report.crashed == ()
    assert report.skipped == ()
    return list(report.diagnostics)


def messages(directory: Path, code: str, robot: str, files: Mapping[str, bytes]) -> list[str]:
    """The messages of a rule, in the order of the file."""
    return [found.message for found in reported(directory, code, robot, files)]


def reasons(directory: Path, code: str, name: str, data: bytes) -> list[tuple[str, str]]:
    """What a rule says of the file of the mesh of a link, and the help.

    It is an error, but for a file that only this checkout lacks.
    """
    add_file(directory / name, data)
    found = one_text.reported(code, mesh_link(name), str(directory / "arm.urdf"))
    assert all((one.severity is Severity.WARNING) == ("Git LFS" in one.message) for one in found)
    start = f"link 'arm': the visual mesh '{name}' "
    return [(diagnostic.message.removeprefix(start), diagnostic.help) for diagnostic in found]
