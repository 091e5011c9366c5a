"""Text in pictures, in the font that comes with Pillow."""

from __future__ import annotations

from PIL import Image, ImageDraw, ImageFont

INK, PAPER = (42, 48, 58, 255), (255, 255, 255, 205)


def font(size: float) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    """The font at a size in pixels."""
    return ImageFont.load_default(size)


def caption(image: Image.Image, text: str) -> None:
    """Write a word in the upper left corner of a picture."""
    size = max(11, min(22, image.height // 22))
    ImageDraw.Draw(image).text((size * 0.7, size * 0.5), text, fill=INK, font=font(size))
