"""Robots that rotors, propellers or thrusters carry: no root is held, and they stand on nothing."""

import re

from urdfkit.robot.model import RobotModel

#: In the names of their joints, and how many of these carry one; not that of a motor.
_ROTOR, _ROTORS = r"rotor_?\d|propeller|thrust", 2


def is_carried_by_rotors(model: RobotModel) -> bool:
    """True if rotors or thrusters carry the robot, by the names of their joints."""
    return sum(bool(re.search(_ROTOR, joint.name.lower())) for joint in model.joints) >= _ROTORS
