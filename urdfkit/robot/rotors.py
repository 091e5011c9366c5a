"""Detection of robots with rotors, propellers or thrusters, which do not stand on the ground."""

import re

from urdfkit.robot.model import RobotModel

#: Pattern of their joint names (not of motors), and the least number of such joints.
_ROTOR, _ROTORS = r"rotor_?\d|propeller|thrust", 2


def is_carried_by_rotors(model: RobotModel) -> bool:
    """True if the joint names of a robot show rotors or thrusters."""
    return sum(bool(re.search(_ROTOR, joint.name.lower())) for joint in model.joints) >= _ROTORS
