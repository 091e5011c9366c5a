"""``urdfkit kinematics``: where links are, and how they move."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import degrees
from typing import Any

import click

from urdfkit.cli import output
from urdfkit.cli.posing import posed, positions
from urdfkit.cli.robot import one_robot, robot
from urdfkit.errors import UrdfkitError
from urdfkit.formats._layout import wrap
from urdfkit.jsontext import dumped
from urdfkit.mechanics.kinematics import frames, transform
from urdfkit.spatial import Frame, to_rpy
from urdfkit.subject import Subject, Unavailable

VERSION = 1


@click.command("kinematics")
@one_robot
@posed
@click.option("--transform", "ends", nargs=2, metavar="A B", help="Where link B is, seen from A.")
@click.option("--jacobian", metavar="LINK", help="How the origin of a link moves with the joints.")
@click.option("--mass-matrix", is_flag=True, help="The joint-space mass matrix.")
@click.option("--format", "form", type=click.Choice(["text", "json"]), default="text")
def command(
    words: tuple[str, ...],
    joint: tuple[str, ...],
    pose: str | None,
    ends: tuple[str, str] | None,
    jacobian: str | None,
    mass_matrix: bool,
    form: str,
    package: tuple[str, ...],
    trust: bool,
) -> int:
    """Tell where the links of a robot are, and how they move.

    Without further options all frames are listed, in that of their root. The Jacobian and the mass
    matrix have a column for each joint that can be set; they need Pinocchio.

    Exit codes: 0 done, 2 the file or the pose cannot be read, there is no such link.
    """
    subject = robot(words, package, trust)
    given = positions(subject, joint, pose)
    found: dict[str, Any] = {"version": VERSION, "pose": given}
    if not (ends or jacobian or mass_matrix):
        found["frames"] = frames(subject.tree, given)
    if ends:
        found["transform"] = transform(subject.tree, given, ends[1], ends[0])
        found["from"], found["to"] = ends
    if jacobian or mass_matrix:
        found |= _dynamics(subject, given, jacobian, mass_matrix)
    if form == "json":
        output.write(dumped(as_json(found, subject.tree.root_of)))
    else:
        output.page(render(found, subject.tree.root_of))
    return 0


def _dynamics(
    subject: Subject, given: Mapping[str, float], link: str | None, mass_matrix: bool
) -> dict[str, Any]:
    """What Pinocchio computes.

    Raises:
        UrdfkitError: it is not installed, or cannot be asked this.
    """
    try:
        dynamics = subject.dynamics
    except Unavailable as reason:
        raise UrdfkitError(str(reason)) from reason
    found: dict[str, Any] = {"columns": list(dynamics.columns)}
    if link:
        found["link"] = link
        found["jacobian"] = dynamics.jacobian(link, given).tolist()
    if mass_matrix:
        found["mass_matrix"] = dynamics.mass_matrix(given).tolist()
    return found


def render(found: Mapping[str, Any], root_of: Mapping[str, str]) -> Iterator[str]:
    """The lines for people; angles also in degrees, since nobody reads radians."""
    where = "at the given pose" if found["pose"] else "all joints at zero"
    if "frames" in found:
        yield from _frames(found["frames"], root_of, where)
    if "transform" in found:
        frame = found["transform"]
        yield f"{found['to']} in {found['from']}, {where}"
        yield f"x y z in m:                 {_numbers(frame.position)}"
        yield f"roll pitch yaw in degrees:  {_numbers(_turn(frame))}"
        yield f"roll pitch yaw in rad:      {_numbers(to_rpy(frame.rotation))}"
    if "jacobian" in found:
        head = f"Jacobian of {found['link']}, {where}: columns are {', '.join(found['columns'])}"
        yield from wrap(head, output.width(), indent=2).split("\n")
        yield from _matrix(found["jacobian"], ("vx", "vy", "vz", "wx", "wy", "wz"))
    if "mass_matrix" in found:
        yield f"mass matrix, {where}, in kg, kg m and kg m^2"
        yield from _matrix(found["mass_matrix"], found["columns"])


def _frames(found: Mapping[str, Frame], root_of: Mapping[str, str], where: str) -> Iterator[str]:
    """The frames under each root, in the frame of that root."""
    if not found:
        yield "no frames: no link is a root"
        return
    width = max(map(len, found))
    trees: dict[str, list[str]] = {}
    for name in found:
        trees.setdefault(root_of[name], []).append(name)
    for root, names in trees.items():
        yield f"frames in {root}, {where}: x y z in m, roll pitch yaw in degrees"
        for name in names:
            yield f"{name:<{width}}  {_numbers((*found[name].position, *_turn(found[name])))}"


def _matrix(rows: Sequence[Sequence[float]], names: Sequence[str]) -> Iterator[str]:
    width = max(map(len, names), default=0)
    for name, row in zip(names, rows, strict=True):
        yield f"{name:<{width}}  {_numbers(row)}"


def _turn(frame: Frame) -> list[float]:
    return [degrees(angle) for angle in to_rpy(frame.rotation)]


def _numbers(values: Iterable[float]) -> str:
    """Aligned, without the noise of rounding."""
    return " ".join(f"{0.0 if abs(value) < 1e-12 else value:>10.5g}" for value in values)


def as_json(found: Mapping[str, Any], root_of: Mapping[str, str]) -> dict[str, Any]:
    """The same for programs, in m and rad; rotations are three rows."""
    document = dict(found)
    if "frames" in found:
        document["frames"] = {
            name: {"root": root_of[name], **_frame(frame)}
            for name, frame in found["frames"].items()
        }
    if "transform" in found:
        document["transform"] = _frame(found["transform"])
    return document


def _frame(frame: Frame) -> dict[str, Any]:
    return {
        "position": list(frame.position),
        "rpy": [angle + 0.0 for angle in to_rpy(frame.rotation)],  # no negative zero
        "rotation": [list(row) for row in frame.rotation],
    }
