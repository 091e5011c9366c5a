"""The collision matrix: which links of a robot can collide with each other."""

from enum import Enum
from typing import NamedTuple

from urdfkit.physics.collision.geometry_arrays import OmittedCollision

#: Distance in m below which a pair without collisions is a near miss.
NEAR_MISS = 0.005


class PairVerdict(Enum):
    """The result for a pair; the first that applies, in the order of MoveIt's Setup Assistant."""

    ADJACENT = "adjacent"  # a joint connects the links
    DEFAULT = "default"  # they collide in the initial configuration
    ALWAYS = "always"  # they collide in nearly all samples
    SOMETIMES = "sometimes"  # they can collide, and must be checked
    NEVER = "never"  # they collide in no sample
    UNKNOWN = "unknown"  # measuring them crashes

    @property
    def reason(self) -> str:
        """The reason in SRDF for disabling such a pair; empty if it must be checked."""
        return (
            "" if self in (PairVerdict.SOMETIMES, PairVerdict.UNKNOWN) else self.value.capitalize()
        )


class ClosestApproach(NamedTuple):
    """The least distance, or deepest overlap, of two links."""

    #: Signed, in m; the negative penetration depth if they overlap. The true least distance of the
    #: samples may be smaller by a tenth.
    distance: float
    pose: dict[str, float]  # positions of the joints between the links, in rad or m


class PairResult(NamedTuple):
    """Two links that both have collision geometry."""

    #: first and second: names, in the order of the document.
    first: str
    second: str
    verdict: PairVerdict
    moves: bool  # False if only fixed joints are between the links
    #: Part of the counted samples with a collision, from 0 to 1; None if the samples add no
    #: information.
    frequency: float | None
    nearest: ClosestApproach | None  # None for adjacent pairs, which are not measured

    @property
    def is_seldom(self) -> bool:
        """True if the links collide in the initial pose, but in less than half of the samples.

        An SRDF that disables them as *Default* hides avoidable collisions.
        """
        if self.verdict is not PairVerdict.DEFAULT or self.frequency is None:
            return False
        return self.frequency < 0.5

    @property
    def is_near_miss(self) -> bool:
        """True if the links move against each other and nearly collide."""
        is_free = self.verdict is PairVerdict.NEVER and self.moves
        return is_free and self.nearest is not None and self.nearest.distance < NEAR_MISS


class Matrix(NamedTuple):
    """The collision results of all pairs of links of a robot."""

    robot: str  # name of the robot
    links: tuple[str, ...]  # the links with collision geometry that can be used
    pairs: tuple[PairResult, ...]  # in the order of the document
    samples: int  # number of tested configurations
    asked: int  # number of requested configurations; more than `samples` if sampling ended early
    counted: int  # number of configurations in which collisions were counted
    seed: int  # of the samples
    omitted: tuple[OmittedCollision, ...]  # omitted collision bodies, with reasons
    #: The topmost links of the parts of the robot, if it has several: roots, and children of planar
    #: or floating joints. Links of different parts form no pair, because their relative pose is
    #: unbounded.
    parts: tuple[str, ...]
    #: Units in metres of meshes whose file defines another unit.
    units: dict[str, float]
    applies_units: bool  # True if these units were applied

    def of(self, verdict: PairVerdict) -> list[PairResult]:
        return [pair for pair in self.pairs if pair.verdict is verdict]

    @property
    def colliding(self) -> list[PairResult]:
        """The pairs that collide in any configuration and are not adjacent."""
        verdicts = (PairVerdict.DEFAULT, PairVerdict.ALWAYS, PairVerdict.SOMETIMES)
        return [pair for pair in self.pairs if pair.moves and pair.verdict in verdicts]

    @property
    def near_misses(self) -> list[PairResult]:
        """The pairs that nearly collide, the nearest first."""
        misses = [pair for pair in self.pairs if pair.is_near_miss]
        return sorted(misses, key=lambda pair: pair.nearest.distance if pair.nearest else 0.0)
