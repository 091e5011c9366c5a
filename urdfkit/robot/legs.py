"""The legs or wheels of a robot: links and joints that are intended to be alike.

Authors write one leg and copy it, or call a macro for each. Four legs show which of them differs by
mistake.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

#: A corner: the words of a side, those of an end, and a number next to them, as in ``knee_L2``.
_SIDE = r"left|right|[lr][frbhm]|[frbhm][lr]|[lr]"
_END = r"front|rear|back|hind|middle|mid"
_CORNER = (
    rf"(?<![a-z])(?:(?:{_END})[_-]?)?(?:{_SIDE})(?:[_-]?(?:{_END}))?(?:[_-]?\d{{1,2}})?"
    r"(?![a-z0-9])"
)

#: Least number of legs, of which one may differ from all others.
_MIN_LEGS = 4

#: Longer names are not compared.
_MAX_LENGTH = 200


def legs(names: Iterable[str]) -> list[dict[str, str]]:
    """The names that differ only in the corner, such as ``FL_knee``, each by its corner, ``fl``.

    Only those of at least four corners.
    """
    groups: dict[str, dict[str, str]] = {}
    short = [name for name in names if len(name) <= _MAX_LENGTH]
    for name in short if len(short) >= _MIN_LEGS else ():
        # The side may be there twice, as in ``lf_hip_lf_knee``.
        corners = set(re.findall(_CORNER, name.lower()))
        if len(corners) == 1:
            groups.setdefault(re.sub(_CORNER, "*", name.lower()), {})[corners.pop()] = name
    return [group for group in groups.values() if len(group) >= _MIN_LEGS]
