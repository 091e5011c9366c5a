"""What the tests share: the folder of real robots beside the checkout, if it is there."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

#: Reference material beside the checkout; not part of the project.
SHARED = Path(__file__).resolve().parents[1].parent / "shared"
CORPUS = SHARED / "corpus"

needs_corpus = pytest.mark.skipif(
    not CORPUS.is_dir(), reason="the corpus of real robots is not beside this checkout"
)


def manifest() -> Iterator[tuple[Path, dict[str, Any]]]:
    """The folder of its repository and the facts of every model of the corpus.

    Nothing where the corpus is absent: a test parametrised with it is then skipped.
    """
    file = CORPUS / "MANIFEST.json"
    if not file.is_file():
        return
    for repository in json.loads(file.read_text(encoding="utf-8"))["repos"]:
        for model in repository["models"]:
            yield CORPUS / repository["dir"], model


def model_id(entry: object) -> str | None:
    """A readable name for a manifest entry in a parametrised test."""
    if not isinstance(entry, tuple):
        return None
    folder, model = entry
    return " ".join([f"{folder.name}/{model['path']}", *model["xacro_args"]])


@pytest.fixture
def corpus() -> Path:
    """The folder of real robots; the test is skipped where it is absent."""
    if not CORPUS.is_dir():
        pytest.skip("the corpus of real robots is not beside this checkout")
    return CORPUS
