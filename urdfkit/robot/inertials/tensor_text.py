"""Tensors and moments of inertia as text."""

from collections.abc import Iterable

from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.link import Tensor

#: Products of inertia below this part of the largest moment result from angles such as 1.57.
PRODUCT_ROUNDING = 2e-3


def format_tensor(tensor: Tensor, present: Tensor) -> str:
    """The attributes of a tensor, without products of inertia that are 0, as at present."""
    texts = zip(Tensor._fields, digits(tensor), present, strict=True)
    return " ".join(
        f'{key}="{text}"' for key, text, old in texts if text != "0" or old or key[1] == key[2]
    )


def digits(tensor: Tensor) -> list[str]:
    """The values with six digits; products that result from rounded angles are 0."""
    least = PRODUCT_ROUNDING * max(map(abs, tensor))
    rows = zip(Tensor._fields, tensor, strict=True)
    return [
        f"{value:.6g}" if key[1] == key[2] or abs(value) > least else "0" for key, value in rows
    ]


def describe_solid(link: LinkInertia) -> str:
    """The tensor of the shape as text, such as ``a solid sphere of radius 0.1 m has 0.004 ...``."""
    expected = link.expected
    assert expected is not None
    moments = format_moments((expected.ixx, expected.iyy, expected.izz))
    article = "the" if link.solid and len(link.solid.parts) > 1 else "a"
    return f"{article} solid {link.solid} has {moments}"


def format_moments(numbers: Iterable[float]) -> str:
    """Moments with three digits and their unit, such as ``0.1, 0.1, 0.2 kg·m²``."""
    texts = [f"{value:.3g}" for value in numbers]
    return f"{texts[0]} kg·m² each" if len({*texts}) == 1 else f"{', '.join(texts)} kg·m²"
