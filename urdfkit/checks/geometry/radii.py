"""Radii of visual and collision that differ by a factor: a diameter, or a decimal point."""

from math import isclose

from urdfkit.core.spatial import Z_AXIS, rotate
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity
from urdfkit.robot.assets.visual_collision import VisualCollisionPair
from urdfkit.robot.link import Body

#: Ratio of a diameter to the double of a radius, and of the lengths of two such cylinders.
_DIAMETER_TOLERANCE, _MAX_WIDTH_RATIO = 1.05, 1.5

#: Ratios of two radii by a diameter, and by a decimal point.
_RADIUS_FACTORS = (2, 10, 100, 1000)

#: Sine of the angle up to which two axes are parallel.
_PARALLEL = 0.1


def different_radii(context: Context) -> Findings:
    for link in context.model.links:
        if len(link.visuals) != 1 or len(link.collisions) != 1:
            continue
        visual, collision = link.visuals[0], link.collisions[0]
        first, second = _radius(visual, collision), _radius(collision, visual)
        if not first or not second:
            continue
        large, small = (visual, collision) if first > second else (collision, visual)
        ratio = max(first, second) / min(first, second)
        factor = next((factor for factor in _RADIUS_FACTORS if isclose(ratio, factor)), None)
        assert large.shape is not None
        if factor and (factor == 2 or large.shape.length):  # else the whole size differs
            times = "twice" if factor == 2 else f"{factor} times"
            yield Finding(
                large.shape.at,
                f"link '{link.name}': the radius of the {large.at.tag}, {max(first, second):g} m, "
                f"is {times} that of the {small.at.tag}, {min(first, second):g} m",
                "write the radius in both" if factor == 2 else "correct the decimal point",
                related=(Related(small.at.span, f"the {small.at.tag}"),),
                severity=Severity.INFO if factor == 2 else None,
            )


def radius_of_mesh(pair: VisualCollisionPair) -> Findings:
    """A cylinder with twice the radius of the mesh that it replaces, such as a wheel."""
    if len(pair.link.collisions) != 1 or not (shape := pair.link.collisions[0].shape):
        return
    if not all(body.is_mesh for body in pair.link.visuals):
        return
    axis = rotate(pair.link.collisions[0].origin.rotation, Z_AXIS)
    if shape.kind != "cylinder" or max(map(abs, axis)) < 1 - _PARALLEL:
        return
    along = max(range(3), key=lambda index: abs(axis[index]))
    edges = zip(pair.collision.bounds.edges, pair.visual.bounds.edges, strict=True)
    ratios = [a / b if b > 0 else 0.0 for a, b in edges]
    low, high = sorted(ratios[:along] + ratios[along + 1 :])
    is_double = low > 2 / _DIAMETER_TOLERANCE and high < 2 * _DIAMETER_TOLERANCE
    if is_double and 1 / _MAX_WIDTH_RATIO < ratios[along] < _MAX_WIDTH_RATIO:
        yield Finding(
            shape.at,
            f"link '{pair.link.name}': the radius of the collision, {shape.radius:g} m, is twice "
            f"that of the visual mesh, {shape.radius and shape.radius / (low + high) * 2:.3g} m",
            "write the radius instead of the diameter",
            related=(Related(pair.link.visuals[0].at.span, "the visual"),),
            severity=Severity.INFO,
        )


def _radius(body: Body, other: Body) -> float | None:
    """The radius of a shape, if the other shape differs at most in the radius; else None."""
    first, second = body.shape, other.shape
    if first is None or second is None or body.origin != other.origin:
        return None
    return first.radius if (first.kind, first.length) == (second.kind, second.length) else None
