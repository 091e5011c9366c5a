"""The command line; everything it does is also available in the library.

A command parses its options, makes one call of the library, renders the result, and returns an exit
code:

- 0: clean, or done
- 1: findings at or above ``--fail-on``
- 2: usage or input error
- 3: internal error (a bug in urdfkit)
- 130: stopped by Ctrl-C

Results go to standard output, everything else to standard error.
"""

from __future__ import annotations

import gc
import os
import sys
from errno import ENOSPC

from urdfkit.errors import UrdfkitError

TYPE_CHECKING = False

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import NoReturn

#: Commands that run in a process of their own, with limits (`urdfkit.cli.own_process`).
COMPUTING = frozenset(
    (
        "bundle collisions convert diff inertia info kinematics mass mesh render report simulate "
        "statics"
    ).split()
)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command line and return its exit code.

    Args:
        arguments: without the program name; the arguments of the process if None.
    """
    if arguments is not None:
        return guarded(_run, list(arguments))
    # The process ends after one command: garbage collection is useless, and tearing down all
    # objects at the end would take 8 of 120 ms.
    gc.set_threshold(100_000)
    # Processes that multiprocessing starts must not import from the current directory.
    os.environ["PYTHONSAFEPATH"] = "1"
    # With limited memory, OpenBLAS with threads retries allocations for ever.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    # MuJoCo's renderer, which takes 0.07 s to load, is not used.
    os.environ.setdefault("MUJOCO_GL", "disabled")
    if os.name == "nt" and sys.stderr is not None and sys.stderr.isatty():
        os.system("")  # a console of Windows then understands escape sequences
    words = sys.argv[1:]
    if words and words[0] in COMPUTING and hasattr(os, "fork"):
        from urdfkit.cli.own_process import run_forked

        return _leave(guarded(lambda each: run_forked(lambda: guarded(_run, each), _leave), words))
    return _leave(guarded(_replay_or_run, words))


def _leave(code: int) -> NoReturn:
    """End the process at once, without cleaning up."""
    for stream in (sys.stdout, sys.stderr):
        try:
            if stream is not None:
                stream.flush()
        except OSError:
            pass  # the reader closed it
    os._exit(code)


def guarded(run: Callable[[list[str]], int], words: list[str]) -> int:
    """Run a command line; reports exceptions and returns the exit code."""
    try:
        _reject_files_as_options(words)
        return run(words)
    except UrdfkitError as error:
        return fail(2, _no_memory() if _is_import_without_memory(error) else str(error))
    except KeyboardInterrupt:
        return 130
    except BrokenPipeError:
        return 2  # standard error was closed; a closed standard output is not an error
    except Exception as error:
        if getattr(error, "errno", None) == ENOSPC:
            return fail(2, os.strerror(ENOSPC))
        if isinstance(error, FileNotFoundError) and _is_directory_removed():
            return fail(2, "the current directory has been removed")
        if _lacks_memory(error):
            return fail(2, _no_memory())
        if os.environ.get("URDFKIT_DEBUG") == "1":
            import traceback

            traceback.print_exc()
        return fail(
            3,
            f"internal error: {type(error).__name__}: {error}",
            "This is a bug in urdfkit, not in the robot. Please report it with the file; "
            "URDFKIT_DEBUG=1 prints the traceback.",
        )


def _reject_files_as_options(words: list[str]) -> None:
    """Reject files with names such as ``--config=a.yaml``, which shells or hooks may pass."""
    for word in words[: words.index("--")] if "--" in words else words:
        if word.startswith("-") and word != "-" and os.path.lexists(word):
            raise UrdfkitError(f"'{word}' is a file, not an option; write ./{word}")


def _replay_or_run(words: list[str]) -> int:
    """Replay the cached result of an earlier check if nothing has changed since; otherwise run."""
    from urdfkit.cli import result_cache

    code = result_cache.replay(words)
    if code is not None:
        return code
    if "--simulate" in words and hasattr(os, "fork"):
        from urdfkit.cli.own_process import run_forked

        return run_forked(lambda: guarded(_record_and_run, words), _leave)
    return _record_and_run(words)


def _record_and_run(words: list[str]) -> int:
    from urdfkit.cli import result_cache

    if key := result_cache.cache_key(words):
        from urdfkit.cli import result_recording

        result_recording.begin(key)
    return _run(words)


def _run(words: list[str]) -> int:
    from urdfkit.cli import output, quick
    from urdfkit.cli.options import COLOR

    values = quick.parse(words)
    output.use_color(values.pop(COLOR.key) if values else "auto")
    if values is None:
        from urdfkit.cli.group import run

        return run(words)
    from urdfkit.cli.checking import run_check

    return run_check(values)


def _is_import_without_memory(error: UrdfkitError) -> bool:
    """True for an installed library that cannot be imported for lack of memory."""
    cause: BaseException | None = error
    while cause is not None and type(cause) is not ImportError:
        cause = cause.__cause__
    return cause is not None and _lacks_memory(error)


def _is_directory_removed() -> bool:
    """True if the current directory does not exist any more."""
    try:
        os.getcwd()
    except FileNotFoundError:
        return True
    return False


def _lacks_memory(error: Exception) -> bool:
    from urdfkit.core import limits

    return limits.lacks_memory(error)


def _no_memory() -> str:
    from urdfkit.core import limits

    more = "; --memory raises the limit" if limits.is_answering() else ""
    return f"not enough memory{more}"


def fail(code: int, error: str, *more: str) -> int:
    """Print an error on standard error, and return the exit code."""
    from urdfkit.cli import output

    try:
        output.log(f"error: {error}", *more)
    except OSError:
        pass  # standard error is closed
    return code
