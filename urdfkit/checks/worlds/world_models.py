"""Models of a world that are repeated, without mass, or fall."""

from urdfkit.checks.worlds.opened_worlds import OpenedWorld
from urdfkit.lint.rules import Finding, Findings, Related, Severity
from urdfkit.robot.values import number
from urdfkit.ros.gazebo.worlds import World
from urdfkit.text.document import Element


def repeated_names(opened: OpenedWorld, world: World) -> Findings:
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


def links_without_mass(world: World) -> Findings:
    """Links of models that move, without a positive mass."""
    for model in world.at.all("model"):
        for link in () if _is_static(model) else model.all("link"):
            inertial = link.child("inertial")
            mass = inertial.child("mass") if inertial is not None else None
            value = number(mass.text.strip()) if mass is not None else None
            if mass is not None and value is not None and value <= 0:
                message = f"<mass> is {value:g} kg, must be > 0: SDF rejects the link"
                yield Finding(mass, message, "write the mass in kg")


def falling_grounds(world: World) -> Findings:
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
