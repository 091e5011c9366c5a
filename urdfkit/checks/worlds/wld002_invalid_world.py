"""Gazebo cannot load the world that a launch file starts, or reads a part of it otherwise.

- The file is not well-formed, or contains no `<world>`: Gazebo starts without a world (error). gz
  sim loads a model into the world `default`.
- The `<world>` has no name, or its `<max_step_size>` is not greater than 0 (error). A value has
  another type than in SDF, such as a `<pose>` of three numbers (error), or a number has a unit
  (warning). A model, a link or a light has no name, or an unknown type (error).
- The gravity points up, or an element is misspelt or a level too high or too deep, such as
  `<static>` in a `<link>`, which Gazebo ignores (warnings). A link that moves has no positive mass,
  which SDF rejects (error), or moments of inertia that no body has (warning). A ground plane is not
  static, so that it falls with the robot (warning). Two models have the same name (warning).

Sources:
    gz-sim, Server.cc: https://github.com/gazebosim/gz-sim/blob/gz-sim8/src/Server.cc
    Gazebo, migration of SDF: https://github.com/gazebosim/gz-sim/blob/gz-sim8/tutorials/migration_sdf.md
"""

import os

from urdfkit.checks.worlds.opened_worlds import OpenedWorld, opened_worlds
from urdfkit.checks.worlds.world_values import invalid_values
from urdfkit.core.suggest import TYPO, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.values import number, numbers
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.worlds import World
from urdfkit.ros.launch.samples import WORLD_LAUNCH, world_files
from urdfkit.text.document import Element

NAME = "launch/robot.launch.py"
BAD = WORLD_LAUNCH
GOOD = BAD.replace("bad.sdf", "good.sdf")
FILES = world_files("<gravity>0 0 9.8</gravity>", "<gravity>0 0 -9.8</gravity>")

_ANYWHERE = ("frame", "plugin")
_MOMENTS = ("ixx", "iyy", "izz")
#: Part by which rounded moments may exceed the bound.
_LEAST_EXCESS = 0.01
#: Marks of templates from which a world is generated.
_TEMPLATES = (b"<%", b"{%", b"{{", b"@(", b"xmlns:xacro")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    for opened in opened_worlds(context):
        yield from opened.noted(_of_world(opened))


def _of_world(opened: OpenedWorld) -> Findings:
    world = opened.world
    if world is not None:
        yield from _values(world)
        yield from _elements(world)
        yield from invalid_values(opened, world)
        yield from _links_without_mass(world)
        yield from _impossible_inertias(world)
        yield from _falling_grounds(world)
        yield from _repeated_names(opened, world)
    elif opened.path:
        yield from _unreadable(opened)


def _unreadable(opened: OpenedWorld) -> Findings:
    source = next((problem.span.source for problem in opened.problems), None)
    file = os.path.basename(opened.path)
    error = next((problem for problem in opened.problems if problem.code == "XML001"), None)
    if source is not None and any(mark in source.data for mark in _TEMPLATES):
        return
    at = opened.started.at
    if error is not None:
        message = f"'{file}' is not a world: {error.message}"
        yield Finding(error.span, message, "fix the file")
    elif not opened.problems:
        message = f"'{file}' is not a world: it has no <world> in an <sdf>"
        yield Finding(at, message, "name a world; spawn models, or include them in a world")


def _values(world: World) -> Findings:
    """A world without a name, and an invalid time step of the physics."""
    if not world.name:
        message, help = "<world> has no name: SDF rejects it", 'write <world name="...">'
        yield Finding(world.at, message, help)
    for physics in world.at.all("physics"):
        step = physics.child("max_step_size")
        text = step.text.strip() if step is not None else ""
        value = number(text)
        if step is not None and text and (value is None or value <= 0):
            message = f"<max_step_size> is '{text}', must be a number of seconds > 0"
            yield Finding(step, message, "write 0.001")
    gravity = world.at.child("gravity")
    vector = numbers(gravity.text) if gravity is not None else None
    if gravity is not None and vector and len(vector) == 3 and vector[2] > 0:
        message = f"<gravity> points up: z is {vector[2]:g} m/s²"
        help = f"write {vector[0]:g} {vector[1]:g} {-vector[2]:g}"
        severity = Severity.WARNING
        yield Finding(gravity, message, help, severity=severity)


def _elements(world: World) -> Findings:
    """Misspelt elements, which Gazebo ignores."""
    children: dict[str, str] = data("worlds")["children"]
    for element in world.elements:
        known = children.get(element.tag, "").split()
        for child in element.children if known else ():
            meant = nearest(child.tag, known, TYPO) if child.tag not in known else None
            if meant and not element.child(meant):
                message = f"unknown element <{child.tag}> in <{element.tag}>, which Gazebo ignores"
                message += f"; did you mean <{meant}>?"
                severity = Severity.WARNING
                yield Finding(child, message, f"write <{meant}>", severity=severity)
            elif child.tag not in known and (place := _place_of(child, children)):
                message = f"<{child.tag}> in <{element.tag}> is not read, only in <{place}>"
                help = f"move it into the <{place}>"
                yield Finding(child, message, help, severity=Severity.WARNING)


def _place_of(element: Element, children: dict[str, str]) -> str:
    """Where an element belongs that is one level too deep, or not deep enough; empty if unknown.

    Plugins may stand in each element, and have elements of their own.
    """
    parent = element.parent
    above = parent.parent if parent else None
    below = children.get(parent.tag, "").split() if parent else []
    places = [above.tag] if above else []
    places += [tag for tag in below if tag not in _ANYWHERE]
    own = (tag for tag in places if element.tag in children.get(tag, "").split())
    return "" if element.tag in _ANYWHERE else next(own, "")


def _repeated_names(opened: OpenedWorld, world: World) -> Findings:
    """Models and lights of one name, of which SDF reads only one."""
    first: dict[str, Element] = {}
    for element in world.at.children:
        if element.tag not in ("light", "model"):
            continue
        name = element.get("name") or ""
        other = first.setdefault(name, element)
        if name and other is not element:
            yield Finding(
                element,
                f"{opened.title} has two elements with the name '{name}', which SDF rejects",
                "give each model and light a name of its own",
                related=(Related(other.span, "the first one"),),
                severity=Severity.WARNING,
            )


def _links_without_mass(world: World) -> Findings:
    """Links of models that move, without a positive mass."""
    for model in world.at.all("model"):
        for link in () if _is_static(model) else model.all("link"):
            inertial = link.child("inertial")
            mass = inertial.child("mass") if inertial is not None else None
            value = number(mass.text.strip()) if mass is not None else None
            if mass is not None and value is not None and value <= 0:
                message = f"<mass> is {value:g} kg, must be > 0: SDF rejects the link"
                yield Finding(mass, message, "write the mass in kg")


def _impossible_inertias(world: World) -> Findings:
    """Moments of inertia that no body has, without products of inertia."""
    for model in world.at.all("model"):
        for link in () if _is_static(model) else model.all("link"):
            inertial = link.child("inertial")
            inertia = inertial.child("inertia") if inertial is not None else None
            tags = [inertia.child(name) for name in _MOMENTS] if inertia is not None else []
            values = [number(tag.text.strip()) if tag is not None else None for tag in tags]
            moments = sorted(value for value in values if value is not None)
            if inertia is None or len(moments) < len(_MOMENTS) or _has_products(inertia):
                continue
            low, middle, high = moments
            if high > (low + middle) * (1 + _LEAST_EXCESS) > 0:
                yield Finding(
                    tags[values.index(high)] or inertia,
                    f"moments of inertia of link '{link.get('name') or ''}' violate the triangle "
                    f"inequality: {high:.4g} > {low:.4g} + {middle:.4g} kg·m²",
                    "compute them from mass and size",
                    severity=Severity.WARNING,
                )


def _has_products(inertia: Element) -> bool:
    products = (inertia.child(name) for name in ("ixy", "ixz", "iyz"))
    return any(number(tag.text.strip()) != 0 for tag in products if tag is not None)


def _falling_grounds(world: World) -> Findings:
    """A ground that is not static, and no joint holds: it falls, and the robot with it."""
    for model in () if world.is_weightless else world.at.all("model"):
        links = list(model.all("link"))
        is_held = model.child("joint") is not None or any(
            link.child("gravity") is not None for link in links
        )
        if _is_static(model) or is_held:
            continue
        collisions = (part for link in links for part in link.all("collision"))
        shapes = [shape for part in collisions for shape in part.all("geometry")]
        if any(shape.child("plane") is not None for shape in shapes):
            message = f"plane of model '{model.get('name') or ''}', which is not static, falls"
            yield Finding(
                model.child_or_self("static"),
                message,
                "write <static>true</static>",
                severity=Severity.WARNING,
            )


def _is_static(model: Element) -> bool:
    static = model.child("static")
    return static is not None and static.text.strip().lower() in ("1", "true")
