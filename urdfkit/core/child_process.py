"""A process of our own, which talks with this one by its standard input and output."""

import os
import subprocess
import sys

#: The directories of modules are handed over, so that nothing is imported from where we stand.
_BOOT = "import sys; sys.path[:] = sys.argv[2:]; __import__(sys.argv[1], fromlist=['main']).main()"
#: Several processes share the processors: none may start threads of its own.
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


def start(module: str) -> subprocess.Popen[bytes]:
    """Run the function ``main`` of a module in a process.

    Raises:
        OSError: none can be started.
    """
    return subprocess.Popen(
        [sys.executable, "-I", "-c", _BOOT, module, *sys.path],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        env={**os.environ, **dict.fromkeys(_THREADS, "1")},
    )
