"""Entries of the result cache, and their file format."""

from __future__ import annotations

import os
import zlib

from urdfkit.core.cache_directory import cache_directory
from urdfkit.core.record import Record

#: Incremented when the file format or the meaning of answers changes.
_LAYOUT = b"urdfkit result 2"


class ResultEntry(Record):
    """The cached result of a check."""

    key: bytes  # the key of the entry
    since: int  # start of the check in nanoseconds since the epoch
    answers: list[tuple[str, str, str]]  # of the file system and environment: kind, path, answer
    code: int  # exit code
    outputs: list[tuple[str, bytes]]  # files and contents; an empty name is standard output


def directory() -> str | None:
    """The directory of the entries; None if there is none."""
    cache = cache_directory()
    return os.path.join(cache, "results") if cache else None


def path_of(key: bytes) -> str:
    """The file of the entry for a key."""
    return os.path.join(directory() or "", f"{zlib.crc32(key):08x}")


def encode(entry: ResultEntry) -> bytes:
    """An entry as bytes, with a checksum."""
    fields = [str(entry.since), str(entry.code), str(len(entry.answers)), str(len(entry.outputs))]
    for answer in entry.answers:
        fields += answer
    for path, data in entry.outputs:
        fields += (path, str(len(data)))
    head = b"\0".join(map(os.fsencode, fields))
    sizes = f"{len(entry.key)} {len(head)}\n".encode()
    body = b"".join((sizes, entry.key, head, *(data for _, data in entry.outputs)))
    return b"%s %08x\n%s" % (_LAYOUT, zlib.crc32(body), body)


def decode(data: bytes) -> ResultEntry:
    """The entry in the bytes of a file.

    Raises:
        ValueError: the data is damaged, or not an entry.
    """
    first, _, body = data.partition(b"\n")
    if first != b"%s %08x" % (_LAYOUT, zlib.crc32(body)):
        raise ValueError("damaged")
    sizes, _, rest = body.partition(b"\n")
    start, size = map(int, sizes.split())
    fields = rest[start : start + size].split(b"\0")
    since, code, count, outputs = map(int, fields[:4])
    texts = [os.fsdecode(field) for field in fields[4:]]
    end = 3 * count
    answers = list(zip(texts[:end:3], texts[1:end:3], texts[2:end:3], strict=True))
    offset = start + size
    written = []
    for path, length in zip(texts[end::2], map(int, texts[end + 1 :: 2]), strict=True):
        written.append((path, rest[offset : offset + length]))
        offset += length
    if len(answers) != count or len(written) != outputs:
        raise ValueError("damaged")
    return ResultEntry(rest[:start], since, answers, code, written)
