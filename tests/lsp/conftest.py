from collections.abc import Callable, Iterator
from typing import Any

import pytest


@pytest.fixture(scope="module")
def held() -> Iterator[Callable[[Any], None]]:
    """One server for all conversations that ask nothing else of it."""
    from tests.lsp.editor import session  # needs pygls

    with session() as hold:
        yield hold
