"""Forward kinematics for many configurations at once.

The same mathematics as `urdfkit.robot.kinematics`, over arrays: frames are homogeneous matrices
(n, 4, 4) in the frame of the root link, for n configurations.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import NamedTuple

import numpy as np

from urdfkit.core.grouping import by_key
from urdfkit.mesh.geometry import Floats
from urdfkit.mesh.transforms import homogeneous
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import span, start_of
from urdfkit.robot.kinematics import LOCKED, MimicLaw, direction, laws
from urdfkit.robot.tree import KinematicTree

#: Largest meaningful distance in m; squares of larger ones may overflow.
_FARTHEST = 1e9

_NEXT, _LAST = [1, 2, 0], [2, 0, 1]


class Axis(NamedTuple):
    """An independent joint: the sampled range and the default position, in rad or m."""

    joint: str
    lower: float
    upper: float
    default: float


class TreeStep(NamedTuple):
    """The step from a link to one of its children.

    The frame of the child in the parent is ``at_zero + f sine + g versine``, where f and g are the
    sine and 1 - cosine of an angle (Rodrigues' formula), or f is a distance.
    """

    parent: int  # number of the link
    child: int  # number of the link
    at_zero: Floats  # (4, 4), frame at position zero
    sine: Floats  # (4, 4)
    versine: Floats  # (4, 4)
    axis: Floats  # (3,), a unit vector, in the frame of the child as well as of the joint
    is_rotational: bool  # True for an angle, False for a distance
    column: int  # of the axis that defines the position; -1 for an immobile joint
    factor: float  # position = ``factor * position of the axis + shift``
    shift: float

    def frames(self, configurations: Floats) -> Floats:
        """Frames of the child in the parent: (n, 4, 4) for (n, dof), or (4, 4) if nothing moves."""
        if self.column < 0:
            return self._at(np.float64(self.shift))
        return self._at(self.factor * configurations[:, self.column, None, None] + self.shift)

    def _at(self, position: Floats | np.float64) -> Floats:
        if not self.is_rotational:
            return np.asarray(self.at_zero + position * self.sine)
        rotation = np.sin(position) * self.sine + (1 - np.cos(position)) * self.versine
        return np.asarray(self.at_zero + rotation)


@dataclass(frozen=True)
class TreeArrays:
    """A kinematic tree as arrays."""

    links: tuple[str, ...]  # names; steps refer to them by number
    axes: tuple[Axis, ...]  # independent joints, one column of a configuration each
    steps: tuple[TreeStep, ...]  # parents before children
    #: For each link, the number of the topmost link of its part. A root, or the child of a planar
    #: or floating joint, begins a part; each link of a closed loop without a root is a part.
    parts: tuple[int, ...]

    @cached_property
    def step_to(self) -> dict[int, TreeStep]:
        """The step to each link except the roots."""
        return {step.child: step for step in self.steps}

    @property
    def default(self) -> Floats:
        """(dof,), the initial configuration in MoveIt."""
        return self.row({})

    @property
    def limits(self) -> tuple[Floats, Floats]:
        """(dof,) each: lower and upper limits."""
        lower = np.array([axis.lower for axis in self.axes])
        return lower, np.array([axis.upper for axis in self.axes])

    def samples(self, count: int, seed: int, block: int) -> Floats:
        """Configurations (count, dof), uniformly distributed within the limits."""
        lower, upper = self.limits
        random = np.random.default_rng([seed, block]).random((count, len(self.axes)))
        return np.asarray(lower + (upper - lower) * random)

    def row(self, positions: Mapping[str, float]) -> Floats:
        """(dof,), positions by joint as a configuration, with defaults for the other joints."""
        return np.array([positions.get(axis.joint, axis.default) for axis in self.axes])

    def pose(self, row: Floats, first: int, second: int) -> dict[str, float]:
        """Positions, in rad or m, of the joints that determine the relative pose of two links."""
        return {self.axes[n].joint: float(row[n]) for n in self.between(first, second)}

    def frames(self, configurations: Floats, links: Iterable[int]) -> dict[int, Floats]:
        """The frames of links, (n, 4, 4) each, in n configurations (n, dof)."""
        count = len(configurations)
        required = set(links)
        for step in reversed(self.steps):
            if step.child in required:
                required.add(step.parent)
        frames: dict[int, Floats] = dict.fromkeys(required, np.eye(4))
        for step in self.steps:
            if step.child in required:
                frames[step.child] = frames[step.parent] @ step.frames(configurations)
        return {link: np.broadcast_to(frames[link], (count, 4, 4)) for link in links}

    def pairs(self, links: Iterable[int]) -> Iterator[tuple[int, int]]:
        """The pairs of links of the same part; the relative pose of other pairs is unbounded."""
        for group in by_key((self.parts[link], link) for link in sorted(links)).values():
            yield from combinations(group, 2)

    def default_with(self, columns: Sequence[int], positions: Floats) -> Floats:
        """Configurations (n, dof): the default, except columns with positions (n, k)."""
        rows = np.tile(self.default, (len(positions), 1))
        rows[:, columns] = positions
        return rows

    def between(self, first: int, second: int) -> list[int]:
        """The columns of the axes that move two links against each other."""
        branches = self.branches(first, second)
        return sorted({step.column for branch in branches for step in branch} - {-1})

    def branches(self, first: int, second: int) -> tuple[list[TreeStep], list[TreeStep]]:
        """The steps to two links from their last common ancestor, or from their roots."""
        paths: list[list[TreeStep]] = []
        for end in (first, second):
            path: list[TreeStep] = []
            while step := self.step_to.get(path[-1].parent if path else end):
                path.append(step)
            paths.append(path[::-1])
        shared = sum(a is b for a, b in zip(*paths, strict=False))
        return paths[0][shared:], paths[1][shared:]


def slopes(
    branches: tuple[Sequence[TreeStep], Sequence[TreeStep]],
    columns: Sequence[int],
    frames: Mapping[int, Floats],
    points: Floats,
    along: Floats,
) -> Floats:
    """(n, k): derivatives of the distance of two links with respect to k joints.

    Args:
        branches: the steps to the two links, from `TreeArrays.branches`.
        frames: (n, 4, 4), frames of all links on the branches.
        points: (n, 3), contact points in m.
        along: (n, 3), unit vectors from the first link to the second.
    """
    derivatives = np.zeros((len(points), len(columns)))
    for sign, branch in zip((-1, 1), branches, strict=True):
        for step in branch:
            if step.column >= 0:
                frame = frames[step.child]
                motion = frame[:, :3, :3] @ step.axis
                if step.is_rotational:
                    motion = _cross(motion, points - frame[:, :3, 3])
                speed = np.einsum("ni,ni->n", motion, along)
                derivatives[:, columns.index(step.column)] += sign * step.factor * speed
    return derivatives


def _cross(a: Floats, b: Floats) -> Floats:
    """(n, 3), three times as fast as np.cross."""
    return np.asarray(a[:, _NEXT] * b[:, _LAST] - a[:, _LAST] * b[:, _NEXT])


def tree_arrays(tree: KinematicTree) -> TreeArrays:
    """The arrays of a tree; links of a closed loop without a root stay at the origin."""
    names = tuple(tree.model.links_by_name)
    number = {name: index for index, name in enumerate(names)}
    axes = tuple(
        Axis(j.name, *span(j), start_of(j))
        for j in tree.model.joints_by_name.values()
        if j.is_single_dof and not j.leader
    )
    columns = {axis.joint: column for column, axis in enumerate(axes)}
    followed = laws(tree.model.joints_by_name)
    steps: list[TreeStep] = []
    parts = list(range(len(names)))
    for joint in tree.spanning:
        parent, child = number[joint.parent_name], number[joint.child_name]
        law = followed.get(joint.name, LOCKED)
        steps.append(_step(joint, parent, child, law, columns))
        if joint.kind not in ("planar", "floating"):
            parts[child] = parts[parent]
    return TreeArrays(names, axes, tuple(steps), tuple(parts))


def _step(
    joint: Joint, parent: int, child: int, law: MimicLaw, columns: Mapping[str, int]
) -> TreeStep:
    does_move = joint.is_single_dof
    origin = np.clip(homogeneous(*joint.origin), -_FARTHEST, _FARTHEST)
    x, y, z = direction(joint)
    is_rotational = joint.is_rotational
    sine = np.zeros((4, 4))
    if is_rotational:
        sine[:3, :3] = ((0, -z, y), (z, 0, -x), (-y, x, 0))
    else:
        sine[:3, 3] = (x, y, z)
    return TreeStep(
        parent,
        child,
        origin,
        origin @ sine,
        origin @ sine @ sine,
        np.array((x, y, z)),
        is_rotational,
        columns.get(law.leader, -1) if does_move else -1,
        law.factor,
        law.shift if does_move else 0.0,
    )
