"""Damage to an input that knows a little of its syntax: tags, quoted values, numbers, lines."""

import re
import struct
from collections.abc import Callable, Sequence
from random import Random

#: Larger inputs find nothing new, and take longer.
MAX_SIZE = 20_000
_MAX_CHANGES = 6

_NUMBERS = [
    b"nan", b"inf", b"-inf", b"1e400", b"1e308", b"1e-400", b"-1", b"0", b"-0.0", b"9" * 400,
    b"4294967295", b"2147483648", b"0x10", b"1_000", b"0,5", b"", b" ", b"1 2", b"1 2 3 4",
    b"\xd9\xa3", b"--1", b"1e", b".", b"true", b"99999999",
]  # fmt: skip
_PIECES = [
    b"<", b">", b"/", b'"', b"'", b"&", b"=", b"--", b"]]>", b"<!--", b"-->", b"<![CDATA[", b"<?",
    b"<!DOCTYPE r [<!ENTITY a 'b'>]>", b"&a;", b"\0", b"\xff", b"\xf0\x9f\xa4\x96", b"\xef\xbb\xbf",
    b"\r", b"\n", b"\t", b"  ", b"${", b"}", b"$(", b")", b"$(arg x)", b"${x}", b"$(find none)",
    b"$(eval 1/0)", b"$(env HOME)", b"<link>", b"</link>", b'<link name="a"/>', b"[", b"]", b"{",
    b":", b"- ", b"&a ", b"*a", b"<<: *a", b"!degrees ", b"|", b"? ", b"%", b"(", b",", b".", b"*",
    b"**", b"lambda ", b" for x in ", b" if ", b"\\", b"package://", b"file://", b"../", b"#",
    b"urdfkit: ignore[ALL]", b"%s", b"/0", b"\xed\xa0\x80", b"\xe2\x80\xae",
]  # fmt: skip
_WORDS = [struct.pack("<I", n) for n in (0, 1, 2**31, 2**32 - 1, 65_536)] + [
    struct.pack("<f", x) for x in (float("nan"), float("inf"), 1e38, 1e-45)
]

Change = Callable[[bytes, Sequence[bytes], Random], bytes]


def mutate(data: bytes, others: Sequence[bytes], random: Random) -> bytes:
    """An input, damaged in one place or some.

    Args:
        data: the input.
        others: of the same kind, parts of which may be put in.
        random: chooses.
    """
    # Half of the inputs keep their syntax as a whole, so that what reads their values sees them.
    changes = random.choice((_CHANGES, _CHANGES_OF_PARTS))
    for _ in range(random.choice((1, 1, 2, _MAX_CHANGES))):
        data = random.choice(changes)(data, others, random)
    return data[:MAX_SIZE]


def _range(data: bytes, random: Random) -> tuple[int, int]:
    start = random.randint(0, len(data))
    return start, min(len(data), start + int(random.expovariate(1 / 20)))


def _flip(data: bytes, _: Sequence[bytes], random: Random) -> bytes:
    changed = bytearray(data or b"\0")
    changed[random.randrange(len(changed))] ^= random.randint(1, 255)
    return bytes(changed)


def _delete(data: bytes, _: Sequence[bytes], random: Random) -> bytes:
    start, end = _range(data, random)
    return data[:start] + data[end:]


def _double(data: bytes, _: Sequence[bytes], random: Random) -> bytes:
    start, end = _range(data, random)
    return data[:end] + data[start:end] * random.choice((1, 1, 1, 50)) + data[end:]


def _cut(data: bytes, _: Sequence[bytes], random: Random) -> bytes:
    return data[: random.randint(0, len(data))]


def _insert(data: bytes, _: Sequence[bytes], random: Random) -> bytes:
    at = random.randint(0, len(data))
    return data[:at] + random.choice(_PIECES) + data[at:]


def _word(data: bytes, _: Sequence[bytes], random: Random) -> bytes:
    """Other four bytes, as binary files have numbers."""
    at = random.randint(0, len(data))
    return data[:at] + random.choice(_WORDS) + data[at + 4 :]


def _splice(data: bytes, others: Sequence[bytes], random: Random) -> bytes:
    other = random.choice(others)
    start = random.randint(0, len(other))
    end = min(len(other), start + int(random.expovariate(1 / 100)))
    at, until = _range(data, random)
    return data[:at] + other[start:end] + data[until:]


def _replacing(pattern: bytes, replacements: Sequence[bytes]) -> Change:
    """Another piece, or none, for one of those that a pattern finds."""
    compiled = re.compile(pattern)

    def change(data: bytes, others: Sequence[bytes], random: Random) -> bytes:
        found = list(compiled.finditer(data))
        if not found:
            return _insert(data, others, random)
        one, other = random.choice(found), random.choice(found)
        kind = random.randrange(4)
        if kind == 0:
            new = b""
        elif kind == 1:
            new = one[0] * 2
        elif kind == 2 or not replacements:
            new = other[0]
        else:
            new = random.choice(replacements)
        return data[: one.start()] + new + data[one.end() :]

    return change


_CHANGES_OF_PARTS: tuple[Change, ...] = (
    _replacing(rb"<[^<>/]*/>", ()),
    _replacing(rb'\s[\w:]+="[^"<>]*"', ()),
    _replacing(rb'(?<=")[^"<>]*(?=")', [*_NUMBERS, *_PIECES]),
    _replacing(rb"(?<![\w.])[-+]?\d[\d.eE+-]*", _NUMBERS),
    _replacing(rb"\w+", ()),
    _replacing(rb"(?m)^.*\n", ()),
    _word,
)
_CHANGES = (
    *_CHANGES_OF_PARTS,
    _flip,
    _delete,
    _double,
    _cut,
    _insert,
    _insert,
    _splice,
    _splice,
    _replacing(rb"<[^<>]*>", ()),
)
