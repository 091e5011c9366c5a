"""Where the tests find what they need."""

from __future__ import annotations

from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
MODELS = ROOT / "models"

#: Real robots and the mission's text lie beside the checkout, not in it.
SHARED = ROOT.parent / "shared"
CORPUS = SHARED / "corpus"
SEED = SHARED / "seeds" / "000_aa3f46a524d8a61f.txt"

needs_shared = pytest.mark.skipif(
    not SHARED.is_dir(), reason="no folder 'shared' beside the checkout"
)


@pytest.fixture(scope="session")
def shared() -> Path:
    """The folder beside the checkout; skips the test where there is none."""
    if not SHARED.is_dir():
        pytest.skip("no folder 'shared' beside the checkout")
    return SHARED


@pytest.fixture(scope="session")
def corpus(shared: Path) -> Path:
    """The real robots."""
    return shared / "corpus"
