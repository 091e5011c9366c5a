"""An image of a robot whose parts with findings are coloured and labelled with the codes."""

from collections.abc import Mapping, Sequence

from urdfkit.core.spatial import Transform
from urdfkit.lint.context import Context
from urdfkit.render import primitives
from urdfkit.render.layers import BALL, extent, middle, sign
from urdfkit.render.materials import PLACEHOLDER, Colour, SurfaceMaterial
from urdfkit.render.scene import Label, Scene, SceneItem
from urdfkit.robot.element_lookup import ElementLookup
from urdfkit.text.diagnostic import Diagnostic, Severity

COLOURS: Mapping[Severity, Colour] = {
    Severity.ERROR: (0.87, 0.13, 0.13, 1.0),
    Severity.WARNING: (1.0, 0.62, 0.05, 1.0),
}
_LEGEND = tuple((colour, severity.value) for severity, colour in COLOURS.items())
#: What has no findings steps back.
QUIET: Colour = (0.80, 0.82, 0.85, 1.0)
#: Codes in the label of a link; the rest is counted.
MAX_CODES = 4


def marked(scene: Scene, context: Context, diagnostics: Sequence[Diagnostic]) -> Scene:
    """A scene in which the links with errors are red and those with warnings orange.

    A link that shows nothing is a ball at its origin; the balls with one text have one label.
    Findings that concern no link, such as those about a macro, have no place in it.
    """
    found = {
        link: reported
        for link, reported in by_link(context, diagnostics).items()
        if link in scene.frames
    }
    items = tuple(
        item if item.material.overlay else _painted(item, found.get(item.link, ()))
        for item in scene.items
    )
    drawn = {item.link for item in scene.items if not item.material.overlay}
    labels = [
        Label(_text(reported), link, middle(scene, link), of_link=True)
        for link, reported in found.items()
        if link in drawn
    ]
    bare: dict[str, list[str]] = {}
    for link, reported in found.items():
        if link not in drawn:
            bare.setdefault(_text(reported), []).append(link)
    for text, (link, *others) in bare.items():
        many = f"{len(others) + 1} links, " * bool(others)
        labels.append(Label(f"{text} ({many}no geometry)", link, (0.0, 0.0, 0.0)))
    ball = primitives.sphere(BALL * extent(scene))
    balls = (
        sign(link, "findings", ball, Transform(), COLOURS[found[link][0].severity])
        for links in bare.values()
        for link in links
    )
    return scene._replace(
        items=(*items, *balls),
        labels=(*scene.labels, *labels),
        legend=(*scene.legend, *_LEGEND),
    )


def by_link(context: Context, diagnostics: Sequence[Diagnostic]) -> dict[str, list[Diagnostic]]:
    """The errors and warnings that concern each link, the worst first."""
    places = ElementLookup(context.model)
    found: dict[str, list[Diagnostic]] = {}
    for diagnostic in sorted(diagnostics, key=lambda one: (one.severity.rank, one.code)):
        if diagnostic.severity in COLOURS:
            concerned = (places.link(call.element) for call in diagnostic.calls)
            for link in dict.fromkeys(name for name in concerned if name):
                found.setdefault(link, []).append(diagnostic)
    return found


def _painted(item: SceneItem, reported: Sequence[Diagnostic]) -> SceneItem:
    """An item in the colour of its worst finding; of a missing mesh, with its stripes."""
    alpha = item.material.rgba[3]
    if not reported:
        return item._replace(material=SurfaceMaterial((*QUIET[:3], alpha)), colors=None)
    colour = COLOURS[reported[0].severity]
    texture = item.material.texture if item.material == PLACEHOLDER else None
    return item._replace(material=SurfaceMaterial((*colour[:3], alpha), texture), colors=None)


def _text(reported: Sequence[Diagnostic]) -> str:
    codes = list(dict.fromkeys(diagnostic.code for diagnostic in reported))
    rest = len(codes) - MAX_CODES
    return " ".join(codes[:MAX_CODES]) + (f" +{rest}" if rest > 0 else "")
