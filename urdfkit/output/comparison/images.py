"""Images of both states of a robot from the same camera, with differences coloured."""

from urdfkit.errors import MissingLibrary
from urdfkit.lint.context import Context
from urdfkit.output.comparison import Comparison
from urdfkit.output.report import data_uris

SIZE = (800, 600)

_GONE, _NEW, _CHANGED = (0.86, 0.15, 0.12, 1.0), (0.16, 0.62, 0.3, 1.0), (0.96, 0.68, 0.1, 1.0)
_SAME = (0.8, 0.82, 0.85, 1.0)


def images(before: Context, after: Context, compared: Comparison) -> tuple[str, ...]:
    """URIs of two images; empty if the required libraries or the shapes are missing.

    Removed links are red, added links green, and changed or moved links amber.
    """
    try:
        import numpy as np
        from PIL import Image

        from urdfkit import render
    except (ImportError, MissingLibrary):
        return ()
    scenes = [render.build(context) for context in (before, after)]
    if not all(scene.items for scene in scenes):
        return ()
    camera = render.place_camera(np.concatenate([scene.points() for scene in scenes]), size=SIZE)
    colours = _colours(compared, after)
    renamed = compared.names.links
    both = {renamed.get(name, name) for name in scenes[0].frames} & scenes[1].frames.keys()
    addresses = []
    for scene, only, names in ((scenes[0], _GONE, renamed), (scenes[1], _NEW, {})):
        items = []
        for item in scene.items:
            name = names.get(item.link, item.link)
            material = render.SurfaceMaterial(colours.get(name, _SAME) if name in both else only)
            items.append(item._replace(material=material, colors=None, uv=None))
        image = render.draw(scene._replace(items=tuple(items)), camera)
        addresses.append(data_uris.webp(Image.fromarray(image).convert("RGB")))
    return tuple(addresses)


def _colours(compared: Comparison, after: Context) -> dict[str, tuple[float, float, float, float]]:
    """Colours of changed links; a change of a joint counts for its child link."""
    children = {joint.name: joint.child_name for joint in after.model.joints}
    names = {moved.link for moved in compared.moved}
    for change in compared.differences:
        names.add(change.name if change.what == "link" else children.get(change.name, ""))
    return dict.fromkeys(names, _CHANGED)
