"""The entries of a tensor: their arrangement, signs and differences."""

from collections.abc import Iterable, Sequence
from itertools import product

from urdfkit.robot import inertia
from urdfkit.robot.inertials.link_comparison import EXACT_RATIO, ROUNDING, LinkInertia
from urdfkit.robot.inertials.tensor_text import PRODUCT_ROUNDING
from urdfkit.robot.link import Tensor

#: Largest difference of a tensor with rearranged entries or signs from that of the shape, as a part
#: of the largest moment.
_ENTRY_TOLERANCE = 0.05
#: Row and column of ``ixx``, ``ixy``, ``ixz``, ``iyy``, ``iyz`` and ``izz``.
_CELLS = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))


def is_possible(tensor: Tensor) -> bool:
    """True if the tensor is physically possible."""
    low, middle, high = inertia.principal_moments(tensor)
    return low > 0 and high <= (low + middle) * (1 + ROUNDING)


def rearranged(
    link: LinkInertia, expected: Tensor, orders: Iterable[Sequence[int]]
) -> Tensor | None:
    """The tensor with rearranged entries or signs that agrees with the shape.

    None if no arrangement agrees. Of several, the one with the fewest changes.
    """
    candidates = []
    for order, signs in product(orders, product((1, -1), repeat=3)):
        tensor = _permuted(link.tensor, order, signs)
        pairs = zip(tensor, expected, strict=True)
        if max(abs(a - b) for a, b in pairs) <= _ENTRY_TOLERANCE * abs(link.moments[2]):
            changes = sum(a != b for a, b in zip(tensor, link.tensor, strict=True))
            candidates.append((changes, tensor))
    return min(candidates)[1] if candidates else None


def _permuted(tensor: Tensor, order: Sequence[int], signs: Sequence[int]) -> Tensor:
    """A tensor with permuted axes, and with signs for ``ixy``, ``ixz`` and ``iyz``."""
    of_cell = dict(zip(_CELLS, tensor, strict=True))
    xx, xy, xz, yy, yz, zz = (
        of_cell[min(order[i], order[j]), max(order[i], order[j])] for i, j in _CELLS
    )
    return Tensor(xx, signs[0] * xy or 0.0, signs[1] * xz or 0.0, yy, signs[2] * yz or 0.0, zz)


def opposite(tensor: Tensor, other: Tensor) -> list[str]:
    """The entries with opposite signs; empty if the tensors differ otherwise, too."""
    rows = zip(Tensor._fields, tensor, other, strict=True)
    different = [(key, a, b) for key, a, b in rows if a != b]
    keys = [key for key, a, b in different if a == -b]
    return keys if len(keys) == len(different) else []


def differs(key: str, link: LinkInertia, tensor: Tensor) -> bool:
    """True if an entry differs from the computed one by more than its digits explain."""
    old, value = getattr(link.tensor, key), getattr(tensor, key)
    bound = (EXACT_RATIO - 1) * abs(value)
    if key[1] != key[2]:
        bound = PRODUCT_ROUNDING * max(map(abs, tensor))
    return bool(abs(old - value) > bound)
