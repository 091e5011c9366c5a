"""Images of models: usual formats are read, others run no program."""

import io
import shutil
import warnings
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from urdfkit.mesh.texture_image import FORMATS, opened

EPS = b"""%!PS-Adobe-3.0 EPSF-3.0
%%BoundingBox: 0 0 4 4
%%EndComments
showpage
%%EOF
"""


@pytest.mark.parametrize("format", FORMATS)
def test_formats_of_textures(format: str) -> None:
    file = io.BytesIO()
    Image.new("RGB", (4, 2), (255, 0, 0)).save(file, format)
    with opened(file.getvalue()) as image:
        assert image.size == (4, 2)
        colour = np.asarray(image.convert("RGB"))[1, 1]
    assert np.abs(colour.astype(int) - (255, 0, 0)).max() < 5


def test_postscript_starts_no_program(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ran = tmp_path / "ran"
    program = tmp_path / "gs"
    program.write_text(f"#!/bin/sh\ntouch {ran}\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    assert shutil.which("gs") == str(program)
    with pytest.raises(ValueError, match="cannot identify"), opened(EPS) as image:
        image.load()
    assert not ran.exists()


@pytest.mark.parametrize("cut", [12, 60, 100])
def test_a_damaged_image_warns_of_nothing(cut: int) -> None:
    file = io.BytesIO()
    Image.new("RGB", (64, 64), (0, 90, 0)).save(file, "TIFF")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(ValueError, match=r"."), opened(file.getvalue()[:cut]) as image:
            image.load()
