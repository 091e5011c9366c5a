"""Directories above a path."""

import os
from functools import lru_cache


@lru_cache(maxsize=1024)
def upwards(directory: str) -> tuple[str, ...]:
    """A directory and its parents, innermost first."""
    directories = [directory]
    while (parent := os.path.dirname(directories[-1])) != directories[-1]:
        directories.append(parent)
    return tuple(directories)


def is_within(path: str, directory: str) -> bool:
    """True for a directory and paths below it; links are not followed."""
    return path == directory or path.startswith(os.path.join(directory, ""))
