"""New texts for files: as diffs that ``patch`` applies, and written."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from urdfkit.editing.rewriting import Rewrite, write
from urdfkit.errors import UnwritableFile

CHANGES = {
    "plain": (b"<a>\n<b/>\n</a>\n", b"<a>\n<c/>\n</a>\n"),
    "no line end": (b"<a>\n<b/>\n</a>", b"<a>\n<c/>\n</a>\n"),
    "Windows": (b"<a>\r\n<b/>\r\n</a>\r\n", b"<a>\r\n<c/>\r\n</a>\r\n"),
    "other separators": (
        "<a>\n<!-- 1\u20282\x853\r4 -->\n<b/></a>\n".encode(),
        "<a>\n  <!-- 1\u20282\x853\r4 -->\n<c/></a>\n".encode(),
    ),
}


@pytest.mark.skipif(shutil.which("patch") is None, reason="it needs patch")
@pytest.mark.parametrize("name", CHANGES)
def test_patch_takes_the_diff(name: str, tmp_path: Path):
    before, after = CHANGES[name]
    file = tmp_path / "a.urdf"
    file.write_bytes(before)
    diff = Rewrite("a.urdf", before, after).diff()
    subprocess.run(
        ["patch", "-p0", "--binary", "-s"], input=diff.encode(), cwd=tmp_path, check=True
    )
    assert file.read_bytes() == after


def test_a_diff_is_text_whatever_the_encoding_of_the_file():
    before, after = ('<a b="\xe9"/>\n'.encode("utf-16"), '<a b="\xe8"/>\n'.encode("utf-16"))
    assert '-<a b="\xe9"/>\n+<a b="\xe8"/>\n' in Rewrite("a.urdf", before, after).diff()


def test_what_has_changed_meanwhile_stops_all(tmp_path: Path):
    files = [tmp_path / "a.urdf", tmp_path / "b.urdf"]
    for file in files:
        file.write_bytes(b"<a/>")
    rewrites = [Rewrite(str(file), b"<a/>", b"<b/>") for file in files]
    files[1].write_bytes(b"<c/>")
    with pytest.raises(UnwritableFile, match="it has changed meanwhile"):
        write(rewrites)
    assert [file.read_bytes() for file in files] == [b"<a/>", b"<c/>"]
