"""Robots and their SRDFs as text, for the examples of rules."""

from urdfkit.robot.samples import element_xml


def named_xml(name: str, *inside: str) -> str:
    """A ``<robot>`` with elements, of a URDF or an SRDF."""
    return element_xml(f'robot name="{name}"', *inside) + "\n"


def srdf_files(bad: str, good: str) -> dict[str, bytes]:
    """The SRDFs of the robots ``bad`` and ``good``, by file name."""
    return {
        f"{name}.srdf": named_xml(name, inside).encode()
        for name, inside in (("bad", bad), ("good", good))
    }
