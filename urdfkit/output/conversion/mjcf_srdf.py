"""The SRDF in MJCF: disabled collisions, and named states as keyframes."""

from collections.abc import Iterable
from typing import Any

import mujoco

from urdfkit.lint.context import Context
from urdfkit.output.conversion.mjcf_robot import MjcfRobot
from urdfkit.robot.kinematics import positions
from urdfkit.robot.values import number
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.text.document import Element


def exclude_neighbours(mjcf: MjcfRobot, robot: Context) -> None:
    """Exclude pairs of links with a joint between them.

    MuJoCo excludes them itself unless the parent is welded to the world.
    """
    moving = (joint for joint in robot.model.joints if joint.kind != "fixed")
    _exclude(mjcf, {frozenset(robot.tree.ends(joint) or ()) for joint in moving})


def exclude_disabled(mjcf: MjcfRobot, srdf: Srdf | None) -> None:
    """Exclude pairs of links that an SRDF disables."""
    _exclude(mjcf, srdf.disabled if srdf else ())


def exclude_computed(mjcf: MjcfRobot, robot: Context) -> None:
    """Exclude pairs of links that ``urdfkit collisions -o`` would disable."""
    pairs = robot.collisions.matrix().pairs
    _exclude(mjcf, (frozenset((pair.first, pair.second)) for pair in pairs if pair.verdict.reason))


def _exclude(mjcf: MjcfRobot, pairs: Iterable[frozenset[str]]) -> None:
    known = {frozenset((exclude.bodyname1, exclude.bodyname2)) for exclude in mjcf.spec.excludes}
    for pair in sorted(map(sorted, set(pairs))):
        if all(name in mjcf.bodies for name in pair):
            names = sorted({mjcf.bodies[name].name for name in pair} - {"world"})
            if len(names) == 2 and frozenset(names) not in known:
                first, second = names
                mjcf.spec.add_exclude(name=" ".join(names), bodyname1=first, bodyname2=second)
                known.add(frozenset(names))


def add_keyframes(mjcf: MjcfRobot, robot: Context) -> None:
    """Add the named states of groups as keyframes; joints of other groups are at zero."""
    states = robot.srdf.states if robot.srdf else ()
    if not states:
        return
    data = mujoco.MjData(mjcf.spec.compile())
    names = [state.get("name") or "" for state in states]
    taken: set[str] = set()
    for state, name in zip(states, names, strict=True):
        full_name = name if names.count(name) == 1 else f"{state.get('group')} {name}"
        pose = _pose(state, robot)
        if pose and full_name not in taken:
            taken.add(full_name)
            _keyframe(mjcf, robot, data, full_name, pose)


def _keyframe(
    mjcf: MjcfRobot, robot: Context, data: Any, name: str, pose: dict[str, float]
) -> None:
    """Add a keyframe, with the targets of position actuators."""
    mujoco.mj_resetData(data.model, data)
    for joint, position in positions(robot.tree, pose).items():
        data.joint(joint).qpos[0] = position
    for actuator in mjcf.spec.actuators:
        if actuator.biasprm[1]:
            data.actuator(actuator.name).ctrl[0] = data.joint(actuator.target).qpos[0]
    mjcf.spec.add_key(name=name, qpos=data.qpos, ctrl=data.ctrl)


def _pose(state: Element, robot: Context) -> dict[str, float]:
    """Positions of the joints with one degree of freedom in a state."""
    moving = positions(robot.tree, {})
    pose: dict[str, float] = {}
    for joint in state.all("joint"):
        name, value = joint.get("name") or "", number((joint.get("value") or "").strip())
        if name in moving and value is not None:
            pose[name] = value
    return pose
