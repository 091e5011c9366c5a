"""``urdfkit clean``: removes the cache."""

import os
from contextlib import suppress
from errno import EEXIST, ENOENT, ENOTEMPTY

from urdfkit.cli import output
from urdfkit.cli.cache_contents import contents
from urdfkit.cli.decorators import described
from urdfkit.core.cache_directory import cache_directory
from urdfkit.errors import UnwritableFile


@described("clean")
def command() -> int:
    """Remove the cache: results of checks and measures of meshes.

    Exit codes: 0 done, 2 a file cannot be removed.

    Examples:
        urdfkit clean
    """
    cache = contents()
    try:
        for entry in cache.files:
            with suppress(FileNotFoundError):  # removed by another process
                os.unlink(entry)
        for directory in cache.directories:
            _remove(directory)
    except OSError as error:
        raise UnwritableFile(f"{error.filename}: cannot be removed: {error.strerror}") from error
    output.page([f"{cache_directory() or 'no cache'}: {len(cache.files)} entries removed"])
    return 0


def _remove(directory: str) -> None:
    """Remove a directory, unless another process has removed it or added an entry."""
    try:
        os.rmdir(directory)
    except OSError as error:
        if error.errno not in (ENOENT, ENOTEMPTY, EEXIST):
            raise
