"""Shading of surfaces in the light of the studio."""

from typing import NamedTuple

import numpy as np

from urdfkit.render.arrays import Floats, dot, unit
from urdfkit.render.light import Rig

#: Light of the lamps, of the sky above and of the floor below; linear, red green blue.
SUN = np.array((1.02, 0.99, 0.94), dtype=np.float32)
FILL = np.array((0.12, 0.125, 0.135), dtype=np.float32)
SKY = np.array((0.50, 0.52, 0.55), dtype=np.float32)
FLOOR = np.array((0.27, 0.265, 0.26), dtype=np.float32)
#: Reflectance at normal incidence, and exponent of the highlight.
REFLECTANCE, SHININESS = 0.04, 42.0
#: Least albedo.
MIN_ALBEDO = 0.012
#: Brightness above which tones are compressed.
KNEE = 0.72


class Illumination(NamedTuple):
    """The light that reaches points of a surface."""

    sun: Floats  # (k,), visible part of the sun
    sky: Floats  # (k,), visible part of the sky


def shaded(
    albedo: Floats, position: Floats, normal: Floats, lit: Illumination, rig: Rig, *, parallel: bool
) -> Floats:
    """(k, 3), light from surfaces to the viewer, from 0 to 1.

    Args:
        albedo: (k, 3), linear.
        position: (k, 3), in the camera frame.
        normal: (k, 3), unit vectors in the camera frame.
        parallel: True if the image is orthographic.
    """
    if parallel:
        viewer = np.broadcast_to(np.array((0, 0, 1), dtype=np.float32), position.shape)
    else:
        viewer = unit(-position)
    sun = np.maximum(dot(normal, rig.sun), 0) * lit.sun
    fill = np.maximum(dot(normal, rig.fill), 0) * lit.sky
    upwards = dot(normal, rig.up) * np.float32(0.5) + np.float32(0.5)
    ambient = (FLOOR + (SKY - FLOOR) * upwards[:, None]) * lit.sky[:, None]
    light = ambient + sun[:, None] * SUN + fill[:, None] * FILL
    colour = np.maximum(albedo, np.float32(MIN_ALBEDO)) * light

    facing = np.clip(dot(normal, viewer), 0, 1)
    grazing = np.float32(REFLECTANCE) + np.float32(1 - REFLECTANCE) * (1 - facing) ** 5
    halfway = unit(viewer + rig.sun)
    highlight = np.maximum(dot(normal, halfway), 0) ** np.float32(SHININESS)
    mirrored = dot(viewer, rig.up) * np.float32(-1) + 2 * facing * dot(normal, rig.up)
    above = np.clip(mirrored * np.float32(0.5) + np.float32(0.5), 0, 1)
    gloss = np.float32(0.16) * highlight * sun + np.float32(0.32) * grazing * above * lit.sky
    return tone(colour + gloss[:, None])


def tone(light: Floats) -> Floats:
    """Tone mapping to the range 0 to 1: linear below the knee, compressed above."""
    over = np.maximum(light - np.float32(KNEE), 0)
    headroom = np.float32(1 - KNEE)
    bent = np.float32(KNEE) + headroom * (over / (over + headroom))
    return np.where(light > KNEE, bent, light)
