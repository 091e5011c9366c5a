"""``urdfkit gazebo``: a robot after Gazebo's conversion to SDF."""

from collections.abc import Iterator
from typing import Any

from urdfkit.cli import output
from urdfkit.cli.decorators import described, in_formats, option
from urdfkit.cli.progress import working
from urdfkit.cli.robot import one_robot, robot
from urdfkit.core.words import counted
from urdfkit.lint.context import Context
from urdfkit.lint.runner import run_rules
from urdfkit.robot.tree import KinematicTree
from urdfkit.ros.gazebo.conversion import NEW, OLD, SdfConversion, SimulatedJoint, SimulatedLink
from urdfkit.ros.gazebo.rejection import CODES, Rejection, rejections
from urdfkit.text.document import Element
from urdfkit.text.source import shown
from urdfkit.text.terminal import RED, YELLOW, printable

VERSION = 1
COLORS = {r"(?<= )rejects this robot(?=:$)": RED, r"(?<=[\d-]  )dropped(?=: )": YELLOW}


@described("gazebo")
@one_robot
@in_formats("text", "json")
@option("--old", "Convert as sdformat did before 9.10.1 and 12.7.2.")
def command(inputs: dict[str, Any], format: str, old: bool) -> int:
    """Show the robot after Gazebo's conversion from URDF to SDF.

    Gazebo merges links connected by fixed joints, drops links without mass together with their
    children, and names collisions and visuals itself. Plugins and sensors see the result. If
    libsdformat rejects the robot, that is printed first.

    Exit codes: 0 done, 2 the file cannot be read.

    Examples:
        urdfkit gazebo robot.urdf.xacro
    """
    return show(robot(inputs), format, old=old)


def show(context: Context, format: str, *, old: bool) -> int:
    """Print the conversion of a robot to SDF.

    Args:
        format: ``text`` or ``json``.
        old: convert as sdformat did before 9.10.1 and 12.7.2.
    """
    conversion = SdfConversion(context.tree, OLD if old else NEW)
    with working():
        rejected = rejections(run_rules(context, sorted(CODES)).diagnostics, conversion)
    lines = (*_rejection(rejected, conversion.tree), *render(conversion))
    output.json_or_page(format, lambda: as_json(conversion, rejected), lines, COLORS)
    return 0


def _rejection(rejected: list[Rejection], tree: KinematicTree) -> Iterator[str]:
    """The reasons why Gazebo rejects the robot, and the heading of the rest."""
    for reader in dict.fromkeys(rejection.reader for rejection in rejected):
        yield f"{reader} rejects this robot:"
        yield from output.errors(
            (str(one.span), one.message, one.code) for one in rejected if one.reader == reader
        )
        yield ""
    if rejected:
        yield "Without these errors:"
    elif not tree.is_sound:
        yield from output.wrapped(f"Gazebo may load another robot: {tree.unsound}")
        yield ""


def render(conversion: SdfConversion) -> Iterator[str]:
    """The lines of the report: a table of links before and after, then joints and shapes."""
    model = conversion.model
    links = len(conversion.links) + len(conversion.added_links)
    yield f"{_become(len(model.links), 'link')} {links}, by {conversion.converter.name}"
    yield ""
    rows = [("link", f"{'mass / kg':>10}  after conversion")]
    rows += ((printable(link.name), _row(conversion, link.name, link.mass)) for link in model.links)
    rows += (
        (printable(link.get("name") or ""), f"{_mass(link) or '-':>10}  added as SDF by <gazebo>")
        for link in conversion.added_links
    )
    yield from output.two_columns(rows)
    yield ""
    for link in conversion.links:
        yield from _link(link)
    lost, added = len(model.joints) - len(conversion.joints), len(conversion.added_joints)
    yield (
        f"{_become(len(model.joints), 'joint')} {len(conversion.joints) + added}"
        + (f"; {lost} {_are(lost)} merged or dropped" if lost else "")
        + (f"; {added} {_are(added)} added as SDF by <gazebo>" if added else "")
    )


def _become(count: int, thing: str) -> str:
    return f"{counted(count, thing)} become{'s' if count == 1 else ''}"


def _are(count: int) -> str:
    return "is" if count == 1 else "are"


def _mass(link: Element) -> str:
    """The declared mass of an SDF link."""
    inertial = link.child("inertial")
    mass = inertial.child("mass") if inertial else None
    return mass.text.strip() if mass else ""


def _row(conversion: SdfConversion, name: str, mass: float) -> str:
    if name in conversion.dropped:
        result = f"dropped: {conversion.dropped[name]}"
    elif name not in conversion.survivor:
        result = "not converted"
    elif conversion.survivor[name] == name:
        result = "kept"
    else:
        result = f"merged into {conversion.survivor[name]}"
    return f"{f'{mass:g}' if mass else '-':>10}  {result}"


def _link(link: SimulatedLink) -> Iterator[str]:
    mass = link.properties
    noise = 1e-9 * max(map(abs, mass.center))
    x, y, z = (f"{0.0 if abs(value) <= noise else value:.4g}" for value in mass.center)
    yield f"{link.name}: {mass.mass:g} kg, centre of mass at {x} {y} {z} m"
    tensor = mass.tensor
    yield f"  ixx {tensor.ixx:.4g}, iyy {tensor.iyy:.4g}, izz {tensor.izz:.4g} kg·m²"
    for name, _ in link.collisions:
        yield f"  collision {name}"


def as_json(conversion: SdfConversion, rejected: list[Rejection]) -> dict[str, Any]:
    return {
        "version": VERSION,
        "converter": conversion.converter.name,
        "rejected": [_rejection_as_json(rejection) for rejection in rejected],
        "links": [_link_as_json(link) for link in conversion.links],
        "joints": [_joint_as_json(joint) for joint in conversion.joints],
        "added": {
            "links": [link.get("name") for link in conversion.added_links],
            "joints": [joint.get("name") for joint in conversion.added_joints],
        },
        "merged": conversion.merged,
        "dropped": conversion.dropped,
    }


def _rejection_as_json(rejection: Rejection) -> dict[str, Any]:
    return {
        "by": rejection.reader,
        "code": rejection.code,
        "message": rejection.message,
        "file": shown(rejection.span.source.path),
        "line": rejection.span.line,
    }


def _link_as_json(link: SimulatedLink) -> dict[str, Any]:
    return {
        "name": link.name,
        "merged": list(link.body.names[1:]),
        "mass": link.properties.mass,
        "center": list(link.properties.center),
        "inertia": link.properties.tensor._asdict(),
        "collisions": [name for name, _ in link.collisions],
        "visuals": [name for name, _ in link.visuals],
    }


def _joint_as_json(joint: SimulatedJoint) -> dict[str, Any]:
    return {
        "name": joint.joint.name,
        "urdf": joint.joint.kind,
        "sdf": joint.type,
        "parent": joint.parent,
        "child": joint.child,
    }
