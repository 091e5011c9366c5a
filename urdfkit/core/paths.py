"""Paths and the directories above them."""

import os
from functools import lru_cache


@lru_cache(maxsize=1024)
def upwards(directory: str) -> tuple[str, ...]:
    """A directory and those above it, the innermost first."""
    found = [directory]
    while (above := os.path.dirname(found[-1])) != found[-1]:
        found.append(above)
    return tuple(found)


def is_within(path: str, directory: str) -> bool:
    """True for a directory and what is below it, by the paths alone: links are not followed."""
    return path == directory or path.startswith(os.path.join(directory, ""))
