"""XML documents, and the robots in them, from a text."""

from urdfkit.lint.rule_examples import whole_robot
from urdfkit.robot.model import RobotModel
from urdfkit.robot.tree import KinematicTree
from urdfkit.text.document import Document
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml


def document(text: str) -> Document:
    document, _ = read_xml(Source("robot.urdf", text.encode()))
    assert document is not None
    return document


def model(text: str) -> RobotModel:
    """A robot, from its file or from what is inside of it."""
    return RobotModel(document(whole_robot(text)))


def tree(text: str) -> KinematicTree:
    return KinematicTree(model(text))
