"""The links of a robot whose collisions and visuals differ, and how."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import Enum
from functools import cached_property
from math import hypot

from urdfkit.core.grouping import by_key
from urdfkit.robot.assets.visual_collision import LEAST_OVERLAP, VisualCollisionPair
from urdfkit.robot.link import Body
from urdfkit.robot.model import RobotModel
from urdfkit.robot.shapes import MeshSolid, solid
from urdfkit.text.document import Tag

#: Boxes with a larger overlap are aligned.
ALIGNED = 0.85


class Mismatch(Enum):
    """The difference between the collision and the visual of a link."""

    SIZE = "size"
    ROTATION = "rotation"
    APART = "apart"


class VisualCollisionPairs:
    """The links of a robot that have both visuals and collisions.

    Args:
        mesh_solid: returns a mesh as a solid; None if it is not measured.
        is_ambiguous: True for a visual or collision whose axes programs interpret differently.
    """

    def __init__(
        self,
        model: RobotModel,
        mesh_solid: Callable[[Body], MeshSolid | None],
        is_ambiguous: Callable[[Body], bool],
    ) -> None:
        self._model = model
        self._mesh_solid = mesh_solid
        self._is_ambiguous = is_ambiguous

    @cached_property
    def mismatches(self) -> dict[Mismatch, list[VisualCollisionPair]]:
        """The links with each mismatch; each link has at most one."""
        pairs = ((self._mismatch(pair), pair) for pair in self.each())
        return by_key((mismatch, pair) for mismatch, pair in pairs if mismatch)

    @property
    def span(self) -> float:
        """The longest distance between consecutive joints, in m."""
        places = (joint.origin.position for joint in self._model.joints)
        return max((hypot(*place) for place in places), default=0.0)

    def each(self) -> Iterator[VisualCollisionPair]:
        """The links whose visuals and collisions are measured and not the same."""
        for link in self._model.links:
            if link.visuals and link.collisions:
                collision = solid(link.collisions, self._mesh_solid)
                visual = solid(link.visuals, self._mesh_solid)
                if collision and visual and collision.parts != visual.parts:
                    yield VisualCollisionPair(link, collision, visual)

    def _mismatch(self, pair: VisualCollisionPair) -> Mismatch | None:
        if pair.overlap >= ALIGNED or (pair.is_marker and not pair.is_shrunk):
            return None
        if pair.factor:
            return Mismatch.SIZE
        if not pair.has_one_shape:  # otherwise the origins explain the difference
            if any(map(self._is_ambiguous, pair.link.bodies)):
                return None
            if pair.turn:
                return Mismatch.ROTATION
        is_unlike = pair.overlap < LEAST_OVERLAP and not pair.is_nested
        is_apart = pair.is_apart or (is_unlike and self.of_another_link(pair))
        return Mismatch.APART if is_apart else None

    def of_another_link(self, pair: VisualCollisionPair) -> tuple[Body, str] | None:
        """The visual or the collision with the mesh of one other link, and the name of that link.

        Only if it is the only one of its link whose mesh has this name: a pair of links, such as
        wheels, has the same mesh for both. Nor is the mesh of a macro that another one, too, calls.
        """
        if len(pair.link.visuals) > 1:
            return None
        bodies = (pair.link.visuals[0], *pair.link.collisions)
        if not all(body.file for body in bodies):
            return None
        names = [_stem(body) for body in bodies]
        for body in bodies if len(bodies) == 2 else bodies[:1]:
            users = self._users.get(body.file.value if body.file else "", {})
            own = body.shape.at.tag_at if body.shape else None
            others = [link for at, link in users.items() if link != pair.link.name and at != own]
            if names.count(_stem(body)) == 1 and len(others) == 1 and len(users) <= 2:
                return body, others[0]
        return None

    @cached_property
    def _users(self) -> dict[str, dict[Tag, str]]:
        """The links that have each mesh as a visual, by the tag of the mesh in its file.

        Or as a collision whose visual has the same name, such as ``arm.stl`` and ``arm.dae``.
        """
        users: dict[str, dict[Tag, str]] = {}
        for link in self._model.links:
            seen = {body.file.value for body in link.visuals if body.file}
            names = {_stem(body) for body in link.visuals}
            for body in link.bodies:
                is_own = body in link.visuals or (body.file and body.file.value not in seen)
                if body.shape and body.file and is_own and _stem(body) in names:
                    users.setdefault(body.file.value, {})[body.shape.at.tag_at] = link.name
        return users


def _stem(body: Body) -> str:
    """The name of a mesh without its directory and suffix; empty for other shapes."""
    path = body.file.value if body.file else ""
    return path.rpartition("/")[2].partition(".")[0].lower()
