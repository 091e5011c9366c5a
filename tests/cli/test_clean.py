"""``urdfkit clean``, and what ``urdfkit doctor`` says of the cache."""

from pathlib import Path

import pytest

from tests.workspaces import add_files
from urdfkit.cli import main
from urdfkit.core.cache_directory import VARIABLE, cache_directory


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A cache of two entries, next to which somebody else keeps a file."""
    directory = tmp_path / "cache"
    monkeypatch.setenv(VARIABLE, str(directory))
    names = ("results/0", "meshes/v9/ab/cd.json", "notes.txt")
    add_files(directory, dict.fromkeys(names, bytes(300_000)))
    return directory


def test_clean_removes_only_entries(cache: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["clean"]) == 0
    assert capsys.readouterr().out == f"{cache}: 2 entries removed\n"
    assert [path.name for path in cache.rglob("*")] == ["notes.txt"]
    assert main(["clean"]) == 0


def test_doctor_shows_the_cache(cache: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(["doctor"])
    assert f"\ncache: {cache} (2 entries, 0.6 MB)\n" in capsys.readouterr().out


def test_no_cache(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, "")
    assert main(["clean"]) == 0
    main(["doctor"])
    out = capsys.readouterr().out
    assert "no cache: 0 entries removed\n" in out
    assert "\ncache: none\n" in out


@pytest.mark.parametrize(
    ("platform", "variables", "directory"),
    [
        ("linux", {}, "/home/a/.cache/urdfkit"),
        ("linux", {"XDG_CACHE_HOME": "/c"}, "/c/urdfkit"),
        ("linux", {"XDG_CACHE_HOME": "c"}, "/home/a/.cache/urdfkit"),
        ("linux", {"XDG_CACHE_HOME": "/c", VARIABLE: "/d"}, "/d"),
        ("linux", {VARIABLE: ""}, None),
        ("darwin", {}, "/home/a/Library/Caches/urdfkit"),
        ("win32", {"LOCALAPPDATA": "/l"}, "/l/urdfkit/Cache"),
    ],
)
def test_location_of_the_cache(
    platform: str, variables: dict[str, str], directory: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("XDG_CACHE_HOME", "LOCALAPPDATA", VARIABLE):
        monkeypatch.delenv(name, raising=False)
    for name, value in ({"HOME": "/home/a"} | variables).items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr("sys.platform", platform)
    assert cache_directory() == directory
