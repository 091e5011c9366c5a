"""Which links of a robot can collide with one another, as sampling has shown it."""

from enum import Enum
from typing import NamedTuple

from urdfkit.physics.collision.geometry_arrays import OmittedCollision

#: Pairs that come nearer than this, in m, without a collision are near misses.
NEAR = 0.005


class PairVerdict(Enum):
    """What became of a pair; the first that fits, in the order of MoveIt's Setup Assistant."""

    ADJACENT = "adjacent"  # a joint holds them together
    DEFAULT = "default"  # they collide where all joints begin
    ALWAYS = "always"  # they collide in nearly all samples
    SOMETIMES = "sometimes"  # they can collide, and must be watched
    NEVER = "never"  # no sample shows a collision
    UNKNOWN = "unknown"  # measuring them ended the process that tried

    @property
    def reason(self) -> str:
        """The reason that SRDF has for passing over such a pair; empty if it must be watched."""
        return (
            "" if self in (PairVerdict.SOMETIMES, PairVerdict.UNKNOWN) else self.value.capitalize()
        )


class ClosestApproach(NamedTuple):
    """Where two links came nearest to one another, or overlapped the most."""

    #: Signed, in m: negative by how deep they overlap. A configuration that was sampled may be
    #: nearer by a tenth.
    distance: float
    pose: dict[str, float]  # positions of the joints that move one against the other, in rad or m


class PairResult(NamedTuple):
    """Two links that both have collision geometry."""

    #: first and second: their names, in the order of the document.
    first: str
    second: str
    verdict: PairVerdict  # the result
    moves: bool  # False if only fixed joints lie between
    #: Of collisions, from 0 to 1, in the samples that all pairs were counted in; None for pairs
    #: that these samples say nothing new of.
    frequency: float | None
    nearest: ClosestApproach | None  # None for adjacent pairs, which are not measured

    @property
    def is_seldom(self) -> bool:
        """True if they collide where the robot begins, and in less than half of the samples.

        An SRDF that gives them as *Default* hides collisions that can be avoided.
        """
        if self.verdict is not PairVerdict.DEFAULT or self.frequency is None:
            return False
        return self.frequency < 0.5

    @property
    def is_near_miss(self) -> bool:
        """True if they move against one another and do not collide, by a hair's breadth."""
        is_free = self.verdict is PairVerdict.NEVER and self.moves
        return is_free and self.nearest is not None and self.nearest.distance < NEAR


class Matrix(NamedTuple):
    """The collision results of all pairs of links of a robot."""

    robot: str  # its name
    pairs: tuple[PairResult, ...]  # in the order of the document
    samples: int  # configurations that were looked at
    asked: int  # configurations that were asked for; more than `samples` if more showed nothing new
    counted: int  # of these, the ones that collisions were counted in
    seed: int  # of the samples
    omitted: tuple[OmittedCollision, ...]  # collision bodies that took no part, and why
    #: The topmost links of the parts of the robot, if it has several: roots, and what is the child
    #: of a planar or floating joint. Links of different parts make no pair, since nothing bounds
    #: how they stand to one another.
    parts: tuple[str, ...]
    #: Meshes whose file states another unit than the metre, by the number of metres.
    units: dict[str, float]
    applies_units: bool  # True if that unit was applied

    def of(self, verdict: PairVerdict) -> list[PairResult]:
        return [pair for pair in self.pairs if pair.verdict is verdict]

    @property
    def colliding(self) -> list[PairResult]:
        """The pairs that collide somewhere, and that no joint holds together."""
        verdicts = (PairVerdict.DEFAULT, PairVerdict.ALWAYS, PairVerdict.SOMETIMES)
        return [pair for pair in self.pairs if pair.moves and pair.verdict in verdicts]

    @property
    def near_misses(self) -> list[PairResult]:
        """The pairs that never collide and come close to it, the nearest first."""
        found = [pair for pair in self.pairs if pair.is_near_miss]
        return sorted(found, key=lambda pair: pair.nearest.distance if pair.nearest else 0.0)
