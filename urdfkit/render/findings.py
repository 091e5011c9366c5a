"""An image of a robot whose parts with findings are coloured and labelled with the codes."""

from collections.abc import Mapping, Sequence

from urdfkit.core.grouping import by_key
from urdfkit.core.spatial import Transform
from urdfkit.lint.context import Context
from urdfkit.render import primitives
from urdfkit.render.layers import BALL_RADIUS, extent, middle, overlay
from urdfkit.render.scene import Label, Scene, SceneItem
from urdfkit.robot.element_lookup import ElementLookup
from urdfkit.ros.surface_materials import PLACEHOLDER, Colour, SurfaceMaterial
from urdfkit.text.diagnostic import Diagnostic, Severity

COLOURS: Mapping[Severity, Colour] = {
    Severity.ERROR: (0.87, 0.13, 0.13, 1.0),
    Severity.WARNING: (1.0, 0.62, 0.05, 1.0),
}
_LEGEND = tuple((colour, severity.value) for severity, colour in COLOURS.items())
#: Colour of links without findings.
QUIET: Colour = (0.80, 0.82, 0.85, 1.0)
#: Most codes in the label of a link; further ones are counted.
MAX_CODES = 4


def marked(scene: Scene, context: Context, diagnostics: Sequence[Diagnostic]) -> Scene:
    """A scene in which links with errors are red and links with warnings are orange.

    A link without geometry is a ball at its origin; balls with the same text share a label.
    Findings that concern no link, such as findings in a macro, are omitted.
    """
    findings = {
        link: reported
        for link, reported in by_link(context, diagnostics).items()
        if link in scene.frames
    }
    items = tuple(
        item if item.material.overlay else _painted(item, findings.get(item.link, ()))
        for item in scene.items
    )
    drawn = {item.link for item in scene.items if not item.material.overlay}
    labels = [
        Label(_text(reported), link, middle(scene, link), of_link=True)
        for link, reported in findings.items()
        if link in drawn
    ]
    bare = by_key(
        (_text(reported), link) for link, reported in findings.items() if link not in drawn
    )
    for text, (link, *others) in bare.items():
        many = f"{len(others) + 1} links, " * bool(others)
        labels.append(Label(f"{text} ({many}no geometry)", link, (0.0, 0.0, 0.0)))
    ball = primitives.sphere(BALL_RADIUS * extent(scene))
    balls = (
        overlay(link, "findings", ball, Transform(), COLOURS[findings[link][0].severity])
        for links in bare.values()
        for link in links
    )
    return scene._replace(
        items=(*items, *balls), labels=(*scene.labels, *labels), legend=(*scene.legend, *_LEGEND)
    )


def by_link(context: Context, diagnostics: Sequence[Diagnostic]) -> dict[str, list[Diagnostic]]:
    """The errors and warnings of each link, the most severe first."""
    places = ElementLookup(context.model)
    findings: dict[str, list[Diagnostic]] = {}
    for diagnostic in sorted(diagnostics, key=lambda item: (item.severity.rank, item.code)):
        if diagnostic.severity in COLOURS:
            concerned = (places.link(call.element) for call in diagnostic.calls)
            for link in dict.fromkeys(name for name in concerned if name):
                findings.setdefault(link, []).append(diagnostic)
    return findings


def _painted(item: SceneItem, reported: Sequence[Diagnostic]) -> SceneItem:
    """An item in the colour of its most severe finding; a placeholder keeps its stripes."""
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
