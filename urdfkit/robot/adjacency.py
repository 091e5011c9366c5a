"""Which links are neighbours, as MoveIt's Setup Assistant has it, and which move as one.

Source: ``computeConnectionGraph`` in moveit_setup_srdf_plugins: links without collision geometry
are taken out one by one, and what they joined is joined directly.
"""

from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.tree import KinematicTree


class Adjacency:
    """The neighbours in a model."""

    def __init__(self, tree: KinematicTree) -> None:
        self._joined: dict[str, set[str]] = {name: set() for name in tree.model.links_by_name}
        self._body = {
            link.name: number
            for number, body in enumerate(rigid_bodies(tree))
            for link, _ in body.links
        }
        for joint in tree.model.joints:
            if ends := tree.ends(joint):
                self._joined[ends[0]].add(ends[1])
                self._joined[ends[1]].add(ends[0])
        bare = {name for name, link in tree.model.links_by_name.items() if not link.collisions}
        self._gaps = _gaps(self._joined, bare)

    def is_adjacent(self, first: str, second: str) -> bool:
        """True if a joint holds two links, or only links without collision lie between them."""
        if second in self._joined[first]:
            return True
        return not self._gaps.get(first, _NONE).isdisjoint(self._gaps.get(second, _NONE))

    def is_rigid(self, first: str, second: str) -> bool:
        """True if only fixed joints lie between two links."""
        return self._body.get(first, first) == self._body.get(second, second)


_NONE: frozenset[int] = frozenset()


def _gaps(joined: dict[str, set[str]], bare: set[str]) -> dict[str, set[int]]:
    """The groups of bare links, joined among themselves, that each link is in or borders on."""
    borders: dict[str, set[int]] = {}
    seen: set[str] = set()
    for number, start in enumerate(sorted(bare)):
        group = [] if start in seen else [start]
        seen.add(start)
        for name in group:  # grows while it is walked
            borders.setdefault(name, set()).add(number)
            for other in joined[name]:
                if other not in bare:
                    borders.setdefault(other, set()).add(number)
                elif other not in seen:
                    seen.add(other)
                    group.append(other)
    return borders
