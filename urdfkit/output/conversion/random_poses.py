"""Random poses at which a converted robot is compared with the original."""

from collections.abc import Iterable, Iterator
from random import Random

from urdfkit.robot.joint import Joint

#: Bound of positions, in rad or m, if the limit of a joint is larger or missing.
_MAX_POSITION = 3.0


def random_poses(joints: Iterable[Joint], count: int) -> Iterator[dict[str, float]]:
    """Poses within the limits of joints, in rad or m by name; the first pose is all zeros (empty).

    The poses are the same in every run.
    """
    ranges = {joint.name: _range(joint) for joint in joints}
    random = Random(0)
    for number in range(count):
        yield {name: random.uniform(*ends) for name, ends in ranges.items()} if number else {}


def _range(joint: Joint) -> tuple[float, float]:
    limit = joint.limit if joint.kind != "continuous" else None
    lower = max(limit.lower.value if limit and limit.lower else -_MAX_POSITION, -_MAX_POSITION)
    upper = min(limit.upper.value if limit and limit.upper else _MAX_POSITION, _MAX_POSITION)
    return lower, max(lower, upper)
