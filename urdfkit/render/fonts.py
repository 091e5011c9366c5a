"""Fonts for text in images: Pillow's font, and system fonts for letters that it lacks.

Text in Pillow's font looks the same on every machine. For Chinese, Japanese and Korean names, for
instance, a system font is used if there is one; otherwise the letters are escaped.
"""

from collections.abc import Iterable
from functools import cache

from PIL import ImageFont

Font = ImageFont.FreeTypeFont | ImageFont.ImageFont

#: Files that Pillow searches in the system directories, and the face index in each: for Noto, the
#: simplified Chinese face, which contains the other scripts, too.
_FILES = (
    ("NotoSansCJK-Regular.ttc", 2),
    ("NotoSansCJKsc-Regular.otf", 0),
    ("NotoSansSC-Regular.otf", 0),
    ("SourceHanSansSC-Regular.otf", 0),
    ("wqy-microhei.ttc", 0),
    ("wqy-zenhei.ttc", 0),
    ("DroidSansFallbackFull.ttf", 0),
    ("Hiragino Sans GB.ttc", 0),  # macOS
    ("STHeiti Light.ttc", 0),
    ("Arial Unicode.ttf", 0),
    ("msyh.ttc", 0),  # Windows
    ("malgun.ttf", 0),
    ("YuGothR.ttc", 0),
    ("arial.ttf", 0),
    ("DejaVuSans.ttf", 0),
    ("NotoSans-Regular.ttf", 0),
)
#: Not a letter, so every font draws its glyph for missing letters.
_NO_LETTER = "\uffff"


def writing(text: str, size: float) -> tuple[Font, str]:
    """A font of a size in pixels, and the text with missing letters escaped."""
    face, missing = _best(text)
    escapes = {ord(letter): letter.encode("unicode_escape").decode("ascii") for letter in missing}
    font = _font(face, size)
    assert font is not None
    return font, text.translate(escapes)


def unwritable(texts: Iterable[str]) -> str:
    """The letters that no font contains, which are escaped."""
    return "".join(sorted(set().union(*(_best(text)[1] for text in texts))))


def _best(text: str) -> tuple[tuple[str, int] | None, frozenset[str]]:
    """The first font with the fewest missing letters, None for Pillow's, and these letters."""
    letters = frozenset(text)
    best, least = None, _lacking(None, letters)
    for face in _FILES if least else ():
        lacking = _lacking(face, letters)
        if len(lacking) < len(least):
            best, least = face, lacking
    return best, least


def _lacking(face: tuple[str, int] | None, letters: frozenset[str]) -> frozenset[str]:
    return frozenset(letter for letter in letters if not _has(face, letter))


@cache
def _has(face: tuple[str, int] | None, letter: str) -> bool:
    if letter.isascii() and face is None:
        return True
    font = _font(face, 16)
    if font is None:
        return False
    drawn, nothing = font.getmask(letter), font.getmask(_NO_LETTER)
    return drawn.size != nothing.size or bytes(drawn) != bytes(nothing)


@cache
def _font(face: tuple[str, int] | None, size: float) -> Font | None:
    """None if the font is not installed."""
    if face is None:
        return ImageFont.load_default(size)
    try:
        return ImageFont.truetype(face[0], size, index=face[1])
    except OSError:
        return None
