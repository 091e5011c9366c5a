"""The directory of what urdfkit keeps between runs: measures of meshes, results of checks."""

import os
import sys

#: The directory; where it is set and empty, nothing is kept.
VARIABLE = "URDFKIT_CACHE_DIR"


def cache_directory() -> str | None:
    """The directory of the cache; None if the environment wants none."""
    given = os.environ.get(VARIABLE)
    if given is not None:
        return given or None
    home = os.path.expanduser("~")
    if sys.platform == "win32":
        local = os.environ.get("LOCALAPPDATA") or os.path.join(home, "AppData", "Local")
        return os.path.join(local, "urdfkit", "Cache")
    if sys.platform == "darwin":
        return os.path.join(home, "Library", "Caches", "urdfkit")
    # https://specifications.freedesktop.org/basedir-spec: a relative path is to be ignored.
    given = os.environ.get("XDG_CACHE_HOME", "")
    return os.path.join(given if os.path.isabs(given) else f"{home}/.cache", "urdfkit")
