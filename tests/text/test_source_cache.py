"""Results that are kept for many small files, and for few large ones."""

import pytest

from urdfkit.text.source import Source
from urdfkit.text.source_cache import cached_by_source


@pytest.mark.parametrize(("length", "count"), [(10, 100), (40_000, 200)])
def test_many_small_files_are_read_once(length: int, count: int) -> None:
    read: list[str] = []

    @cached_by_source
    def length_of(source: Source) -> int:
        read.append(source.path)
        return len(source.data)

    sources = [Source(f"{number}.yaml", b"a" * length) for number in range(100)]
    for source in (*sources, *sources):
        assert length_of(source) == length
    assert len(read) == count
