"""Joints: types, axes, limits."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Former codes and names, and the rules that report their findings now.
REDIRECTS = {
    "motor-weaker-than-friction": "JNT041",
    "limit-out-of-line": "JNT039",
    "GEO013": "JNT012", "size-looks-like-millimetres": "JNT012",
    "JNT018": "JNT008", "negative-damping-or-friction": "JNT008",
    "effort-or-velocity-not-positive": "JNT008",
    "JNT004": "JNT003", "inverted-limit": "JNT003", "zero-range": "JNT003",
    "JNT021": "JNT002", "no-limit-on-continuous": "JNT002",
    "JNT005": "JNT006", "zero-axis": "JNT006", "JNT027": "JNT006",
    "axis-nearly-a-basis-vector": "JNT006",
    "JNT009": "JNT008", "zero-velocity": "JNT008", "zero-effort": "JNT008", "JNT028": "JNT008",
    "negative-effort-or-velocity": "JNT008",
    "limits-look-like-degrees": "JNT010", "JNT011": "JNT010", "rpy-looks-like-degrees": "JNT010",
    "JNT040": "JNT010", "velocity-looks-like-degrees": "JNT010",
    "origin-looks-like-millimetres": "JNT012", "JNT038": "JNT012",
    "travel-looks-like-millimetres": "JNT012",
    "JNT024": "JNT019", "calibration-out-of-range": "JNT019",
    "safety-limits-outside-limits": "JNT019", "JNT029": "JNT019", "empty-soft-range": "JNT019",
    "JNT035": "JNT020", "limit-on-fixed": "JNT020", "axis-on-fixed": "JNT020",
    "twins-differ": "JNT025", "JNT031": "JNT025", "twin-misplaced": "JNT025", "JNT042": "JNT025",
    "twin-axis-differs": "JNT025",
    "optical-frame-misrotated": "JNT030", "GAZ049": "JNT030", "camera-on-optical-frame": "JNT030",
    "GAZ055": "JNT030", "camera-frame-not-optical": "JNT030",
    "wheel-axis-across": "JNT033", "JNT034": "JNT033", "wheel-with-ends": "JNT033",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True for a document with a robot in it: links have poses, too."""
    return bool(subject.model.joints or subject.model.links)
