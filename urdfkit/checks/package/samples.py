"""A robot with a mesh in a package, for the examples of rules."""

from urdfkit.robot.samples import element_xml, link_xml, visual_xml


def robot_of_package(package: str) -> str:
    """A robot whose only link is a mesh of a package."""
    mesh = visual_xml(f'<mesh filename="package://{package}/meshes/base.stl"/>')
    return element_xml('robot name="bot"', link_xml("base", mesh)) + "\n"
