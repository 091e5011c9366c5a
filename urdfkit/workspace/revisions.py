"""Files as they were in a git revision."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Mapping

from urdfkit.errors import UrdfkitError
from urdfkit.workspace import ignore_files

#: Larger files are meshes, pictures and recordings, which say little about the model itself.
MAX_BYTES = 8 * 1024 * 1024

#: Seconds until git is ended: a pipe in place of one of its files blocks it for ever.
MAX_SECONDS = 60.0
MAX_SECONDS_IGNORED = 5.0

_OF_A_HOOK = frozenset(("GIT_DIR", "GIT_INDEX_FILE", "GIT_PREFIX", "GIT_WORK_TREE"))


def check_out(path: str, revision: str, directory: str, largest: int = MAX_BYTES) -> str:
    """Write the files of a revision of the repository around a path into a directory.

    Neither the working tree nor the index of the repository is touched.

    Args:
        path: of a file in the repository, that may be gone by now.
        revision: a tag, branch or commit.
        largest: files over so many bytes are left out.

    Returns:
        The top directory of the repository.

    Raises:
        UrdfkitError: the path is in no repository, there is no such revision, or git is not
            there.
    """
    top = _top(path)
    commit = _commit(top, revision)
    tree = _git(top, "ls-tree", "-r", "-l", "-z", commit)
    names = b"\0".join(_name(entry) for entry in tree.split(b"\0") if _is_wanted(entry, largest))
    from urdfkit.core.temporary import scratch  # not needed to list ignored files

    objects = _git(top, "rev-parse", "--git-path", "objects")
    with scratch() as empty:
        # A repository without the filters and hooks that the configuration of an unpacked one may
        # name: git would run them.
        _git(empty, "init", "-q", "--template=")
        own = {
            "GIT_DIR": os.path.join(empty, ".git"),
            "GIT_OBJECT_DIRECTORY": os.path.join(top, os.fsdecode(objects.rstrip(b"\n"))),
            "GIT_LFS_SKIP_SMUDGE": "1",
        }
        _git(empty, "read-tree", commit, variables=own)
        prefix = f"--prefix={os.path.join(directory, '')}"
        words = ("checkout-index", "-z", "--stdin", prefix)
        _git(empty, *words, variables=own, given=names)
    return top


def locate(path: str, revision: str) -> str:
    """Where a file of a revision is, or was, in the working tree around the current directory.

    Args:
        path: from the current directory, else from the top of the repository, as git counts.
        revision: a tag, branch or commit.

    Raises:
        UrdfkitError: it is not in the revision, or as for `check_out`.
    """
    top = _top("here")
    commit = _commit(top, revision)
    for base in (os.path.realpath(os.curdir), top):
        name = os.path.relpath(os.path.join(base, path), top).replace(os.sep, "/")
        try:
            _git(top, "cat-file", "-e", f"{commit}:{name}")
        except UrdfkitError:
            continue
        return os.path.join(top, name)
    raise UrdfkitError(f"no file '{path}' in revision '{revision}' of {top}")


def is_ignored(path: str) -> bool:
    """True if the repository around a file ignores it; not where there is none, or no git."""
    ignore_files.note(path)
    try:
        words = ("check-ignore", "-q", "--", os.path.abspath(path))
        _git(_directory(path), *words, seconds=MAX_SECONDS_IGNORED)
    except UrdfkitError:
        return False
    return True


def _directory(path: str) -> str:
    """The nearest directory around a path that exists."""
    where = os.path.dirname(os.path.abspath(path))
    while not os.path.isdir(where):
        where = os.path.dirname(where)
    return where


def _top(path: str) -> str:
    """The top directory of the repository around a path."""
    top = _git(_directory(path), "rev-parse", "--show-toplevel")
    return os.path.realpath(os.fsdecode(top.rstrip(b"\n")))


def _commit(top: str, revision: str) -> str:
    words = ("rev-parse", "--verify", "--end-of-options", f"{revision}^{{commit}}")
    try:
        return _git(top, *words).decode().strip()
    except UrdfkitError as error:
        raise UrdfkitError(f"no git revision '{revision}' in {top}") from error


def _is_wanted(entry: bytes, largest: int) -> bool:
    """True if an entry of ls-tree is a file or a link, and not too large."""
    fields = entry.partition(b"\t")[0].split()
    if len(fields) != 4 or fields[1] != b"blob":
        return False
    # The size of an object that a partial clone lacks is "BAD"; git then says which file it is.
    return not fields[3].isdigit() or int(fields[3]) <= largest


def _name(entry: bytes) -> bytes:
    return entry.partition(b"\t")[2]


def _git(
    directory: str,
    *words: str,
    variables: Mapping[str, str] | None = None,
    given: bytes = b"",
    seconds: float = MAX_SECONDS,
) -> bytes:
    """Output of git, run in a directory and not in the repository of a hook that called us.

    The configuration of an unpacked repository may name programs: of a monitor, or of a remote
    from which git fetches missing objects. Neither is run.
    """
    environment = {name: value for name, value in os.environ.items() if name not in _OF_A_HOOK}
    environment |= {"GIT_ALLOW_PROTOCOL": "", **(variables or {})}
    command = ["git", "-c", "core.fsmonitor=false", "-C", directory, *words]
    try:
        done = subprocess.run(
            command, check=True, capture_output=True, env=environment, input=given, timeout=seconds
        )
    except FileNotFoundError as error:
        raise UrdfkitError("git is not installed") from error
    except (OSError, ValueError) as error:  # no permission; a NUL in a name
        raise UrdfkitError(f"git cannot be run: {error}") from error
    except subprocess.TimeoutExpired as error:
        raise UrdfkitError(f"git {words[0]} takes more than {seconds:g} s") from error
    except subprocess.CalledProcessError as error:
        text = error.stderr.decode(errors="replace").strip()
        raise UrdfkitError(f"git {words[0]}: {text}") from error
    return done.stdout
