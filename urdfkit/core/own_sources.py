"""Logs the sources of urdfkit, on which results depend in a checkout."""

import os
import sys

from urdfkit.core import disk

_PACKAGE = os.path.dirname(os.path.dirname(__file__))


def log_sources() -> None:
    """Log the sources that this process uses, if urdfkit runs from a checkout."""
    log = disk.log()
    if log is None or os.path.dirname(_PACKAGE).endswith("-packages"):
        return
    files = {getattr(module, "__file__", None) or "" for module in tuple(sys.modules.values())}
    for parent, directories, names in disk.walk(_PACKAGE):
        directories[:] = [name for name in directories if name != "__pycache__"]
        files.update(os.path.join(parent, name) for name in names if name.endswith(".json"))
    for file in files:
        if file.startswith(_PACKAGE):
            log.time(file)  # hashing them would take a tenth of the time of a check
