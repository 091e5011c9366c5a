"""``urdfkit info``: a summary of a robot."""

import os
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from urdfkit.cli import output
from urdfkit.cli.decorators import described, in_formats, limited
from urdfkit.cli.posing import posed, positions
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import one_robot, robot
from urdfkit.core.grouping import by_key
from urdfkit.core.words import counted
from urdfkit.output.overview import Overview, Shapes, Structure, summarise
from urdfkit.robot.inertia import principal_moments
from urdfkit.ros.gazebo.sensors import Sensor
from urdfkit.text.source import shown

VERSION = 1

#: Most names in a list; the rest are counted.
MOST = 8

_LABEL = 12
#: A space at which `_entry` does not break the line, as between a name and its mass.
_TIE = "\u00a0"


@described("info")
@one_robot
@posed
@in_formats("text", "json")
@limited
def command(inputs: dict[str, Any], format: str) -> int:
    """Show a summary of a robot on one page.

    Links, joints and degrees of freedom, mass, size and reach, meshes, sensors and plugins. Mass
    properties and size are those at one configuration: all joints at zero unless given.

    Exit codes: 0 done, 2 the file or the pose cannot be read.

    Examples:
        urdfkit info robot.urdf.xacro
        urdfkit info robot.urdf.xacro --pose ready --format json
    """
    with progress_bar("mesh files") as bar:
        context = robot(inputs, bar)
        overview = summarise(context, positions(context, inputs))
    output.json_or_page(format, lambda: as_json(overview), render(overview))
    return 0


def render(overview: Overview) -> Iterator[str]:
    kind = "xacro" if overview.is_xacro else "URDF"
    yield f"{overview.name or '(no name)'}: {kind}, {shown(overview.file)}"
    targets = ", ".join(overview.targets) or "not detected; urdfkit check --target selects it"
    yield from _entry("target", targets)
    yield ""
    yield from _structure(overview.structure)
    yield ""
    pose = "at the given pose" if overview.pose else "all joints at zero"
    yield from _weight(overview, pose)
    yield from _size(overview)
    yield ""
    yield from _shapes(overview.shapes)
    if overview.sensors or overview.plugins:
        yield ""
    yield from _sensors(overview.sensors)
    for filename, names in _grouped(overview.plugins).items():
        yield from _entry("plugin", f"{filename or '(no file)'}: {_list(_repeated(names))}")
    if overview.skipped:
        yield ""
    for reason in overview.skipped:
        yield from _entry("not shown", reason)


def _structure(parts: Structure) -> Iterator[str]:
    depth = f"; {counted(parts.depth, 'joint')} down to {parts.deepest}" if parts.depth else ""
    roots = f"root {parts.roots[0]}" if len(parts.roots) == 1 else f"{len(parts.roots)} roots"
    yield from _entry("links", f"{parts.links}, {roots}{depth}")
    if len(parts.roots) != 1:
        yield from _entry("roots", _list(parts.roots))
    kinds = ", ".join(f"{count} {kind or 'without type'}" for kind, count in parts.joints.items())
    yield from _entry("joints", f"{sum(parts.joints.values())}{': ' if kinds else ''}{kinds}")
    free = f": {_list(parts.free)}" if parts.free else ""
    yield from _entry("freedom", f"{parts.nv}{free} (nq{_TIE}{parts.nq},{_TIE}nv{_TIE}{parts.nv})")
    followers = _grouped((leader, follower) for follower, leader in parts.followers.items())
    for leader, names in list(followers.items())[:MOST]:
        verb = "follows" if len(names) == 1 else "follow"
        yield from _entry("mimic", f"{_list(names)} {verb} {leader}")
    if len(followers) > MOST:
        yield from _entry("", f"and {len(followers) - MOST} more are followed")
    if parts.driven:
        yield from _entry("driven", f"{len(parts.driven)} by controllers: {_list(parts.driven)}")


def _weight(overview: Overview, pose: str) -> Iterator[str]:
    masses, whole = overview.weight.by_link, overview.weight.whole
    if not masses:
        yield from _entry("mass", "0 kg: no link has a mass")
        return
    shares = [f"{name}{_TIE}{mass:.4g}" for name, mass in masses.items()]
    of_all = f"{len(masses)} of {counted(overview.structure.links, 'link')}"
    yield from _entry("mass", f"{whole.mass:.6g} kg in {of_all}: {_list(shares)}")
    if whole.properties is None:
        yield from _entry("centre", f"not known: {whole.reason}")
        return
    _, center, tensor = whole.properties
    yield from _entry("centre", f"{_vector(center)} m in {whole.root}, {pose}")
    noise = 1e-9 * max(map(abs, tensor))
    xx, xy, xz, yy, yz, zz = (f"{0.0 if abs(v) <= noise else v:.4g}" for v in tensor)
    moments, products = f"ixx {xx}, iyy {yy}, izz {zz} kg·m²", f"ixy {xy}, ixz {xz}, iyz {yz}"
    yield from _entry("inertia", f"{moments} about the centre")
    yield from _entry("", products)
    yield from _entry("", f"principal moments {_vector(principal_moments(tensor))}")


def _size(overview: Overview) -> Iterator[str]:
    box, reach, left_out = overview.shapes.robot_box, overview.reach, overview.shapes.left_out
    if left_out and not box:
        yield from _entry("size", "not known")
    if box:
        edges = " x ".join(f"{edge:.4g}" for edge in box.edges)
        low, high = (_vector(corner, max(box.edges)) for corner in (box.low, box.high))
        first, last = (end.replace(" ", _TIE) for end in (f"from {low}", f"to {high}"))
        yield from _entry("size", f"{edges} m, {first} {last}")
    if left_out:
        reasons = dict.fromkeys(left_out.values())
        names = _list(left_out)
        yield from _entry("", f"without shapes of {names}: {_list(reasons)}")
    if reach and reach.distance > 0:
        ends = f"from joint {reach.joint} to the origin of {reach.link}"
        yield from _entry("reach", f"{reach.distance:.4g} m {ends}")


def _shapes(shapes: Shapes) -> Iterator[str]:
    for role, kinds in (("visuals", shapes.visuals), ("collisions", shapes.collisions)):
        parts = ", ".join(f"{count} {kind}" for kind, count in kinds.items())
        triangles = (shapes.triangles or {}).get(role[:-1])
        more = f"; {triangles:,} triangles" if triangles else ""
        yield from _entry(role, f"{sum(kinds.values())}{': ' if parts else ''}{parts}{more}")
    if shapes.files:
        formats = ", ".join(f"{count} {name}" for name, count in shapes.files.items())
        yield from _entry("mesh files", f"{formats}; {output.size(shapes.size)}")
    if shapes.missing:
        names = _list(map(os.path.basename, shapes.missing))
        yield from _entry("unusable", names)


def _sensors(sensors_: Sequence[Sensor]) -> Iterator[str]:
    """Each sensor; if there are many, the number of each type."""
    if len(sensors_) <= MOST:
        for sensor in sensors_:
            yield from _entry("sensor", _sensor(sensor))
        return
    kinds = _grouped((sensor.type or "without type", sensor.name) for sensor in sensors_)
    for kind, names in kinds.items():
        yield from _entry("sensors", f"{len(names)} {kind}: {_list(_repeated(names))}")


def _grouped(pairs: Iterable[tuple[str, str]]) -> dict[str, list[str]]:
    """Names by their common key; a missing name becomes ``(no name)``."""
    return by_key((key, name or "(no name)") for key, name in pairs)


def _sensor(sensor: Sensor) -> str:
    rate = sensor.number("update_rate")
    frequency = f", {rate.value:g} Hz" if rate else ""
    where = f" on {sensor.reference}" if sensor.reference else ""
    return f"{sensor.name or '(no name)'}  {sensor.type or 'without type'}{where}{frequency}"


def _entry(label: str, text: str) -> list[str]:
    """A label, and its text wrapped in a second column."""
    lines = output.indented(text, f"{label:<{_LABEL}}", " " * _LABEL)
    return [line.replace(_TIE, " ") for line in lines]


def _list(names: Iterable[str]) -> str:
    all_names = list(names)
    more = f" and {len(all_names) - MOST} more" if len(all_names) > MOST + 1 else ""
    return ", ".join(all_names[:MOST] if more else all_names) + more


def _repeated(names: Iterable[str]) -> list[str]:
    """Distinct names, with their number if they occur several times."""
    return [f"{name} ({count}x)" if count > 1 else name for name, count in Counter(names).items()]


def _vector(values: Iterable[float], size: float = 0.0) -> str:
    """Three numbers; 0 if negligible relative to the largest of them and ``size``."""
    numbers = list(values)
    noise = 1e-6 * max(size, *map(abs, numbers))
    return " ".join(f"{0.0 if abs(value) <= noise else value:.4g}" for value in numbers)


def as_json(overview: Overview) -> Mapping[str, Any]:
    """The summary for JSON; lengths in m, masses in kg."""
    structure, shapes, whole = overview.structure, overview.shapes, overview.weight.whole
    body = whole.properties
    return {
        "version": VERSION,
        "name": overview.name,
        "file": overview.file,
        "xacro": overview.is_xacro,
        "targets": list(overview.targets),
        "pose": overview.pose,
        "structure": structure._asdict(),
        "mass": {
            "total": whole.mass,
            "links": overview.weight.by_link,
            "center": list(body.center) if body else None,
            "inertia": body.tensor._asdict() if body else None,
            "reason": whole.reason,
        },
        "box": {"low": shapes.box.low, "high": shapes.box.high} if shapes.box else None,
        "left_out": shapes.left_out,
        "reach": overview.reach._asdict() if overview.reach else None,
        "visuals": shapes.visuals,
        "collisions": shapes.collisions,
        "mesh_files": shapes.files,
        "mesh_bytes": shapes.size,
        "triangles": shapes.triangles,
        "missing": list(shapes.missing),
        "sensors": [
            {"name": sensor.name, "type": sensor.type, "on": sensor.reference}
            for sensor in overview.sensors
        ],
        "plugins": [{"name": name, "filename": filename} for filename, name in overview.plugins],
        "skipped": list(overview.skipped),
    }
