"""The formats that a robot can be converted to; each has a module with a function ``write``."""

from __future__ import annotations

from urdfkit.core.record import Record


class Format(Record):
    """A format."""

    name: str  # as --to takes it
    module: str  # below this package; loaded when the format is asked for, since it is heavy
    extra: str  # of urdfkit, with the libraries that it needs
    has_options: bool = False  # those of `urdfkit.output.conversion.options`


FORMATS = {
    one.name: one
    for one in (
        Format("mjcf", "mjcf", "simulate", has_options=True),
        Format("usd", "usd", "usd"),
        Format("urdf", "urdf", "meshes"),
    )
}
