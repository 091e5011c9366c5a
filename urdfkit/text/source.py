"""Text files and locations in them."""

from __future__ import annotations

import os
import re
from bisect import bisect_right
from errno import ELOOP
from itertools import accumulate

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.core.suggest import hint_for, nearest
from urdfkit.errors import UnreadableFile

#: Larger text files are rejected: no robot needs them, but a hostile one could.
MAX_BYTES = 64 * 1024 * 1024
#: The path of a text from standard input, unless the user names its file.
STANDARD_INPUT = "<stdin>"

# Compiled when needed: each pattern takes 0.1 ms of the 40 ms of an ordinary check.
_DECLARED = rb"""^\s*<\?xml[^>]*?\bencoding\s*=\s*["']([A-Za-z0-9._-]+)["']"""
#: Encodings of more than a byte per character, in which a declaration in ASCII is wrong.
WIDE = ("utf-16", "utf16", "utf-32", "utf32", "ucs-2", "ucs-4", "iso-10646-ucs")
#: Codecs of Python that are not encodings of XML; some take quadratic time.
_NON_XML_CODECS = frozenset("idna punycode raw_unicode_escape undefined unicode_escape".split())
_BYTE_ORDER_MARKS = (
    (b"\xef\xbb\xbf", "utf-8-sig"),
    (b"\xff\xfe\x00\x00", "utf-32"),
    (b"\x00\x00\xfe\xff", "utf-32"),
    (b"\xff\xfe", "utf-16"),
    (b"\xfe\xff", "utf-16"),
    (b"<\0", "utf-16-le"),  # without a mark, as expat detects it too
    (b"\0<", "utf-16-be"),
)


class Source:
    r"""A text file: its path, its text as UTF-8 bytes, and its lines.

    A file in another encoding is converted once, here, so that every offset in the
    program counts bytes of ``data``.

    >>> source = Source("r.urdf", b'<robot>\n  <link name="arm"/>\n</robot>')
    >>> start = source.data.index(b"arm")
    >>> print(Span(source, start, start + 3))
    r.urdf:2:15

    Attributes:
        path: as the user or the including file wrote it.
        data: the text in UTF-8, without a byte-order mark.
        encoding: of the file on disk.
        undecodable: offset in ``data`` of the first byte that is not text, or None.
    """

    __slots__ = ("__weakref__", "_is_ascii", "_starts", "data", "encoding", "path", "undecodable")

    def __init__(self, path: str, data: bytes) -> None:
        self.path = path
        self.encoding = "utf-8"
        self.undecodable: int | None = None
        self.data = self._as_utf8(data)
        self._starts: list[int] | None = None
        self._is_ascii: bool | None = None

    def __getstate__(self) -> tuple[None, dict[str, object]]:
        """The state for other processes, without the line index, which is longer than the text."""
        state = {name: getattr(self, name) for name in self.__slots__ if name != "__weakref__"}
        return None, {**state, "_starts": None, "_is_ascii": None}

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Source:
        """Read a file.

        Raises:
            UnreadableFile: it is missing, a directory, too large, or may not be opened.
        """
        path = os.fspath(path)
        try:
            data = disk.read(path, MAX_BYTES + 1)
        except OSError as error:
            raise UnreadableFile(f"{path or repr(path)}: {why_unreadable(path, error)}") from error
        except ValueError as error:  # a NUL in the name
            raise UnreadableFile(f"{path!r}: {error}") from error
        if len(data) > MAX_BYTES:
            raise UnreadableFile(f"{path}: larger than {MAX_BYTES // 2**20} MiB")
        return cls(path, data)

    @classmethod
    def of(cls, file: str | os.PathLike[str] | Source) -> Source:
        """A source that is already read, or the source of a file, which is read now.

        Raises:
            UnreadableFile: it is missing, a directory, too large, or may not be opened.
        """
        return file if isinstance(file, Source) else cls.read(file)

    def _as_utf8(self, data: bytes) -> bytes:
        for mark, encoding in _BYTE_ORDER_MARKS:
            if data.startswith(mark):
                self.encoding = encoding
                break
        else:
            head = data[:200]
            if b"encoding" in head and (declared := re.match(_DECLARED, head)):
                self.encoding = declared.group(1).decode("ascii").lower()
                if self.encoding.startswith(WIDE):
                    # The declaration would not be legible. Bytes of the true encoding follow.
                    other = re.search(rb"[^\0-\x7f]", data)
                    self.undecodable = other.start() if other else 0
                    return _ascii_only(data)
        if self.encoding in ("utf-8", "utf8", "us-ascii", "ascii"):
            try:
                data.decode("utf-8")
            except UnicodeDecodeError as error:
                self.undecodable = error.start
                # Each byte is replaced by one byte, so that all other offsets stay valid.
                return data[: error.start] + _ascii_only(data[error.start :])
            return data
        try:
            if self.encoding.replace("-", "_") in _NON_XML_CODECS:
                raise LookupError(self.encoding)
            return data.decode(self.encoding).encode("utf-8")
        except UnicodeError as error:
            self.undecodable = getattr(error, "start", 0)
        except LookupError:  # an encoding that does not exist
            self.undecodable = 0
        return _ascii_only(data)

    def position(self, offset: int) -> tuple[int, int]:
        """Line and column of an offset, both from 1; the column counts characters."""
        starts = self._line_starts()
        line = bisect_right(starts, offset)
        start = starts[line - 1]
        if self._is_ascii is None:
            self._is_ascii = self.data.isascii()
        if self._is_ascii:
            return line, offset - start + 1
        return line, len(self.data[start:offset].decode("utf-8", "replace")) + 1

    def offset(self, line: int, column: int) -> int:
        """Offset of a line and column, both from 1; the nearest valid one."""
        starts = self._line_starts()
        line = min(max(line, 1), len(starts))
        before = self.line(line)[: max(column - 1, 0)]
        return min(starts[line - 1] + len(before.encode()), len(self.data))

    def line(self, number: int) -> str:
        """The text of a line, numbered from 1, without its line end."""
        start, end = self.line_bounds(number)
        return self.data[start:end].decode("utf-8", "replace").rstrip("\r\n")

    def line_bounds(self, number: int) -> tuple[int, int]:
        """Offsets of the start of a line, numbered from 1, and of the next line."""
        starts = self._line_starts()
        return starts[number - 1], starts[number] if number < len(starts) else len(self.data)

    def _line_starts(self) -> list[int]:
        if self._starts is None:
            lines = self.data.splitlines(keepends=True)
            self._starts = [0, *accumulate(map(len, lines))]
            if lines and not lines[-1].endswith((b"\n", b"\r")):
                self._starts.pop()  # the end of the file does not start a line
        return self._starts

    def __repr__(self) -> str:
        return f"Source({self.path!r}, {len(self.data)} bytes)"


def why_unreadable(path: str, error: OSError) -> str:
    """Why a file could not be opened, and how to fix it."""
    if disk.is_directory(path):
        return "is a directory; name a file in it"
    if isinstance(error, PermissionError):
        return "is not readable; check its permissions"
    if error.errno == ELOOP:
        return "is a symbolic link to itself"
    if not isinstance(error, FileNotFoundError):
        return error.strerror or str(error)
    if disk.is_link(path):
        return f"is a symbolic link to '{disk.link_target(path)}', which does not exist"
    directory, name = os.path.split(path)
    try:
        siblings = disk.names(directory or ".")
    except OSError:
        return f"no such directory '{directory}'"
    # Stems are compared: names that end in '.urdf' are similar anyway.
    similar = [other for other in siblings if nearest(_stem(name), [_stem(other)])]
    suggested = nearest(name, similar, cutoff=0)
    return "file not found" + hint_for(suggested)


def _stem(name: str) -> str:
    return name.partition(".")[0]


def _ascii_only(data: bytes) -> bytes:
    return data.decode("ascii", "replace").replace("\ufffd", "?").encode("ascii")


class Span(Record):
    """A range of a source: bytes ``start`` to ``end``."""

    source: Source
    start: int
    end: int

    @property
    def text(self) -> str:
        return self.source.data[self.start : self.end].decode("utf-8", "replace")

    @property
    def line(self) -> int:
        return self.source.position(self.start)[0]

    @property
    def column(self) -> int:
        return self.source.position(self.start)[1]

    def __str__(self) -> str:
        line, column = self.source.position(self.start)
        return f"{shown(self.source.path)}:{line}:{column}"

    def __repr__(self) -> str:
        return f"Span({self}, {self.text[:40]!r})"


def shown(path: str) -> str:
    """A path as reports and messages show it.

    It is relative to the current directory if the file is in it, otherwise absolute.

    >>> shown(os.path.abspath("README.md")), shown("./README.md"), shown("/etc/hosts")
    ('README.md', 'README.md', '/etc/hosts')
    """
    try:
        relative = os.path.relpath(path)
    except (OSError, ValueError):  # the current directory is deleted; another drive
        return path
    is_outside = relative == os.pardir or relative.startswith(os.path.join(os.pardir, ""))
    return os.path.abspath(path) if is_outside else relative


def shown_text(text: str) -> str:
    """A text whose paths are `shown`."""
    if os.sep not in text:
        return text
    try:
        return without_directory(text, os.getcwd())
    except OSError:  # the current directory is deleted
        return text


def without_directory(text: str, directory: str, instead: str = "") -> str:
    """A text in which absolute paths below a directory are made relative to it.

    >>> without_directory("tried /ws/arm/a.stl and /opt/ws/a.stl", "/ws")
    'tried arm/a.stl and /opt/ws/a.stl'
    >>> without_directory("searched /ws, /ws/arm", "/ws")
    'searched ., arm'
    >>> without_directory("file:///ws/arm/a.stl", "/ws")
    'arm/a.stl'
    """
    if directory not in text or os.path.dirname(directory) == directory:
        return text
    prefix = re.escape(os.path.join(directory, ""))
    # Install commands keep their paths, and pages their end tags and base64 data.
    text = re.sub(rf"(?<!@ )\bfile:/*(?={prefix})", "", text)
    before = r"(?<!-e \")(?<![\w./\\<+-])"
    text = re.sub(before + prefix, lambda _: instead, text)
    itself = re.escape(directory) + r"(?![\w/\\-]|\.\w)"
    return re.sub(before + itself, lambda _: instead.rstrip("/") or ".", text)
