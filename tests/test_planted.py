"""Each defect that is planted into a sound robot is found where it was planted.

The defects are listed in ``planted.txt`` and, for all that starts a robot, in
``bringup/planted.txt``, as people make them.
"""

from __future__ import annotations

import difflib
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.conftest import MODELS
from urdfkit import Diagnostic, Severity, check
from urdfkit.core.record import Record

HERE = Path(__file__).parent
CARRIERS = HERE / "carriers"

#: Of each carrier its directory and the files that are checked.
ROBOTS: dict[str, tuple[Path, tuple[str, ...]]] = {
    "rover": (CARRIERS / "rover", ("urdf/rover.urdf.xacro", "launch/simulation.launch.py")),
    "crawler": (CARRIERS / "crawler", ("urdf/crawler.xacro", "launch/gazebo.launch")),
    "picker": (CARRIERS / "picker", ("urdf/picker.urdf",)),
    "porter": (CARRIERS / "porter", (".",)),
    "arm": (CARRIERS / "arm", (".",)),
    "car": (CARRIERS / "car", (".",)),
    "drone": (CARRIERS / "drone", (".",)),
    "mobile_base": (MODELS / "good" / "mobile_base", ("urdf/mobile_base.urdf.xacro",)),
    "gripper": (MODELS / "good", ("gripper.urdf",)),
}
#: The most findings that one defect may have, followers counted.
MOST = 8


class Plant(Record):
    """A defect, and what must be said of it.

    Attributes:
        code: of the finding.
        robot: the carrier.
        file: that is edited.
        old, new: what stands there, and what is written instead.
        nth: which occurrence of ``old`` is meant, from 1.
        followers: codes of errors that it causes elsewhere.
        at: file and line where it must be told; on a changed line if empty.
    """

    code: str
    robot: str
    file: str
    old: str
    new: str
    nth: int
    followers: frozenset[str]
    at: tuple[str, str]


def plants() -> Iterator[Plant]:
    files = (HERE / "planted.txt", HERE / "bringup" / "planted.txt")
    for block in "\n\n".join(file.read_text(encoding="utf-8") for file in files).split("\n\n"):
        lines = [line for line in block.split("\n") if line and not line.startswith("#")]
        if not lines:
            continue
        code, robot, file = lines[0].split()
        reported = dict(line.split(" ", 1) for line in lines[1:] if line[0] not in "-+")
        old, new = ("\n".join(x[2:] for x in lines[1:] if x[0] == sign) for sign in "-+")
        where, _, line = reported.get("at", "").partition(": ")
        followers = frozenset(reported.get("then", "").split())
        yield Plant(
            code, robot, file, old, new, int(reported.get("nth", 1)), followers, (where, line)
        )


PLANTS = tuple(plants())


@pytest.fixture(autouse=True)
def _libraries() -> None:
    for library in ("coal", "pinocchio", "trimesh"):
        pytest.importorskip(library)


def copied(robot: str, to: Path) -> list[Path]:
    """A copy of a carrier, and the files of it that are checked."""
    directory, files = ROBOTS[robot]
    shutil.copytree(directory, to, dirs_exist_ok=True)
    return [to / file for file in files]


def planted(plant: Plant, directory: Path) -> set[tuple[str, int]]:
    """Plant a defect; files and lines where it may be reported."""
    path = directory / plant.file
    before = path.read_text(encoding="utf-8")
    start = -1
    for _ in range(plant.nth):
        start = before.index(plant.old, start + 1)
    after = before[:start] + plant.new + before[start + len(plant.old) :]
    path.write_text(after, encoding="utf-8")
    file, line = plant.at
    if file:
        lines = (directory / file).read_text(encoding="utf-8").split("\n")
        return {(file, n) for n, text in enumerate(lines, 1) if text.strip() == line}
    same = difflib.SequenceMatcher(None, before.split("\n"), after.split("\n"), autojunk=False)
    changed = (op for op in same.get_opcodes() if op[0] != "equal")
    return {(plant.file, n + 1) for _, _, _, j, k in changed for n in range(j, max(k, j + 1))}


def place(found: Diagnostic, directory: Path) -> tuple[str, int]:
    path = Path(found.span.source.path).resolve().relative_to(directory.resolve())
    return path.as_posix(), found.span.line


@pytest.mark.parametrize("robot", ROBOTS)
def test_the_carriers_are_sound(robot: str, tmp_path: Path) -> None:
    report = check(*copied(robot, tmp_path))
    assert (report.diagnostics, report.crashed, report.skipped) == ((), (), ())


@pytest.mark.parametrize("plant", PLANTS, ids=lambda plant: f"{plant.code}-{plant.robot}")
def test_it_is_found_where_it_was_planted(plant: Plant, tmp_path: Path) -> None:
    files = copied(plant.robot, tmp_path)
    places = planted(plant, tmp_path)
    report = check(*files)
    reported = [(found.code, place(found, tmp_path)) for found in report.diagnostics]
    assert report.crashed == ()
    assert any(code == plant.code and at in places for code, at in reported), reported
    elsewhere = {
        found.code
        for found in report.diagnostics
        if found.severity is Severity.ERROR and place(found, tmp_path) not in places
    }
    assert elsewhere - {plant.code} <= plant.followers, reported
    assert len(reported) <= MOST, reported
