"""COLLADA materials: from ``<material>`` through ``<effect>`` to colour and texture."""

import os
from typing import NamedTuple

import numpy as np

from urdfkit.mesh.geometry import MeshMaterial
from urdfkit.mesh.io.assemble import LostData
from urdfkit.mesh.io.collada_tree import ColladaTree, Element, child, children, tag, text
from urdfkit.mesh.io.numbers import floats
from urdfkit.mesh.io.referenced_files import ReferencedFiles

Colour = tuple[float, float, float, float]

_SHADERS = ("phong", "blinn", "lambert", "constant")
#: Weights of RGB; COLLADA 1.4.1, chapter 7, "Determining Transparency".
_LUMINANCE = (0.212671, 0.715160, 0.072169)
_DEFAULT = MeshMaterial()


class ColladaMaterial(NamedTuple):
    """A material, and the name of its texture coordinates."""

    material: MeshMaterial
    coordinates: str = ""


class ColladaMaterials:
    """The materials of one file."""

    def __init__(self, tree: ColladaTree, files: ReferencedFiles, losses: LostData) -> None:
        self._tree = tree
        self._files = files
        self._losses = losses
        self._cache: dict[Element, ColladaMaterial] = {}

    def material(self, reference: str) -> ColladaMaterial | None:
        """The material that ``#id`` refers to; None if it does not exist."""
        material = self._tree.named(reference, "material")
        if material is None:
            return None
        if material not in self._cache:
            self._cache[material] = self._read(material)
        return self._cache[material]

    def _read(self, material: Element) -> ColladaMaterial:
        name = material.get("name") or material.get("id", "")
        instance = child(material, "instance_effect")
        effect = self._tree.named(instance.get("url") if instance is not None else "", "effect")
        profile = child(effect, "profile_COMMON")
        technique = child(profile, "technique")
        shader = next(children(technique, *_SHADERS), None)
        if shader is None:
            self._losses.add("material* without a readable effect")
            return ColladaMaterial(MeshMaterial(name))
        base = child(shader, "emission" if tag(shader) == "constant" else "diffuse")
        rgba = self._colour(base) or _DEFAULT.rgba
        texture = child(base, "texture")
        if texture is None:
            opacity = self._opacity(shader, rgba[3])
            return ColladaMaterial(MeshMaterial(name, (*rgba[:3], opacity)))
        image = self._image(texture.get("texture", ""), effect)
        path = self._files.image(image) if image else None
        rgb = (1.0, 1.0, 1.0) if path else _DEFAULT.rgba[:3]
        result = MeshMaterial(name, (*rgb, self._opacity(shader, 1.0)), path)
        return ColladaMaterial(result, texture.get("texcoord", ""))

    def _colour(self, element: Element | None) -> Colour | None:
        """The ``<color>`` in an element; None if it is missing or invalid."""
        color = child(element, "color")
        if color is None:
            return None
        numbers = floats(text(color))[:4]
        if len(numbers) < 3 or not np.isfinite(numbers).all():
            self._losses.add(f"colour* that cannot be read ('{text(color)[:40]}')")
            return None
        red, green, blue, *alpha = (float(value) for value in np.clip(numbers, 0, 1))
        return (red, green, blue, alpha[0] if alpha else 1.0)

    def _opacity(self, shader: Element, alpha: float) -> float:
        """Opacity from ``<transparent>``, its mode, and ``<transparency>``.

        Args:
            alpha: alpha of the colour, the default.
        """
        transparent = child(shader, "transparent")
        number = floats(text(child(shader, "transparency", "float")))
        factor = float(number[0]) if len(number) and np.isfinite(number[0]) else 1.0
        if transparent is None or child(transparent, "color") is None:
            return alpha  # without a colour, its mode is ambiguous: 1 may be opaque or transparent
        colour = self._colour(transparent) or (1.0, 1.0, 1.0, 1.0)
        mode = transparent.get("opaque", "A_ONE")
        if mode.startswith("RGB"):
            part = sum(weight * value for weight, value in zip(_LUMINANCE, colour, strict=False))
        else:
            part = colour[3]
        opacity = part * factor
        if mode == "A_ONE" and opacity == 0:
            # Assimp before 4, MeshLab, SketchUp 7 and Blender 2.49 write the transparency here: the
            # shapes of all 39 such files of public robots are opaque (assimp/assimp#1080).
            return alpha
        return min(max(1 - opacity if mode.endswith("ZERO") else opacity, 0.0), 1.0)

    def _image(self, sampler: str, effect: Element | None) -> str:
        """The file name of the image that a texture samples, as written."""
        parameters = {
            param.get("sid", ""): param
            for profile in children(effect, "profile_COMMON")
            for holder in (profile, *children(profile, "technique"))
            for param in children(holder, "newparam")
        }
        parameters |= {param.get("sid", ""): param for param in children(effect, "newparam")}
        identity = sampler
        surface = text(child(parameters.get(identity), "sampler2D", "source")) or identity
        identity = text(child(parameters.get(surface), "surface", "init_from")) or surface
        instance = child(parameters.get(sampler), "sampler2D", "instance_image")  # COLLADA 1.5
        reference = instance.get("url", "")[1:] if instance is not None else identity
        image = self._tree.named(f"#{reference}", "image")
        if image is None and reference != sampler:
            # If the library has no such image, assimp, the reader of RViz and Gazebo, uses the
            # reference as the name of a JPEG file.
            return reference if os.path.splitext(reference)[1] else f"{reference}.jpg"
        source = child(image, "init_from")
        return text(child(source, "ref")) or text(source)
