"""The report as one HTML file that opens offline, from the templates in this package.

Jinja escapes all text from a robot. The page also has a content security policy: the browser
runs only scripts whose hashes the policy lists, and loads nothing from other sites.
"""

from __future__ import annotations

import base64
import hashlib
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from math import degrees, log10
from typing import TYPE_CHECKING, Any

from urdfkit import __version__
from urdfkit.core.grouping import by_key
from urdfkit.core.installation import needing
from urdfkit.output.report.document import ReportDocument
from urdfkit.output.report.translations import PLURALS, Translator
from urdfkit.robot.stability import VERDICTS
from urdfkit.text.terminal import printable

if TYPE_CHECKING:
    from jinja2 import Environment

    from urdfkit.output.report.engine import PageEngine
    from urdfkit.output.report.scene import PageScene

#: Most findings, and rows of a table, that a page shows; more make a browser slow.
MAX_FINDINGS, MAX_ROWS = 500, 400
#: Most links of a collision matrix.
MAX_MATRIX = 60

_DIRECTORY = os.path.join(os.path.dirname(__file__), "templates")
#: Scripts of the 3D view, in the order of their dependencies.
_SCENE = ("joints.js", "surfaces.js", "model.js", "overlays.js", "camera.js", "scene.js")
_SEVERITIES = ("error", "warning", "info")
_QUOTED = re.compile(r"'([^']*)'")


def render(
    document: ReportDocument,
    translator: Translator,
    drawings: Mapping[str, str],
    scene: PageScene | None = None,
    engine: PageEngine | None = None,
    *,
    shape: int = 0,
) -> str:
    """The page as HTML.

    Args:
        drawings: URIs of images, by name.
        scene: the robot in 3D; None for a page without a 3D view.
        shape: number of this robot in the viewer, which sends new contents to its page.

    Raises:
        UrdfkitError: Jinja is not installed.
    """
    environment = _environment()
    names = ["page.js", *(_SCENE if scene else ()), *(["live.js"] if shape else ())]
    scripts = [_read(name) for name in names]
    inline = [*scripts, *([engine.script] if engine else [])]
    return environment.get_template("live.html.j2" if shape else "report.html.j2").render(
        **_context(document, translator, drawings),
        style=_safe(_read("scene.css") + _read("page.css")),
        policy=_policy(inline, live=bool(shape)),
        shape=shape,
        scripts=[_safe(script) for script in scripts],
        words=_json(translator.known),
        scene=scene and {"robot": _json(scene.robot), "model": _safe(_base64(scene.model))},
        engine=engine and engine._replace(script=_safe(engine.script)),
    )


def render_plain(template: str, translator: Translator, **context: object) -> str:
    """A page without a 3D view, from another template.

    Args:
        context: variables of the template.
    """
    scripts = [_read("page.js")]
    return (
        _environment()
        .get_template(template)
        .render(
            **context,
            style=_safe(_read("page.css")),
            policy=_policy(scripts, live=False),
            scripts=[_safe(script) for script in scripts],
            version=__version__,
            words=_json(translator.known),
            _=translator,
        )
    )


def render_view(translator: Translator) -> str:
    """The elements that the scripts of the 3D view expect."""
    return _environment().get_template("scene.html.j2").render(_=translator)


def render_content(
    document: ReportDocument, translator: Translator, drawings: Mapping[str, str]
) -> str:
    """The contents about the robot, without the page around them."""
    context = _context(document, translator, drawings)
    return _environment().get_template("content.html.j2").render(context)


def _context(
    document: ReportDocument, translator: Translator, drawings: Mapping[str, str]
) -> dict[str, Any]:
    robot = document["robot"]
    name = robot["name"] if robot else ""
    findings = sorted(document["gathered"], key=lambda item: _SEVERITIES.index(item["severity"]))
    return {
        "document": document,
        "drawings": drawings,
        "_": translator,
        "title": printable(name or os.path.basename(document["file"])),
        "absent": _by_reason(document["missing"].items()),
        "skipped": _by_reason((item["code"], item["reason"]) for item in document["skipped"]),
        "groups": _groups(findings[:MAX_FINDINGS]),
        "more": max(0, len(findings) - MAX_FINDINGS),
        "rows": MAX_ROWS,
        "verdicts": VERDICTS,
        "plurals": PLURALS,
        "rejections": _rejections(document["gazebo"]),
        "matrix": _matrix(document["collisions"]),
        "colliding": _colliding(document["collisions"]),
        "sections": [
            (key, title)
            for key, title, there in (
                ("summary", "Summary", True),
                ("pictures", "Images", "views" in drawings),
                ("findings", "Findings", True),
                ("tree", "Kinematic tree", "tree" in drawings),
                ("masses", "Masses and inertias", document["links"]),
                ("joints", "Joints", document["joints"]),
                ("meshes", "Meshes", document["meshes"]),
                ("statics", "Statics", document["statics"] or document["standing"]),
                ("collisions", "Collisions", document["collisions"]),
                ("gazebo", "After URDF to SDF conversion", document["gazebo"]),
            )
            if there
        ],
    }


def _matrix(collisions: dict[str, Any] | None) -> list[tuple[str, list[dict[str, Any] | None]]]:
    """Lower half of the collision matrix, one row per link; empty if it is too large."""
    if not collisions or len(collisions["links"]) > MAX_MATRIX:
        return []
    pairs = {frozenset((pair["first"], pair["second"])): pair for pair in collisions["pairs"]}
    names = collisions["links"]
    return [
        (name, [pairs.get(frozenset((name, other))) for other in names[:number]])
        for number, name in enumerate(names)
    ]


def _colliding(collisions: dict[str, Any] | None) -> list[dict[str, Any]]:
    """Pairs of links that collide or nearly collide, the most frequent first."""
    pairs = [
        pair
        for pair in (collisions["pairs"] if collisions else ())
        if pair["near_miss"] or pair["verdict"] not in ("adjacent", "never")
    ]
    return sorted(pairs, key=lambda pair: -(pair["frequency"] or 0.0))


def _rejections(
    converted: dict[str, Any] | None,
) -> list[tuple[str, list[tuple[str, str, list[str]]]]]:
    """Reasons why each reader rejects the robot: messages with the codes of their rules.

    Messages that differ only in names are merged; the first name of each is listed.
    """
    readers: dict[str, dict[tuple[str, str], list[str]]] = {}
    for rejection in converted["rejected"] if converted else ():
        key = (_QUOTED.sub("''", rejection["message"]), rejection["code"])
        readers.setdefault(rejection["by"], {}).setdefault(key, []).append(rejection["message"])
    return [
        (
            reader,
            [
                (first, code, [name for text in others for name in _QUOTED.findall(text)[:1]])
                for (_, code), (first, *others) in reasons.items()
            ],
        )
        for reader, reasons in readers.items()
    ]


def _by_reason(missing: Iterable[tuple[str, str]]) -> dict[str, list[str]]:
    """Names of missing parts, by reason."""
    return by_key((reason, name) for name, reason in missing)


def _groups(findings: Iterable[dict[str, Any]]) -> list[tuple[str, list[tuple[int, Any]]]]:
    """The findings by rule family, each with a number; the worst first."""
    return list(by_key((each[1]["family"], each) for each in enumerate(findings)).items())


@cache
def _environment() -> Environment:
    with needing("an HTML report", "report"):
        from jinja2 import Environment, FileSystemLoader, StrictUndefined
    environment = Environment(
        autoescape=True,
        loader=FileSystemLoader(_DIRECTORY),
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=StrictUndefined,
    )
    environment.filters |= {
        "degrees": lambda angle: _number(degrees(angle)),
        "dots": _dots,
        "number": _number,
        "printable": printable,
        "vector": _vector,
        "words": _words,
    }
    return environment


def _read(name: str) -> str:
    with open(os.path.join(_DIRECTORY, name), encoding="utf-8") as file:
        return file.read()


def _safe(text: str) -> str:
    """A text of urdfkit that must not be escaped."""
    from markupsafe import Markup

    assert "</script" not in text.lower()
    return Markup(text)


def _json(value: object) -> str:
    """JSON for a script element; it cannot contain the end tag of the element."""
    from jinja2.utils import htmlsafe_json_dumps

    return htmlsafe_json_dumps(value, ensure_ascii=False, separators=(",", ":"))


def _base64(data: bytes) -> str:
    return base64.b64encode(data).decode("ascii")


def _policy(scripts: Sequence[str], *, live: bool) -> str:
    """Content security policy: embedded scripts and images; a live page may use its server."""
    hashes = (hashlib.sha256(script.encode()).digest() for script in scripts)
    sources = " ".join(f"'sha256-{_base64(digest)}'" for digest in hashes)
    connections = "'self' blob: data:" if live else "blob: data:"
    return "; ".join(
        [
            "default-src 'none'",
            f"script-src {sources}",
            "style-src 'unsafe-inline'",
            "img-src data: blob:",
            f"connect-src {connections}",
            "base-uri 'none'",
            "form-action 'none'",
        ]
    )


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.4g}"


def _words(name: str) -> str:
    """A name or path with line break opportunities after underscores and slashes."""
    from markupsafe import Markup, escape

    return Markup(re.sub(r"([_/])(?!/)", r"\1<wbr>", str(escape(printable(name)))))


def _vector(values: Sequence[float | None] | None, places: int = 12) -> str:
    """Numbers with line break opportunities between them, and at most ``places`` decimal places."""
    from markupsafe import Markup

    texts = (
        "?" if value is None else _number(round(value, places) + 0.0) for value in values or ()
    )
    return Markup(" ".join(f'<span class="value">{text}</span>' for text in texts))


def _dots(moments: Sequence[float | None] | None) -> str:
    """Drawing of three moments on a logarithmic scale from 1e-7 to 100 kg·m²."""
    from markupsafe import Markup

    positive = [moment for moment in moments or () if moment is not None and moment > 0]
    if not positive:
        return ""
    places = [min(max((log10(moment) + 7) / 9, 0.0), 1.0) for moment in positive]
    dots = "".join(f'<circle cx="{4 + 92 * place:.1f}" cy="6" r="3"/>' for place in places)
    return Markup(
        '<svg class="dots" viewBox="0 0 100 12" width="100" height="12" aria-hidden="true">'
        f'<line x1="4" y1="6" x2="96" y2="6"/>{dots}</svg>'
    )
