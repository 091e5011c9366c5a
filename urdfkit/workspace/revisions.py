"""Files as they were in a git revision."""

import os
import subprocess

from urdfkit.errors import UrdfkitError
from urdfkit.workspace import ignore_files

#: Larger files are meshes, pictures and recordings, which say little about the model itself.
MAX_BYTES = 8 * 1024 * 1024

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

    with scratch() as beside:
        index = os.path.join(beside, "index")
        _git(top, "read-tree", commit, index=index)
        prefix = f"--prefix={os.path.join(directory, '')}"
        _git(top, "checkout-index", "-z", "--stdin", prefix, index=index, given=names)
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
        _git(_directory(path), "check-ignore", "-q", "--", os.path.abspath(path))
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
    """True of a file, or a link to one, of an entry of ls-tree that is not too large."""
    fields = entry.partition(b"\t")[0].split()
    return len(fields) == 4 and fields[1] == b"blob" and int(fields[3]) <= largest


def _name(entry: bytes) -> bytes:
    return entry.partition(b"\t")[2]


def _git(directory: str, *words: str, index: str = "", given: bytes = b"") -> bytes:
    """The output of git in a directory, whatever repository a hook around us is of."""
    environment = {name: value for name, value in os.environ.items() if name not in _OF_A_HOOK}
    if index:
        environment |= {"GIT_INDEX_FILE": index, "GIT_LFS_SKIP_SMUDGE": "1"}
    # A repository that was unpacked may have a .git/config of its author, which names a program.
    command = ["git", "-c", "core.fsmonitor=false", "-C", directory, *words]
    try:
        done = subprocess.run(
            command, check=True, capture_output=True, env=environment, input=given
        )
    except FileNotFoundError as error:
        raise UrdfkitError("git is not installed") from error
    except (OSError, ValueError) as error:  # no permission; a NUL in a name
        raise UrdfkitError(f"git cannot be run: {error}") from error
    except subprocess.CalledProcessError as error:
        text = error.stderr.decode(errors="replace").strip()
        raise UrdfkitError(f"git {words[0]}: {text}") from error
    return done.stdout
