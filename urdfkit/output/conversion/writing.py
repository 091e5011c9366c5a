"""A converted robot on disk, with its proof: whole or not at all."""

from __future__ import annotations

import ctypes
import glob
import json
import os
import re
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import mujoco

from urdfkit import __version__
from urdfkit.core import atomic
from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.bundle import Bundle
from urdfkit.output.bundle.consumers import CONSUMERS
from urdfkit.output.bundle.meshes import BundledFile
from urdfkit.output.bundle.robot import references
from urdfkit.output.bundle.writing import staged
from urdfkit.output.conversion.losses import Entry, Result
from urdfkit.output.conversion.mjcf import MjcfRobot
from urdfkit.output.conversion.mjcf_devices import (
    add_devices,
    exclude_disabled,
    exclude_neighbours,
)
from urdfkit.output.conversion.proof import Proof, prove
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.stability import standing
from urdfkit.text.source import shown

#: The file that lists what became of each part; a directory with it is a conversion.
REPORT = "conversion.json"
VERSION = 1
_LOST = "MJCF has nothing like it"
#: What an error of MuJoCo's compiler is about.
_ELEMENT = re.compile(r"Element name '([^']+)'.*")


class Conversion(Record):
    """What was written."""

    file: str  # of the robot, in the directory
    is_free: bool  # the root floats
    counts: dict[str, int]  # of links, joints, geoms and devices, by what one of them is called
    entries: tuple[Entry, ...]  # what became of each part of the robot
    proof: Proof  # how far MuJoCo and Pinocchio are apart

    @property
    def facts(self) -> dict[str, Any]:
        """For JSON; lengths in m, masses in kg."""
        return {
            "version": VERSION,
            "urdfkit": __version__,
            "file": self.file,
            "base": "free" if self.is_free else "fixed",
            "counts": {f"{thing}s": number for thing, number in self.counts.items()},
            "proof": {"holds": self.proof.holds, **self.proof._asdict()},
            "parts": [
                {
                    "part": one.part,
                    "file": shown(one.span.source.path),
                    "line": one.span.line,
                    "result": one.result.value,
                    "note": one.note,
                }
                for one in self.entries
            ],
        }

    def alike(self, result: Result) -> Iterator[tuple[str, list[Entry]]]:
        """The parts with a result, those with one note together, in the order of the document.

        What is in an element with the same result goes without saying.
        """
        parts: dict[str, list[Entry]] = {}
        last = ""
        for entry in self.entries:
            if entry.result is result and not (
                last and entry.part.startswith((f"{last}/", f"{last}@"))
            ):
                parts.setdefault(entry.note, []).append(entry)
                last = entry.part
        yield from parts.items()


def write(robot: Context, out: str, *, base: str, force: bool) -> Conversion:
    """Write a robot; the arguments and errors are those of `urdfkit.output.conversion.convert`."""
    is_free = floats(robot, base)
    bundle = Bundle(robot, CONSUMERS["mujoco"])
    with staged(assets(bundle), out, force=force, mark=REPORT) as directory:
        made = assembled(robot, bundle, directory, is_free=is_free)
        exclude_neighbours(made, robot)
        model = _written(made, os.path.join(directory, f"{bundle.name}.xml"), robot)
        proof = prove(model, robot)
        if not proof.holds:
            raise UrdfkitError(
                f"MuJoCo and Pinocchio do not agree on the robot: {proof.differences}"
            )
        entries = tuple(made.losses.entries(robot.document.root, _LOST))
        found = Conversion(f"{bundle.name}.xml", is_free, _counts(model), entries, proof)
        report = json.dumps(found.facts, indent=1, ensure_ascii=False)
        atomic.write(os.path.join(directory, REPORT), report.encode(), durable=False)
    return found


def floats(robot: Context, base: str) -> bool:
    """True if the root of a robot is not welded to the world; ``auto`` asks what it stands on.

    Raises:
        UrdfkitError: links and joints do not form one tree, or the world is to float.
    """
    if not robot.tree.is_sound:
        raise UrdfkitError(
            f"{robot.source.path}: links and joints do not form one tree; see urdfkit check"
        )
    if base == "free" and robot.tree.roots[0].name == "world":
        raise UrdfkitError(f"{robot.source.path}: a root link called 'world' cannot float")
    if base != "auto":
        return base == "free"
    fixed = {link.name for link, _ in rigid_bodies(robot.tree)[0].links}
    return not fixed.issuperset(standing(robot).links)


def assets(bundle: Bundle) -> Iterator[BundledFile]:
    """The meshes of a bundle, without its URDF and its manifest."""
    for file in bundle.files():
        if "/" in file.path:
            yield file


def assembled(robot: Context, bundle: Bundle, directory: str, *, is_free: bool) -> MjcfRobot:
    """The specification of a robot whose assets lie in a directory.

    Raises:
        UrdfkitError: MuJoCo rejects it, or a joint or a shape has no meaning.
    """
    files = {
        id(reference): one.new
        for reference, one in zip(references(robot.model), bundle.renamed, strict=True)
    }
    with _rejections(robot):
        made = MjcfRobot(robot.tree, files, directory, is_free=is_free)
        add_devices(made, robot)
        exclude_disabled(made, robot)
    return made


def compiled(made: MjcfRobot, robot: Context) -> Any:
    """MuJoCo's model.

    Raises:
        UrdfkitError: MuJoCo rejects it.
    """
    with _rejections(robot):
        return made.spec.compile()


def _written(made: MjcfRobot, path: str, robot: Context) -> Any:
    """The file, as MuJoCo loads it."""
    compiled(made, robot)
    _write_all_digits()
    atomic.make_directory(os.path.dirname(path))  # of a robot without files
    atomic.write(path, made.spec.to_xml().encode(), durable=False)
    with _rejections(robot):
        return mujoco.MjModel.from_xml_path(path)


@contextmanager
def _rejections(robot: Context) -> Iterator[None]:
    """Errors of MuJoCo as ours; what it warns of, as in meshes, is found by a check."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    except (ValueError, mujoco.FatalError) as error:
        raise _explained(str(error), robot) from error


def _write_all_digits() -> None:
    """Let MuJoCo write numbers as they are: it writes six digits, and has no public switch."""
    library = glob.glob(os.path.join(os.path.dirname(mujoco.__file__), "*mujoco.*"))[0]
    ctypes.CDLL(library)._mjPRIVATE__set_xml_precision(15)


def _explained(text: str, robot: Context) -> UrdfkitError:
    """An error of MuJoCo's compiler, at the link or joint that it names."""
    what = " ".join(text.split()).removeprefix("Error: ")
    named = _ELEMENT.search(what)
    name = named.group(1) if named else ""
    what = f"{what[: named.start()].strip()} ('{name}')" if named else what
    part = robot.model.links_by_name.get(name) or robot.model.joints_by_name.get(name)
    where = f"{part.at.span}: " if part else ""
    return UrdfkitError(
        f"{where}MuJoCo rejects the robot: {what}; see urdfkit check --target mujoco"
    )


def _counts(model: Any) -> dict[str, int]:
    return {
        "link": int(model.nbody) - 1,
        "joint": int(model.njnt),
        "geom": int(model.ngeom),
        "actuator": int(model.nu),
        "sensor": int(model.nsensor),
        "camera": int(model.ncam),
    }
