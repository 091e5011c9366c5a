"""Files that cannot be read: the reason and the fix."""

import os
from pathlib import Path

import pytest

from urdfkit.errors import UnreadableFile
from urdfkit.text.source import Source


@pytest.mark.parametrize(
    ("word", "reason"),
    [
        ("robt.urdf", "file not found; did you mean 'robot.urdf'?"),
        ("robot.xml", "file not found; did you mean 'robot.urdf'?"),
        ("missing.urdf", "file not found"),  # the suffix alone is no likeness
        ("none/robot.urdf", "no such directory '{}/none'"),
        ("", "is a directory; name a file in it"),
    ],
)
def test_a_missing_file_is_reported_with_the_one_that_was_meant(
    tmp_path: Path, word: str, reason: str
) -> None:
    for name in ("robot.urdf", "bin.urdf"):
        (tmp_path / name).touch()
    with pytest.raises(UnreadableFile) as caught:
        Source.read(tmp_path / word)
    assert str(caught.value) == f"{tmp_path / word}: {reason.format(tmp_path)}"


@pytest.mark.skipif(os.name == "nt", reason="links need a privilege on Windows")
def test_a_link_that_leads_back_to_itself(tmp_path: Path) -> None:
    loop = tmp_path / "loop.urdf"
    loop.symlink_to(loop)
    with pytest.raises(UnreadableFile, match="is a symbolic link to itself"):
        Source.read(loop)


@pytest.mark.skipif(os.name == "nt", reason="links need a privilege on Windows")
def test_a_link_to_a_file_that_does_not_exist(tmp_path: Path) -> None:
    """Of an install directory that was copied from another machine."""
    link = tmp_path / "robot.urdf"
    link.symlink_to(tmp_path / "gone.urdf")
    with pytest.raises(UnreadableFile) as caught:
        Source.read(link)
    target = tmp_path / "gone.urdf"
    assert str(caught.value) == f"{link}: is a symbolic link to '{target}', which does not exist"


def test_what_was_read_already_is_not_read_again() -> None:
    source = Source("gone.urdf", b"<robot/>")
    assert Source.of(source) is source
