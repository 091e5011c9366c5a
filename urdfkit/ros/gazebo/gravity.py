"""Links without gravity in Gazebo, the usual substitute for counterweights and springs."""

from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.tree import KinematicTree
from urdfkit.ros.gazebo.values import is_true, text_of


def links_without_gravity(tree: KinematicTree) -> set[str]:
    """Names of links without gravity; the flag of a link applies to all links merged with it."""
    flagged = {
        block.get("reference")
        for block in tree.model.gazebo
        for tag in block.children
        if (tag.tag == "turnGravityOff" and is_true(tag))
        or (tag.tag == "gravity" and text_of(tag).lower() in ("false", "0"))
    }
    if not flagged:
        return set()
    bodies = [body.names for body in rigid_bodies(tree)]
    return {name for names in bodies if not flagged.isdisjoint(names) for name in names}
