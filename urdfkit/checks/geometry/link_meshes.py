"""Links whose collision mesh differs from the visual, unlike those of the other links.

It is at another scale or place, or that of another link.
"""

import os
from collections.abc import Iterator

from urdfkit.core.spatial import length, minus
from urdfkit.core.words import rounded, spaced
from urdfkit.lint.rules import Context, Finding, Findings, Related
from urdfkit.robot.assets.visual_collision import SIMILAR_UNIT
from urdfkit.robot.link import Link, Shape
from urdfkit.robot.symmetry import pairs

#: Least number of links with one mesh at one scale next to the one at two scales.
_CONSISTENT_LINKS = 2

#: Least number of links with one origin for both meshes next to the one with two.
_EQUAL_ORIGINS = 4

#: Least distance of two origins, in m.
_LEAST_SHIFT = 1e-3


def other_scale(context: Context) -> Findings:
    """The only link that has one mesh at two scales, which are not those of two units."""
    same, other = 0, []
    for link, visual, collision in _links_with_two_meshes(context):
        if _path(visual) == _path(collision):
            if visual.scale == collision.scale:
                same += 1
            else:
                other.append((link, visual, collision))
    if len(other) != 1 or same < _CONSISTENT_LINKS:
        return
    ((link, visual, collision),) = other
    ratios = [a / b if b else 0.0 for a, b in zip(visual.scale, collision.scale, strict=True)]
    if all(1 / SIMILAR_UNIT < abs(ratio) < SIMILAR_UNIT for ratio in ratios):
        yield Finding(
            collision.at,
            f"link '{link.name}': the scale of the collision is {spaced(collision.scale)}, that of "
            f"the visual, which is the same mesh, {spaced(visual.scale)}",
            "write the same scale for both",
            related=(Related(visual.at.span, "the visual"),),
        )


def other_origin(context: Context, reported: set[str]) -> Findings:
    """The only link whose visual and collision are meshes of one name at two places."""
    same, other = 0, []
    for link, visual, collision in _links_with_two_meshes(context):
        if os.path.basename(_path(visual)) != os.path.basename(_path(collision)):
            continue
        places = [body.origin for body in (*link.visuals, *link.collisions)]
        if places[0] == places[1]:
            same += 1
        else:
            other.append((link, places))
    if len(other) != 1 or same < _EQUAL_ORIGINS or other[0][0].name in reported:
        return
    ((link, (seen, hit)),) = other
    shift = minus(hit.position, seen.position)
    if seen.rotation == hit.rotation and length(shift) >= _LEAST_SHIFT:
        yield Finding(
            link.collisions[0].at.child_or_self("origin"),
            f"link '{link.name}': the <origin> of the collision is {rounded(shift, 4)} m from that "
            f"of the visual; visual and collision of the other {same} links with such meshes have "
            "the same <origin>",
            "write the same <origin> for both",
            related=(Related(link.visuals[0].at.child_or_self("origin").span, "the visual"),),
        )


def mesh_of_another_link(context: Context, reported: set[str]) -> Findings:
    """The only link with the mesh of another link as its collision, or as its visual."""
    links = list(_links_with_two_meshes(context))
    other = [found for found in links if _path(found[1]) != _path(found[2])]
    if len(other) != 1 or len(links) <= _CONSISTENT_LINKS + 1:
        return
    ((link, visual, collision),) = other
    # A collision may be that of the other side: wheels are symmetric.
    if link.name in reported or pairs((_path(visual), _path(collision))):
        return
    for wrong, right, role in ((collision, visual, "collision"), (visual, collision, "visual")):
        owners = [
            owner.name
            for owner, seen, _ in links
            if owner.name != link.name and _path(seen) == _path(wrong)
        ]
        if len(owners) == 1 and not (role == "visual" and _is_simplified(visual, collision)):
            yield Finding(
                wrong.at,
                f"link '{link.name}': the {role} is the mesh of '{owners[0]}'; each of the "
                f"other {len(links) - 1} links has one mesh for visual and collision",
                f"write {_path(right)}",
                related=(Related(right.at.span, "the other mesh of the link"),),
            )
            return


def _is_simplified(visual: Shape, collision: Shape) -> bool:
    """True for a collision that is named after the visual, such as ``wheel_simple``."""
    names = [
        os.path.basename(_path(shape)).partition(".")[0].lower() for shape in (visual, collision)
    ]
    short, long = sorted(names, key=len)
    return short in long


def _links_with_two_meshes(context: Context) -> Iterator[tuple[Link, Shape, Shape]]:
    """The links with one mesh as their visual and one as their collision, with both."""
    for link in context.model.links:
        shapes = [body.shape for body in (*link.visuals, *link.collisions)]
        if len(link.visuals) == len(link.collisions) == 1 and all(map(_path, shapes)):
            visual, collision = shapes
            assert visual is not None
            assert collision is not None
            yield link, visual, collision


def _path(shape: Shape | None) -> str:
    return shape.filename.value if shape and shape.filename else ""
