"""Finds renamed links and joints of a robot.

A link is matched by its place in the tree, by its body, and by its child links: two of the three
must be unchanged. A joint is matched by its two links. Ambiguous matches are ignored.
"""

from collections.abc import Iterator

from urdfkit.output.comparison.differences import RenamedParts, Tolerances, of_frames, of_link
from urdfkit.robot.joint import Joint
from urdfkit.robot.model import RobotModel


def renames(before: RobotModel, after: RobotModel, allowed: Tolerances) -> RenamedParts:
    """The new names of renamed links and joints.

    Args:
        before: the robot with the old names.
        after: the robot with the new names.
        allowed: tolerances within which a link is unchanged.
    """
    old, new = _Tree(before), _Tree(after)
    links = {name: name for name in old.links if name in new.links}
    if len(links) < min(len(old.links), len(new.links)):
        # Matches spread to their neighbours until there are no more.
        while matches := _unique_matches(old, new, links, allowed):
            links |= matches
    joints = {
        joint.name: other.name
        for child, joint in old.above.items()
        if (other := new.above.get(links.get(child, "")))
        and links.get(joint.parent_name) == other.parent_name
        and joint.name not in after.joints_by_name
        and other.name not in before.joints_by_name
    }
    return RenamedParts({name: other for name, other in links.items() if name != other}, joints)


class _Tree:
    """The links of a robot with the joints around them."""

    def __init__(self, model: RobotModel) -> None:
        self.links = model.links_by_name
        #: Parent joints by child link; the first one of several.
        self.above: dict[str, Joint] = {}
        self.children: dict[str, list[str]] = {}
        for joint in model.joints:
            if joint.child_name and joint.child_name not in self.above:
                self.above[joint.child_name] = joint
                self.children.setdefault(joint.parent_name, []).append(joint.child_name)
        self.children[""] = [name for name in self.links if name not in self.above]

    def parent(self, name: str) -> str:
        """The link above; empty for a root."""
        return self.above[name].parent_name if name in self.above else ""


def _unique_matches(
    old: _Tree, new: _Tree, links: dict[str, str], allowed: Tolerances
) -> dict[str, str]:
    """Links next to matched ones that can correspond to one link only, in both directions."""
    taken = set(links.values())
    fits: dict[str, list[str]] = {}
    for name in old.links.keys() - links.keys():
        near = set(_near(old, new, name, links)) & new.links.keys() - taken
        alike = [other for other in near if _is_same(old, new, name, other, links, allowed)]
        above = old.above.get(name)
        surest = [other for other in alike if above and above.name == new.above[other].name]
        fits[name] = surest or alike
    claimed = [other for others in fits.values() for other in others]
    return {
        name: others[0]
        for name, others in fits.items()
        if len(others) == 1 and claimed.count(others[0]) == 1
    }


def _near(old: _Tree, new: _Tree, name: str, links: dict[str, str]) -> Iterator[str]:
    """The links with the matched parent of a link, or with its matched children."""
    parent = old.parent(name)
    if not parent or parent in links:
        yield from new.children.get(links.get(parent, ""), ())
    for child in old.children.get(name, ()):
        if child in links:
            yield new.parent(links[child])


def _is_same(
    old: _Tree, new: _Tree, name: str, other: str, links: dict[str, str], allowed: Tolerances
) -> bool:
    """True if two of place, body and children are unchanged."""
    before, after = old.links[name], new.links[other]
    children = {links.get(child, "") for child in old.children.get(name, ())}
    carries = children and children == set(new.children.get(other, ()))
    has_body = not (before.is_frame and after.is_frame)
    is_alike = not any(of_link(before, after, allowed))
    if _is_in_place(old.above.get(name), new.above.get(other), links, allowed):
        return is_alike or bool(carries)
    return has_body and is_alike and bool(carries)


def _is_in_place(
    before: Joint | None, after: Joint | None, links: dict[str, str], allowed: Tolerances
) -> bool:
    """True for roots, and for links with the same parent and the same joint."""
    if before is None or after is None:
        return before is after
    if links.get(before.parent_name) != after.parent_name:
        return False
    is_still = not any(of_frames("", "", before.origin, after.origin, allowed))
    return before.name == after.name or (before.kind == after.kind and is_still)
