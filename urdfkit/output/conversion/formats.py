"""The formats that a robot can be converted to.

Each has a module of its name here with a function ``write``, loaded when it is asked for.
"""

from __future__ import annotations

from urdfkit.core.record import Record


class Format(Record):
    """A format that a robot can be converted to."""

    name: str  # as --to takes it
    extra: str  # of urdfkit, with the libraries that it needs
    has_options: bool = False  # those of `urdfkit.output.conversion.options`


FORMATS = {
    one.name: one
    for one in (
        Format("mjcf", "simulate", has_options=True),
        Format("usd", "usd"),
        Format("sdf", "meshes"),
        Format("urdf", "meshes"),
    )
}
