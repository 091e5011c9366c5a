"""Images that meshes use as textures, read by Pillow."""

import io
import warnings
from collections.abc import Iterator
from contextlib import contextmanager

from PIL import Image

#: Pillow reads more formats; a model must not make it start Ghostscript for PostScript.
FORMATS = ("PNG", "JPEG", "BMP", "GIF", "TIFF", "TGA", "WEBP", "DDS")


@contextmanager
def opened(data: bytes) -> Iterator[Image.Image]:
    """The image in a file; its pixels are decoded when they are needed.

    Raises:
        ValueError: the file is not a readable image of these formats, or too large for a texture.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # about damaged files, which the error reports
            with Image.open(io.BytesIO(data), formats=FORMATS) as image:
                yield image
    except (OSError, SyntaxError, EOFError, Image.DecompressionBombError) as error:
        raise ValueError(str(error)) from error
