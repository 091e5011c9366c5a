"""Adjacent links as in MoveIt's Setup Assistant, and links of one rigid body.

Source: ``computeConnectionGraph`` in moveit_setup_srdf_plugins: links without collision geometry
are removed one by one, and their neighbours are connected directly.
"""

from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.tree import KinematicTree


class Adjacency:
    """Adjacency of the links of a model."""

    def __init__(self, tree: KinematicTree) -> None:
        self._joined: dict[str, set[str]] = {name: set() for name in tree.model.links_by_name}
        bodies = enumerate(rigid_bodies(tree))
        self._body = {name: number for number, body in bodies for name in body.names}
        for joint in tree.model.joints:
            if ends := tree.ends(joint):
                self._joined[ends[0]].add(ends[1])
                self._joined[ends[1]].add(ends[0])
        bare = {name for name, link in tree.model.links_by_name.items() if not link.collisions}
        self._gaps = _bare_groups(self._joined, bare)

    def is_adjacent(self, first: str, second: str) -> bool:
        """True if a joint connects two links, directly or through links without collisions."""
        if second in self._joined[first]:
            return True
        return not self._gaps.get(first, _NONE).isdisjoint(self._gaps.get(second, _NONE))

    def is_rigid(self, first: str, second: str) -> bool:
        """True if only fixed joints connect two links."""
        return self._body.get(first, first) == self._body.get(second, second)


_NONE: frozenset[int] = frozenset()


def _bare_groups(joined: dict[str, set[str]], bare: set[str]) -> dict[str, set[int]]:
    """The groups of connected links without collision that each link belongs or is adjacent to."""
    borders: dict[str, set[int]] = {}
    visited: set[str] = set()
    for number, start in enumerate(sorted(bare)):
        group = [] if start in visited else [start]
        visited.add(start)
        for name in group:  # appended to in the loop
            borders.setdefault(name, set()).add(number)
            for neighbour in joined[name]:
                if neighbour not in bare:
                    borders.setdefault(neighbour, set()).add(number)
                elif neighbour not in visited:
                    visited.add(neighbour)
                    group.append(neighbour)
    return borders
