"""Images of robots, without a display, a graphics card or a graphics library.

>>> from urdfkit.lint.loading import read
>>> from urdfkit.render import build, render_image
>>> scene = build(read("models/good/gripper.urdf"))
>>> render_image(scene, ["iso", "top"], size=(640, 360)).size
(640, 360)

`build` converts a robot to a `Scene` of triangles, and `render_image` renders it; `place_camera`
returns a `Camera` that views a scene, and `draw` returns the pixels of its image.
"""

from urdfkit.core.installation import needing

with needing("rendering", "render"):
    from urdfkit.render.animation import (
        animated,
        animation_format,
        followed,
        orbit,
        save_animation,
        sweep,
        swept_circle,
    )
    from urdfkit.render.camera import VIEWS, Camera, CameraOptions, place_camera
    from urdfkit.render.difference import difference
    from urdfkit.render.draw import QUALITIES, DrawingOptions, draw
    from urdfkit.render.findings import marked
    from urdfkit.render.fonts import unwritable
    from urdfkit.render.image import ImageError, colour, render_image, save
    from urdfkit.render.layers import LAYERS, with_layers
    from urdfkit.render.pixels import STUDIO, Background
    from urdfkit.render.scene import Label, MissingMesh, Scene, SceneItem, build
    from urdfkit.ros.surface_materials import SurfaceMaterial

__all__ = [
    "LAYERS",
    "QUALITIES",
    "STUDIO",
    "VIEWS",
    "Background",
    "Camera",
    "CameraOptions",
    "DrawingOptions",
    "ImageError",
    "Label",
    "MissingMesh",
    "Scene",
    "SceneItem",
    "SurfaceMaterial",
    "animated",
    "animation_format",
    "build",
    "colour",
    "difference",
    "draw",
    "followed",
    "marked",
    "orbit",
    "place_camera",
    "render_image",
    "save",
    "save_animation",
    "sweep",
    "swept_circle",
    "unwritable",
    "with_layers",
]
