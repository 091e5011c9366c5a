"""Legs or wheels of which one collides with another shape than all others."""

from urdfkit.lint.rules import Context, Finding, Findings, Related
from urdfkit.robot.fingers import odd_one
from urdfkit.robot.legs import legs
from urdfkit.robot.link import Body, Link
from urdfkit.robot.shapes import primitive


def odd_legs(context: Context, reported: set[str]) -> Findings:
    """The only one of several legs whose collision has another size, although all look alike."""
    links = {
        link.name: link
        for link in context.model.links
        if len(link.visuals) == len(link.collisions) == 1 and link.name not in reported
    }
    for names in legs(links):
        series = [links[name] for name in names.values()]
        if len({_looks(link.visuals[0]) for link in series}) == 1:
            yield from _odd_collision(series)


def _odd_collision(series: list[Link]) -> Findings:
    shapes = {link.name: primitive(link.collisions[0]) for link in series}
    odd = odd_one({name: str(shape) for name, shape in shapes.items()})
    if odd is None or None in shapes.values():
        return
    link = next(one for one in series if one.name == odd[0])
    other = next(one for one in series if one is not link)
    yield Finding(
        (link.collisions[0].shape or link).at,
        f"link '{link.name}': the collision is a {shapes[link.name]}, that of each of the other "
        f"{len(series) - 1} legs a {shapes[other.name]}, and all visuals are equal",
        "write the same size for all",
        related=(Related(other.collisions[0].at.span, f"link '{other.name}'"),),
    )


def _looks(body: Body) -> tuple[object, ...]:
    """What tells the shape of a visual."""
    shape = body.shape
    file = body.file.value if body.file else ""
    return (shape.kind, shape.size, shape.radius, shape.length, shape.scale, file) if shape else ()
