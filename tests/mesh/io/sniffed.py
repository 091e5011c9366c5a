"""What is wrong with a mesh file."""

from urdfkit.mesh.io.facts import Defect
from urdfkit.mesh.io.sniff import sniff


def sniffed(data: bytes, suffix: str, format: str) -> tuple[Defect | None, str]:
    """The defect of a file, and its numbers that are not finite; it is of a format."""
    facts = sniff(data, suffix)
    assert facts.format == format
    return facts.defect, facts.non_finite
