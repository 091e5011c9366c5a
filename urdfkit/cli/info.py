"""``urdfkit info``: a summary of a robot."""

import os
import textwrap
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from urdfkit.cli import output
from urdfkit.cli.decorators import described, in_formats, limited
from urdfkit.cli.posing import posed, positions
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import one_robot, robot
from urdfkit.core.words import counted
from urdfkit.output.overview import Overview, Shapes, Structure, summarise
from urdfkit.robot.inertia import principal_moments
from urdfkit.ros.gazebo.sensors import Sensor
from urdfkit.text.source import shown

VERSION = 1

#: Most names in a list; the rest are counted.
MOST = 8

_LABEL = 12


@described("info")
@one_robot
@posed
@in_formats("text", "json")
@limited
def command(asked: dict[str, Any], form: str) -> int:
    """Show a summary of a robot on one page.

    Links, joints and degrees of freedom, mass, size and reach, meshes, sensors and plugins. Mass
    properties and size are those at one configuration: all joints at zero unless given.

    Exit codes: 0 done, 2 the file or the pose cannot be read.

    Examples:
        urdfkit info robot.urdf.xacro
        urdfkit info robot.urdf.xacro --pose ready --format json
    """
    with progress_bar("mesh files") as bar:
        context = robot(asked, bar)
        found = summarise(context, positions(context, asked))
    output.json_or_page(form, lambda: as_json(found), render(found))
    return 0


def render(found: Overview) -> Iterator[str]:
    kind = "xacro" if found.is_xacro else "URDF"
    yield f"{found.name or '(no name)'}: {kind}, {shown(found.file)}"
    targets = ", ".join(found.targets) or "not detected; select it with --target"
    yield from _entry("target", targets)
    yield ""
    yield from _structure(found.structure)
    yield ""
    where = "at the given pose" if found.pose else "all joints at zero"
    yield from _weight(found, where)
    yield from _size(found)
    yield ""
    yield from _shapes(found.shapes)
    if found.sensors or found.plugins:
        yield ""
    yield from _sensors(found.sensors)
    for filename, names in _grouped(found.plugins).items():
        yield from _entry("plugin", f"{filename or '(no file)'}: {_list(_repeated(names))}")
    if found.skipped:
        yield ""
    for reason in found.skipped:
        yield from _entry("not shown", reason)


def _structure(found: Structure) -> Iterator[str]:
    depth = f"; {counted(found.depth, 'joint')} down to {found.deepest}" if found.depth else ""
    roots = f"root {found.roots[0]}" if len(found.roots) == 1 else f"{len(found.roots)} roots"
    yield from _entry("links", f"{found.links}, {roots}{depth}")
    if len(found.roots) != 1:
        yield from _entry("roots", _list(found.roots))
    kinds = ", ".join(f"{count} {kind or 'without type'}" for kind, count in found.joints.items())
    yield from _entry("joints", f"{sum(found.joints.values())}{': ' if kinds else ''}{kinds}")
    free = f": {_list(found.free)}" if found.free else ""
    yield from _entry("freedom", f"{found.nv}{free} (nq {found.nq}, nv {found.nv})")
    followers = _grouped((leader, one) for one, leader in found.followers.items())
    for leader, names in list(followers.items())[:MOST]:
        verb = "follows" if len(names) == 1 else "follow"
        yield from _entry("mimic", f"{_list(names)} {verb} {leader}")
    if len(followers) > MOST:
        yield from _entry("", f"and {len(followers) - MOST} more are followed")
    if found.driven:
        yield from _entry("driven", f"{len(found.driven)} by controllers: {_list(found.driven)}")


def _weight(found: Overview, where: str) -> Iterator[str]:
    masses, whole = found.weight.by_link, found.weight.whole
    if not masses:
        yield from _entry("mass", "none: no link has one")
        return
    shares = [f"{name} {mass:.4g}" for name, mass in masses.items()]
    of_all = f"{len(masses)} of {counted(found.structure.links, 'link')}"
    yield from _entry("mass", f"{whole.mass:.6g} kg in {of_all}: {_list(shares)}")
    if whole.properties is None:
        yield from _entry("centre", f"not known: {whole.reason}")
        return
    _, center, tensor = whole.properties
    yield from _entry("centre", f"{_vector(center)} m in {whole.root}, {where}")
    noise = 1e-9 * max(map(abs, tensor))
    xx, xy, xz, yy, yz, zz = (f"{0.0 if abs(v) <= noise else v:.4g}" for v in tensor)
    moments, products = f"ixx {xx}, iyy {yy}, izz {zz} kg·m²", f"ixy {xy}, ixz {xz}, iyz {yz}"
    yield from _entry("inertia", f"{moments} about the centre")
    yield from _entry("", products)
    yield from _entry("", f"principal moments {_vector(principal_moments(tensor))}")


def _size(found: Overview) -> Iterator[str]:
    box, reach, left_out = found.shapes.box, found.reach, found.shapes.left_out
    if len(left_out) > found.shapes.measured:
        box = None  # too few shapes for the size of the robot
        yield from _entry("size", "not known")
    if box:
        edges = " x ".join(f"{edge:.4g}" for edge in box.edges)
        low, high = (_vector(corner, max(box.edges)) for corner in (box.low, box.high))
        yield from _entry("size", f"{edges} m, from {low} to {high}")
    if left_out:
        reasons = dict.fromkeys(left_out.values())
        names = _list(left_out)
        yield from _entry("", f"without shapes of {names}: {_list(reasons)}")
    if reach and reach.distance > 0:
        ends = f"from joint {reach.joint} to the origin of {reach.link}"
        yield from _entry("reach", f"{reach.distance:.4g} m {ends}")


def _shapes(found: Shapes) -> Iterator[str]:
    for role, kinds in (("visuals", found.visuals), ("collisions", found.collisions)):
        parts = ", ".join(f"{count} {kind}" for kind, count in kinds.items())
        triangles = (found.triangles or {}).get(role[:-1])
        more = f"; {triangles:,} triangles" if triangles else ""
        yield from _entry(role, f"{sum(kinds.values())}{': ' if parts else ''}{parts}{more}")
    if found.files:
        formats = ", ".join(f"{count} {name}" for name, count in found.files.items())
        yield from _entry("mesh files", f"{formats}; {output.size(found.size)}")
    if found.missing:
        names = _list(map(os.path.basename, found.missing))
        yield from _entry("unusable", names)


def _sensors(found: Sequence[Sensor]) -> Iterator[str]:
    """Each sensor; if there are many, the number of each type."""
    if len(found) <= MOST:
        for sensor in found:
            yield from _entry("sensor", _sensor(sensor))
        return
    kinds = _grouped((sensor.type or "without type", sensor.name) for sensor in found)
    for kind, names in kinds.items():
        yield from _entry("sensors", f"{len(names)} {kind}: {_list(_repeated(names))}")


def _grouped(pairs: Iterable[tuple[str, str]]) -> dict[str, list[str]]:
    """Names by their common key; a missing name becomes ``(no name)``."""
    groups: dict[str, list[str]] = {}
    for key, name in pairs:
        groups.setdefault(key, []).append(name or "(no name)")
    return groups


def _sensor(sensor: Sensor) -> str:
    rate = sensor.number("update_rate")
    frequency = f", {rate.value:g} Hz" if rate else ""
    where = f" on {sensor.reference}" if sensor.reference else ""
    return f"{sensor.name or '(no name)'}  {sensor.type or 'without type'}{where}{frequency}"


def _entry(label: str, text: str) -> list[str]:
    """A label, and its text wrapped in a second column."""
    return textwrap.wrap(
        text,
        max(output.width(), 40),
        initial_indent=f"{label:<{_LABEL}}",
        subsequent_indent=" " * _LABEL,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _list(names: Iterable[str]) -> str:
    every = list(names)
    more = f" and {len(every) - MOST} more" if len(every) > MOST + 1 else ""
    return ", ".join(every[:MOST] if more else every) + more


def _repeated(names: Iterable[str]) -> list[str]:
    """Distinct names, with their number if they occur several times."""
    return [f"{name} ({many}x)" if many > 1 else name for name, many in Counter(names).items()]


def _vector(values: Iterable[float], size: float = 0.0) -> str:
    """Three numbers; 0 if negligible relative to the largest of them and ``size``."""
    numbers = list(values)
    noise = 1e-6 * max(size, *map(abs, numbers))
    return " ".join(f"{0.0 if abs(value) <= noise else value:.4g}" for value in numbers)


def as_json(found: Overview) -> Mapping[str, Any]:
    """The summary for JSON; lengths in m, masses in kg."""
    structure, shapes, whole = found.structure, found.shapes, found.weight.whole
    body = whole.properties
    return {
        "version": VERSION,
        "name": found.name,
        "file": found.file,
        "xacro": found.is_xacro,
        "targets": list(found.targets),
        "pose": found.pose,
        "structure": structure._asdict(),
        "mass": {
            "total": whole.mass,
            "links": found.weight.by_link,
            "center": list(body.center) if body else None,
            "inertia": body.tensor._asdict() if body else None,
            "reason": whole.reason,
        },
        "box": {"low": shapes.box.low, "high": shapes.box.high} if shapes.box else None,
        "left_out": shapes.left_out,
        "reach": found.reach._asdict() if found.reach else None,
        "visuals": shapes.visuals,
        "collisions": shapes.collisions,
        "mesh_files": shapes.files,
        "mesh_bytes": shapes.size,
        "triangles": shapes.triangles,
        "missing": list(shapes.missing),
        "sensors": [
            {"name": sensor.name, "type": sensor.type, "on": sensor.reference}
            for sensor in found.sensors
        ],
        "plugins": [{"name": name, "filename": filename} for filename, name in found.plugins],
        "skipped": list(found.skipped),
    }
