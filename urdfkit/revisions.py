"""Files as they were in a git revision."""

from __future__ import annotations

import os
import subprocess
import tempfile

from urdfkit.errors import UrdfkitError

#: Larger files are meshes, pictures and recordings, which say nothing about the model itself.
MAX_BYTES = 8 * 1024 * 1024

_OF_A_HOOK = frozenset(("GIT_DIR", "GIT_INDEX_FILE", "GIT_PREFIX", "GIT_WORK_TREE"))


def check_out(path: str, revision: str, folder: str) -> str:
    """Write the files of a revision of the repository around a path into a folder.

    Neither the working tree nor the index of the repository is touched.

    Returns:
        The top folder of the repository.

    Raises:
        UrdfkitError: the path is in no repository, there is no such revision, or git is not
            there.
    """
    where = os.path.dirname(os.path.abspath(path))
    top = os.path.realpath(_git(where, "rev-parse", "--show-toplevel").decode().rstrip("\n"))
    try:
        commit = _git(top, "rev-parse", "--verify", "--end-of-options", f"{revision}^{{commit}}")
    except UrdfkitError as error:
        raise UrdfkitError(f"there is no git revision '{revision}' in {top}") from error
    tree = _git(top, "ls-tree", "-r", "-l", "-z", commit.decode().strip())
    names = b"\0".join(map(_name, filter(_is_wanted, tree.split(b"\0"))))
    with tempfile.TemporaryDirectory() as scratch:
        index = os.path.join(scratch, "index")
        _git(top, "read-tree", commit.decode().strip(), index=index)
        prefix = f"--prefix={os.path.join(folder, '')}"
        _git(top, "checkout-index", "-z", "--stdin", prefix, index=index, given=names)
    return top


def _is_wanted(entry: bytes) -> bool:
    """True of a file, or a link to one, of an entry of ls-tree that is not too large."""
    fields = entry.partition(b"\t")[0].split()
    return len(fields) == 4 and fields[1] == b"blob" and int(fields[3]) <= MAX_BYTES


def _name(entry: bytes) -> bytes:
    return entry.partition(b"\t")[2]


def _git(folder: str, *words: str, index: str = "", given: bytes = b"") -> bytes:
    """The output of git in a folder, whatever repository a hook around us is of."""
    environment = {name: value for name, value in os.environ.items() if name not in _OF_A_HOOK}
    if index:
        environment |= {"GIT_INDEX_FILE": index, "GIT_LFS_SKIP_SMUDGE": "1"}
    command = ["git", "-C", folder, *words]
    try:
        done = subprocess.run(
            command, check=True, capture_output=True, env=environment, input=given
        )
    except FileNotFoundError as error:
        raise UrdfkitError("git is not installed") from error
    except subprocess.CalledProcessError as error:
        text = error.stderr.decode(errors="replace").strip()
        raise UrdfkitError(f"git {words[0]}: {text}") from error
    return done.stdout
