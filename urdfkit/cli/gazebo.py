"""``urdfkit gazebo``: what Gazebo makes of a robot."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import click

from urdfkit.cli import output
from urdfkit.cli.epilog import examples
from urdfkit.cli.robot import one_robot, robot
from urdfkit.gazebo.conversion import NEW, OLD, Conversion, SimulatedLink
from urdfkit.jsontext import dumped
from urdfkit.screen import printable

VERSION = 1


@click.command(
    "gazebo",
    epilog=examples(
        "urdfkit gazebo robot.urdf.xacro",
    ),
)
@one_robot
@click.option("--format", "form", type=click.Choice(["text", "json"]), default="text")
@click.option("--old", is_flag=True, help="As sdformat did before 9.10.1 and 12.7.2.")
def command(asked: dict[str, Any], form: str, old: bool) -> int:
    """Tell what Gazebo makes of a robot.

    Gazebo merges links that fixed joints hold together, drops links without mass together with
    what hangs on them, and names collisions and visuals itself. Plugins and sensors see the
    result.

    Exit codes: 0 done, 2 the file cannot be read.
    """
    conversion = Conversion(robot(asked).tree, OLD if old else NEW)
    if form == "json":
        output.write(dumped(as_json(conversion)))
    else:
        output.page(render(conversion))
    return 0


def render(conversion: Conversion) -> Iterator[str]:
    """The lines of the report: a table of links before and after, then joints and shapes."""
    model = conversion.model
    yield f"{len(model.links)} links become {len(conversion.links)}, by {conversion.converter.name}"
    yield ""
    rows = [("link", f"{'mass / kg':>10}  in Gazebo")]
    rows += ((printable(link.name), _row(conversion, link.name, link.mass)) for link in model.links)
    yield from output.beside(rows)
    yield ""
    for link in conversion.links:
        yield from _link(link)
    lost = len(model.joints) - len(conversion.joints)
    yield f"{len(model.joints)} joints become {len(conversion.joints)}" + (
        f"; {lost} are merged or dropped" if lost else ""
    )


def _row(conversion: Conversion, name: str, mass: float) -> str:
    if name in conversion.dropped:
        fate = f"dropped: {conversion.dropped[name]}"
    elif name not in conversion.survivor:
        fate = "not made"
    elif conversion.survivor[name] == name:
        fate = "stays"
    else:
        fate = f"merged into {conversion.survivor[name]}"
    return f"{f'{mass:g}' if mass else '-':>10}  {fate}"


def _link(link: SimulatedLink) -> Iterator[str]:
    mass = link.properties
    noise = 1e-9 * max(map(abs, mass.center))
    x, y, z = (f"{0.0 if abs(value) <= noise else value:.4g}" for value in mass.center)
    yield f"{link.name}: {mass.mass:g} kg, centre of mass at {x} {y} {z} m"
    tensor = mass.tensor
    yield f"  ixx {tensor.ixx:.4g}, iyy {tensor.iyy:.4g}, izz {tensor.izz:.4g} kg m^2"
    for name, _ in link.collisions:
        yield f"  collision {name}"


def as_json(conversion: Conversion) -> dict[str, Any]:
    """The same for programs."""
    return {
        "version": VERSION,
        "converter": conversion.converter.name,
        "links": [
            {
                "name": link.name,
                "merged": [part.name for part, _ in link.body.links[1:]],
                "mass": link.properties.mass,
                "center": list(link.properties.center),
                "inertia": link.properties.tensor._asdict(),
                "collisions": [name for name, _ in link.collisions],
                "visuals": [name for name, _ in link.visuals],
            }
            for link in conversion.links
        ],
        "joints": [
            {
                "name": joint.joint.name,
                "urdf": joint.joint.kind,
                "sdf": joint.type,
                "parent": joint.parent,
                "child": joint.child,
            }
            for joint in conversion.joints
        ],
        "merged": conversion.merged,
        "dropped": conversion.dropped,
    }
