"""The sources of urdfkit, of which a result depends where they change without a new version."""

import os
import sys

from urdfkit.core import disk

_PACKAGE = os.path.dirname(os.path.dirname(__file__))


def note_sources() -> None:
    """Note the sources that this process uses, if urdfkit runs from a checkout."""
    log = disk.log()
    if log is None or os.path.dirname(_PACKAGE).endswith("-packages"):
        return
    files = {getattr(module, "__file__", None) or "" for module in tuple(sys.modules.values())}
    for parent, directories, names in disk.walk(_PACKAGE):
        directories[:] = [name for name in directories if name != "__pycache__"]
        files.update(os.path.join(parent, name) for name in names if name.endswith(".json"))
    for file in files:
        if file.startswith(_PACKAGE):
            log.time(file)  # to hash them all would be a tenth of a check
