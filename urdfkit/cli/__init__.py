"""The command line. It can do nothing that the library cannot.

A command parses its options, makes one call of the library, renders what comes back, and says
by its exit code how it went:

- 0: clean, or done
- 1: findings at or over ``--fail-on``
- 2: it cannot be done: a file is missing, an option is wrong
- 3: a bug in urdfkit
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
        arguments: without the name of the program; those of the process if None.
    """
    if arguments is not None:
        return guarded(_run, list(arguments))
    # This process does one thing and ends. Looking for garbage on the way finds none, and to take
    # everything apart at the end, before the system takes the memory back, is 8 of 120 ms.
    gc.set_threshold(100_000)
    # Processes that multiprocessing starts must not import from the current directory.
    os.environ["PYTHONSAFEPATH"] = "1"
    # Where memory is limited, OpenBLAS with threads never stops asking for more.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    words = sys.argv[1:]
    if words and words[0] in COMPUTING and hasattr(os, "fork"):
        from urdfkit.cli.own_process import run_apart

        return _leave(guarded(lambda each: run_apart(lambda: guarded(_run, each), _leave), words))
    return _leave(guarded(_replay_or_run, words))


def _leave(code: int) -> NoReturn:
    """End the process at once, without cleaning up."""
    for stream in (sys.stdout, sys.stderr):
        try:
            if stream is not None:
                stream.flush()
        except OSError:
            pass  # nobody reads it any more
    os._exit(code)


def guarded(run: Callable[[list[str]], int], words: list[str]) -> int:
    """Every way in which a command line can end, as an exit code."""
    try:
        _reject_files_as_options(words)
        return run(words)
    except UrdfkitError as error:
        return fail(2, _no_memory() if _is_import_in_vain(error) else str(error))
    except KeyboardInterrupt:
        return 130
    except BrokenPipeError:
        return 2  # of standard error; of standard output it is none
    except Exception as error:
        if getattr(error, "errno", None) == ENOSPC:
            return fail(2, os.strerror(ENOSPC))
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
    """A file may be called ``--config=a.yaml``; where a shell or a hook lists files, it is none."""
    for word in words[: words.index("--")] if "--" in words else words:
        if word.startswith("-") and word != "-" and os.path.lexists(word):
            raise UrdfkitError(f"'{word}' is a file and no option; write ./{word}")


def _replay_or_run(words: list[str]) -> int:
    """Repeat the result of an earlier check if nothing has changed since."""
    from urdfkit.cli import result_cache

    code = result_cache.replay(words)
    if code is not None:
        return code
    if asked := result_cache.question(words):
        from urdfkit.cli import result_recording

        result_recording.begin(asked)
    return _run(words)


def _run(words: list[str]) -> int:
    from urdfkit.cli import quick

    values = quick.parse(words)
    if values is None:
        from urdfkit.cli.group import run

        return run(words)
    from urdfkit.cli.checking import run_check

    return run_check(values)


def _is_import_in_vain(error: UrdfkitError) -> bool:
    """True for a library that is there, and has no room."""
    cause: BaseException | None = error
    while cause is not None and type(cause) is not ImportError:
        cause = cause.__cause__
    return cause is not None and _lacks_memory(error)


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
        output.tell(f"error: {error}", *more)
    except OSError:
        pass  # nobody reads it
    return code
