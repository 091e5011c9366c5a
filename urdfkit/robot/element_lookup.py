"""Lookup of the link and joint that a finding concerns, by the path of its element."""

from urdfkit.robot.model import RobotModel


class ElementLookup:
    """Links and joints by the paths of the elements in the robot's document.

    Args:
        model: None if the document has no model.
    """

    def __init__(self, model: RobotModel | None) -> None:
        self._links: dict[str, str] = {}
        self._joints: dict[str, str] = {}
        if model is None:
            return
        links = model.links_by_name
        for link in model.links:
            self._links.setdefault(link.at.path, link.name)
        for joint in model.joints:
            if joint.child_name in links:
                self._links.setdefault(joint.at.path, joint.child_name)
                self._joints.setdefault(joint.at.path, joint.name)
        for block in model.gazebo:
            if (name := block.get("reference")) in links:
                self._links.setdefault(block.path, str(name))

    def link(self, element: str) -> str | None:
        """Name of the link that an element belongs to, by the element's path."""
        return _nearest(self._links, element)

    def joint(self, element: str) -> str | None:
        return _nearest(self._joints, element)


def _nearest(names: dict[str, str], element: str) -> str | None:
    """The name for a path or its nearest ancestor; link names may contain slashes."""
    path = element.partition("@")[0]
    while path:
        if path in names:
            return names[path]
        path = path.rpartition("/")[0]
    return None
