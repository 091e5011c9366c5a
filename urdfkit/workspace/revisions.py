"""Files of git revisions, by running git."""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Mapping
from contextlib import suppress

from urdfkit.core import disk
from urdfkit.core.regular_file import opened
from urdfkit.errors import UrdfkitError

#: Larger files are meshes, images and recordings, which are not needed to compare models.
MAX_BYTES = 8 * 1024 * 1024

#: A Git LFS pointer, with the parts of the path of its object.
_POINTER = re.compile(
    rb"version https://git-lfs\.github\.com/spec/v1\n"
    rb"oid sha256:(([0-9a-f]{2})([0-9a-f]{2})[0-9a-f]{60})\nsize \d+\n"
)
#: Size in bytes above which no file is a pointer.
_MAX_POINTER = 200

#: Seconds until git is terminated: a pipe in place of one of its files blocks it forever.
MAX_SECONDS = 60.0
MAX_SECONDS_IGNORED = 5.0

_HOOK_VARIABLES = frozenset(("GIT_DIR", "GIT_INDEX_FILE", "GIT_PREFIX", "GIT_WORK_TREE"))


def check_out(path: str, revision: str, directory: str, largest: int = MAX_BYTES) -> str:
    """Write the files of a revision into a directory, those of Git LFS if they have been fetched.

    Neither the working tree nor the index of the repository is changed.

    Args:
        path: of a file in the repository, which may be deleted.
        revision: a tag, branch or commit.
        largest: larger files are omitted, in bytes.

    Returns:
        The top directory of the repository.

    Raises:
        UrdfkitError: the path is not in a repository, the revision does not exist, or git is not
            installed.
    """
    top = _top(path)
    commit = _commit(top, revision)
    tree = _git(top, "ls-tree", "-r", "-l", "-z", commit)
    entries = (entry for entry in tree.split(b"\0") if _is_included(entry, largest))
    names = [entry.partition(b"\t")[2] for entry in entries]
    from urdfkit.core.temporary import scratch  # not needed to list ignored files

    objects = _git(top, "rev-parse", "--git-path", "objects")
    with scratch() as empty:
        # A new repository has no filters and hooks, which git would run; an untrusted one may.
        _git(empty, "init", "-q", "--template=")
        own = {
            "GIT_DIR": os.path.join(empty, ".git"),
            "GIT_OBJECT_DIRECTORY": os.path.join(top, os.fsdecode(objects.rstrip(b"\n"))),
            "GIT_LFS_SKIP_SMUDGE": "1",
        }
        _git(empty, "read-tree", commit, variables=own)
        prefix = f"--prefix={os.path.join(directory, '')}"
        words = ("checkout-index", "-z", "--stdin", prefix)
        _git(empty, *words, variables=own, stdin=b"\0".join(names))
    common = os.fsdecode(_git(top, "rev-parse", "--git-common-dir").rstrip(b"\n"))
    store = os.path.join(top, common, "lfs", "objects")
    for name in names if os.path.isdir(store) else ():
        _replace_pointer(os.path.join(directory, os.fsdecode(name)), store, largest)
    return top


def _replace_pointer(path: str, store: str, largest: int) -> None:
    """Replace a Git LFS pointer by its object, if that is in the store."""
    if os.path.islink(path) or not os.path.isfile(path) or os.path.getsize(path) > _MAX_POINTER:
        return
    with open(path, "rb") as file:
        pointer = _POINTER.fullmatch(file.read())
    if pointer is None:
        return
    oid, *directories = map(bytes.decode, pointer.groups())
    with suppress(OSError), opened(os.path.join(store, *directories, oid)) as stored:
        data = stored.read(largest + 1)
        if len(data) <= largest:
            with open(path, "wb") as file:
                file.write(data)


def locate(path: str, revision: str) -> str:
    """Path of a file of a revision in the current working tree, where it may be deleted.

    Args:
        path: relative to the current directory, or to the top of the repository as in git.
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


def check_ignore(path: str) -> bool:
    """True if git ignores a file; False outside of repositories or without git."""
    try:
        words = ("check-ignore", "-q", "--", os.path.abspath(path))
        _git(_directory(path), *words, seconds=MAX_SECONDS_IGNORED)
    except UrdfkitError as error:
        if getattr(error.__cause__, "returncode", None) != 1:
            disk.depends_on_more()  # git is missing, fails, or rejects the repository
        return False
    return True


def _directory(path: str) -> str:
    """The nearest existing parent directory of a path."""
    directory = os.path.dirname(os.path.abspath(path))
    while not os.path.isdir(directory):
        directory = os.path.dirname(directory)
    return directory


def _top(path: str) -> str:
    """The top directory of the repository of a path."""
    top = _git(_directory(path), "rev-parse", "--show-toplevel")
    return os.path.realpath(os.fsdecode(top.rstrip(b"\n")))


def _commit(top: str, revision: str) -> str:
    words = ("rev-parse", "--verify", "--end-of-options", f"{revision}^{{commit}}")
    try:
        return _git(top, *words).decode().strip()
    except UrdfkitError as error:
        raise UrdfkitError(f"no git revision '{revision}' in {top}") from error


def _is_included(entry: bytes, largest: int) -> bool:
    """True if an entry of ls-tree is a file or a link, and not too large."""
    fields = entry.partition(b"\t")[0].split()
    if len(fields) != 4 or fields[1] != b"blob":
        return False
    # The size of an object that is missing in a partial clone is "BAD"; git reports its name later.
    return not fields[3].isdigit() or int(fields[3]) <= largest


def _git(
    directory: str,
    *words: str,
    variables: Mapping[str, str] | None = None,
    stdin: bytes = b"",
    seconds: float = MAX_SECONDS,
) -> bytes:
    """Output of git, run in a directory, without the variables of a hook that runs urdfkit.

    The configuration of an untrusted repository may name programs: a file system monitor, or the
    remote from which git fetches missing objects. They are not run.
    """
    environment = {name: value for name, value in os.environ.items() if name not in _HOOK_VARIABLES}
    environment |= {"GIT_ALLOW_PROTOCOL": "", **(variables or {})}
    command = ["git", "-c", "core.fsmonitor=false", "-C", directory, *words]
    try:
        process = subprocess.run(
            command, check=True, capture_output=True, env=environment, input=stdin, timeout=seconds
        )
    except FileNotFoundError as error:
        raise UrdfkitError("git is not installed") from error
    except (OSError, ValueError) as error:  # permission denied; a NUL in a name
        raise UrdfkitError(f"git cannot be run: {error}") from error
    except subprocess.TimeoutExpired as error:
        raise UrdfkitError(f"git {words[0]} takes more than {seconds:g} s") from error
    except subprocess.CalledProcessError as error:
        text = error.stderr.decode(errors="replace").strip()
        raise UrdfkitError(f"git {words[0]}: {text}") from error
    return process.stdout
