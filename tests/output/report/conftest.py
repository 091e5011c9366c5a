from collections.abc import Iterator

import pytest

from tests.output.report.browsers import Page, browser


@pytest.fixture(scope="module")
def page() -> Iterator[Page]:
    with browser() as opened:
        yield opened
