"""A `<mimic>` cannot drive its joint.

- A joint mimics itself, or joints mimic one another in a cycle: no joint has an independent
  position. Drake and MuJoCo reject a joint that mimics itself, MoveIt drops every mimic of the
  robot, Pinocchio rejects the robot if mimic joints are enabled, and joint_state_publisher recurses
  until Python stops it. Remove the `<mimic>` of the leading joint.
- The leader is fixed, floating or planar: only revolute, continuous and prismatic joints have one
  position to follow. Drake rejects the robot; MuJoCo and MoveIt drop the coupling, so that the
  follower moves freely. A fixed joint with a `<mimic>` is reported for Drake only.
- The multiplier of a joint that moves is 0: it stays at its offset. Omit the attribute for 1.

Sources:
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
    joint_state_publisher.py: https://github.com/ros/joint_state_publisher/blob/ros2/joint_state_publisher/joint_state_publisher/joint_state_publisher.py
"""

from collections.abc import Iterator

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.joint import SINGLE_DOF, Joint
from urdfkit.robot.joint_limits import related, several
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import hand_xml
from urdfkit.text.schema import JOINT_TYPES

_LIMIT = '<limit lower="0" upper="0.04" effort="20" velocity="0.2"/>'
_OF_LEFT, _OF_RIGHT = '<mimic joint="left_joint"/>', '<mimic joint="right_joint"/>'
BAD = hand_xml("prismatic", [_LIMIT, _OF_RIGHT], [_LIMIT, _OF_LEFT])
GOOD = hand_xml("prismatic", [_LIMIT], [_LIMIT, _OF_LEFT])

#: Number of joints that a message lists.
_MAX_NAMES = 6

_IMMOBILE = frozenset(JOINT_TYPES) - frozenset(SINGLE_DOF)


@rule(Severity.ERROR, reports_missing=True)
def check(context: Context) -> Findings:
    for cycle in _cycles(context.model):
        yield _cycle_finding(cycle)
    yield from _immobile(context)
    for joint in context.model.joints:
        mimic = joint.mimic
        if mimic and mimic.joint and mimic.multiplier == 0 and joint.is_single_dof:
            yield Finding(
                mimic.at.attributes.get("multiplier", mimic.at),
                f"joint '{joint.name}' mimics '{mimic.joint.value}' with multiplier 0: it stays at "
                f"{mimic.offset:g}",
                "write the multiplier, such as 1",
                severity=Severity.WARNING,
            )


def _cycle_finding(cycle: list[Joint]) -> Finding:
    first = cycle[0]
    assert first.mimic is not None
    at = first.mimic.joint or first.mimic.at
    if len(cycle) == 1:
        return Finding(at, f"joint '{first.name}' mimics itself", "name the joint that leads")
    names = [f"'{joint.name}'" for joint in cycle[:_MAX_NAMES]]
    if len(cycle) > _MAX_NAMES:
        names.append(f"{len(cycle) - _MAX_NAMES} more")
    return Finding(
        at,
        f"mimic cycle: {' -> '.join([*names, names[0]])}",
        "let one of them lead, without a <mimic>",
        related=related((joint, joint.mimic.at.span) for joint in cycle if joint.mimic),
    )


def _cycles(model: RobotModel) -> Iterator[list[Joint]]:
    """The cycles of mimicking joints, each once."""
    joints = model.joints_by_name
    visited: dict[str, int] = {}  # by which walk
    for walk, start in enumerate(joints.values()):
        path: list[Joint] = []
        joint: Joint | None = start
        while joint and joint.leader and joint.name not in visited:
            visited[joint.name] = walk
            path.append(joint)
            joint = joints.get(joint.leader)
        if joint and visited.get(joint.name) == walk:
            yield path[path.index(joint) :]


def _immobile(context: Context) -> Findings:
    """Leaders, and for Drake followers, without one position; one finding for each reason."""
    known = context.model.joints_by_name
    drake = context.targets.that("needs_movable_mimic")
    found: dict[str, list[Joint]] = {}
    for joint in context.model.joints:
        leader = known.get(joint.leader)
        if leader is None or leader is joint:
            continue
        if joint.kind in _IMMOBILE and drake:
            found.setdefault(f"<mimic> on a {joint.kind} joint", []).append(joint)
        elif leader.kind in _IMMOBILE and joint.is_single_dof:
            reason = f"<mimic> of '{leader.name}', which is {leader.kind}"
            found.setdefault(reason, []).append(joint)
    for reason, joints in found.items():
        assert joints[0].mimic is not None
        yield Finding(
            joints[0].mimic.at,
            f"{several(joints)}: {reason}",
            "remove the <mimic>, or give the joint a type that moves",
            related=related((joint, joint.mimic.at.span) for joint in joints if joint.mimic),
            severity=Severity.ERROR if drake else Severity.WARNING,
            targets=drake,
        )
