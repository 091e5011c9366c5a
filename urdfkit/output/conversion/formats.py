"""The formats that a robot can be converted to.

Each format has a module of its name here with a function ``write``, loaded when needed.
"""

from __future__ import annotations

from urdfkit.core.record import Record


class Format(Record):
    """A format that a robot can be converted to."""

    name: str  # value of --to
    extra: str  # extra of urdfkit with the required libraries
    has_options: bool = False  # True if `urdfkit.output.conversion.options` apply


FORMATS = {
    format.name: format
    for format in (
        Format("mjcf", "simulate", has_options=True),
        Format("usd", "usd"),
        Format("sdf", "meshes"),
        Format("urdf", "meshes"),
    )
}
