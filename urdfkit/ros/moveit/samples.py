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


def configurations(name: str, bad: str, good: str) -> dict[str, bytes]:
    """A package with the MoveIt configurations of the robots ``bad`` and ``good``.

    Each has the group ``arm`` with the link ``arm``, and a parameter file.
    """
    group = '<group name="arm"><link name="arm"/></group>'
    srdfs = srdf_files(group, group)
    return {
        "package.xml": b"<package><name>arm</name><build_type>ament_cmake</build_type></package>",
        "config/bad.srdf": srdfs["bad.srdf"],
        f"config/{name}": bad.encode(),
        "srdf/good.srdf": srdfs["good.srdf"],
        f"srdf/{name}": good.encode(),
    }
