"""The cache directory: mesh measures and check results, kept between runs."""

import os
import sys

#: Environment variable with the directory; an empty value disables the cache.
VARIABLE = "URDFKIT_CACHE_DIR"


def cache_directory() -> str | None:
    """The cache directory; None if the environment disables the cache."""
    given = os.environ.get(VARIABLE)
    if given is not None:
        return given or None
    home = os.path.expanduser("~")
    if sys.platform == "win32":
        local = os.environ.get("LOCALAPPDATA") or os.path.join(home, "AppData", "Local")
        return os.path.join(local, "urdfkit", "Cache")
    if sys.platform == "darwin":
        return os.path.join(home, "Library", "Caches", "urdfkit")
    # https://specifications.freedesktop.org/basedir-spec: relative paths are ignored.
    given = os.environ.get("XDG_CACHE_HOME", "")
    return os.path.join(given if os.path.isabs(given) else f"{home}/.cache", "urdfkit")
