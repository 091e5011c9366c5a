"""Values of elements as Gazebo reads them."""

import re

from urdfkit.robot.values import number
from urdfkit.text.document import Element

#: A decimal or hexadecimal number, as C's ``strtod`` accepts.
_FLOAT = r"\s*([-+]?(?:0x[\da-f]+|(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?|inf(?:inity)?|nan))"
_INTEGER = r"\s*([-+]?(?:0x[\da-f]+|\d+))"
_PLACEHOLDER = r"__\w+__|@\w+@|\{\{[^{}]*\}\}"

#: SDF's own units, which can be ignored.
_UNITS = ("hz", "m", "s", "rad", "kg", "n", "nm", "n/m", "m/s", "rad/s", "px", "pixel", "pixels")

_TRUE = ("true", "yes", "1")


def text_of(tag: Element) -> str:
    """The value of a child of ``<gazebo>``; ``value=""`` is a legacy syntax."""
    return tag.get("value") or tag.text.strip()


def is_true(tag: Element) -> bool:
    """True if Gazebo's converter interprets the value of a tag as true."""
    return text_of(tag).lower() in _TRUE


def leading(text: str, *, whole: bool = False) -> tuple[str, str]:
    """The number at the beginning of a text, which Gazebo reads, and the rest, which it ignores.

    Args:
        whole: True if Gazebo reads an integer, which ends before a point or an exponent.

    Returns:
        both are empty if the text does not begin with a number.

    >>> leading("0,5"), leading("50 cm"), leading("10 Hz"), leading("fast")
    (('0', ',5'), ('50', 'cm'), ('10', ''), ('', ''))
    >>> leading("640.0", whole=True), leading("1e2", whole=True)
    (('640', ''), ('1', 'e2'))
    """
    plain = text if whole else text.removeprefix("-").replace(".", "", 1)
    if plain.isascii() and plain.isdecimal():  # the most frequent case, without a pattern
        return text, ""
    match = re.match(_INTEGER if whole else _FLOAT, text, re.IGNORECASE)
    if match is None:
        return "", ""
    rest = text[match.end() :].strip()
    is_harmless = rest.lower() in _UNITS or (whole and rest[:1] == "." and not rest.strip(".0"))
    return match.group(1), "" if is_harmless else rest


def value(text: str) -> float:
    """The value of a number that ``leading`` returned."""
    return float(int(text, 16)) if "x" in text.lower() else float(text)


def quoted(text: str) -> str:
    return f"'{text}'" if text else "empty"


def corrected(text: str) -> str:
    """Replacement of a number with trailing text, as the end of a help."""
    right = text.replace(",", ".").removesuffix(".")
    return right if number(right) is not None else "only the number"


def is_placeholder(text: str) -> bool:
    """True for ``__name__``, ``@NAME@`` and ``{{ name }}``, which a program replaces."""
    return text[:1] in ("_", "@", "{") and bool(re.fullmatch(_PLACEHOLDER, text))
