"""Poses: user-defined positions of joints.

A pose file is YAML or JSON that maps joint names to positions in rad or m; ``90deg`` is an angle in
degrees. A group state in the SRDF of the robot's package is a named pose.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import pi, tau
from typing import TYPE_CHECKING

from urdfkit.core import disk
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import UrdfkitError
from urdfkit.robot.joint import DEGREES_OF_FREEDOM
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.values import number, numbers
from urdfkit.text.source import Source

if TYPE_CHECKING:
    from urdfkit.robot.tree import KinematicTree
    from urdfkit.ros import RosDescription
    from urdfkit.ros.moveit.srdf import Srdf

#: Size limit of pose files.
MAX_BYTES = 1024 * 1024

_DEGREES = ("deg", "°")
#: Most characters of an invalid value in a message.
_MAX_CHARACTERS = 40


class PoseError(UrdfkitError):
    """An invalid pose: a missing file, joint or state, or a value that is not a number."""


def pose(
    description: RosDescription,
    joints: Mapping[str, str | float] | None = None,
    name: str | None = None,
) -> dict[str, float]:
    """The joint positions of a pose, in rad or m; the other joints are at 0.

    >>> from urdfkit.lint.loading import read
    >>> arm = read("models/good/two_link_arm/urdf/two_link_arm.urdf")
    >>> pose(arm, {"elbow": "90deg"})
    {'elbow': 1.5707963267948966}

    Args:
        description: the robot.
        joints: positions by joint, numbers or text such as ``90deg``; they override ``name``.
        name: a pose file; or a state of the SRDF of the robot's package (``ready``,
            ``arm/ready``), or of another SRDF (``arm.srdf:ready``).

    Raises:
        PoseError: the file, state or joint does not exist, or a value is not a position.
    """
    positions = _named(description, name) if name else {}
    return positions | _positions(description.tree, joints or {})


def outside_limits(tree: KinematicTree, positions: Mapping[str, float]) -> list[str]:
    """A sentence for each joint that is outside its limits."""
    sentences = []
    for name, position in positions.items():
        ends = bounds(tree.model.joints_by_name[name])
        if ends and not ends[0] - 1e-9 <= position <= ends[1] + 1e-9:
            symbol = tree.model.joints_by_name[name].unit
            hint = "; write degrees as 90deg" if symbol == "rad" and abs(position) > tau else ""
            sentences.append(
                f"joint '{name}' at {position:.4g} {symbol} is outside its limits "
                f"{ends[0]:.4g} to {ends[1]:.4g} {symbol}{hint}"
            )
    return sentences


def _named(description: RosDescription, name: str) -> dict[str, float]:
    if disk.exists(name):
        return _positions(description.tree, _read(name))
    path, _, state = name.rpartition(":")
    srdf = _srdf(description, path) if disk.exists(path) else description.srdf
    if srdf is None:
        raise PoseError(f"no pose file '{name}', and no SRDF with this group state")
    states = _states(srdf)
    if state not in states:
        hint = did_you_mean(state, states) or f"; there are {', '.join(states) or 'none'}"
        raise PoseError(f"no pose file '{name}', and no such group state in {srdf.path}{hint}")
    return _positions(description.tree, states[state])


def _srdf(description: RosDescription, path: str) -> Srdf:
    from urdfkit.ros.moveit.srdf_reader import read

    srdf = read(path, description)
    if srdf is None:
        raise PoseError(f"{path}: not an SRDF file")
    return srdf


def _states(srdf: Srdf) -> dict[str, dict[str, str]]:
    """The positions of every state, by ``group/state``, and by ``state`` of all groups together.

    Joints of several degrees of freedom and entries that MoveIt rejects are omitted.
    """
    positions: dict[str, dict[str, str]] = {}
    for state in srdf.states:
        own = {
            joint.get("name") or "": joint.get("value") or ""
            for joint in state.all("joint")
            if _is_posable(srdf.tree, joint.get("name") or "")
            and len(numbers(joint.get("value")) or ()) == 1
        }
        name = state.get("name") or ""
        for key in (name, f"{state.get('group')}/{name}"):
            positions[key] = positions.get(key, {}) | own
    return positions


def _is_posable(tree: KinematicTree, name: str) -> bool:
    joint = tree.model.joints_by_name.get(name)
    return joint is not None and joint.is_single_dof and joint.mimic is None


def _read(path: str) -> dict[str, str]:
    """The positions in a pose file, as text."""
    source = Source.read(path)
    if len(source.data) > MAX_BYTES:
        raise PoseError(f"{path}: larger than {MAX_BYTES // 2**20} MiB")
    import yaml

    text = source.data.decode("utf-8", "replace").replace("\t", " ")  # valid in JSON only
    try:
        root = yaml.compose(text, yaml.SafeLoader)
    except RecursionError as error:
        raise PoseError(f"{path}: nested too deeply to be a pose") from error
    except (yaml.YAMLError, ValueError) as error:
        raise PoseError(f"{path}: neither YAML nor JSON: {' '.join(str(error).split())}") from error
    if not isinstance(root, yaml.MappingNode) or any(
        not isinstance(key, yaml.ScalarNode) for key, _ in root.value
    ):
        raise PoseError(f"{path}: not a YAML or JSON mapping of joints to positions")
    positions: dict[str, str] = {}
    for key, value in root.value:
        name = key.value
        if name in positions:
            raise PoseError(f"{path}: joint '{name}' is defined twice")
        positions[name] = value.value if isinstance(value, yaml.ScalarNode) else f"a {value.id}"
    return positions


def _positions(tree: KinematicTree, values: Mapping[str, str | float]) -> dict[str, float]:
    """Positions in rad or m.

    Raises:
        PoseError: a joint does not exist or cannot be set, or a value is not a position.
    """
    positions = {}
    for name, value in values.items():
        joint = tree.model.joints_by_name.get(name)
        if joint is None:
            suggested = did_you_mean(name, tree.model.joints_by_name)
            raise PoseError(f"no joint '{name}'{suggested}")
        if joint.leader:
            raise PoseError(f"joint '{name}' mimics '{joint.leader}'; set '{joint.leader}' instead")
        if not joint.is_single_dof:
            is_free = joint.kind in DEGREES_OF_FREEDOM
            why = "has several degrees of freedom and cannot be set" if is_free else "does not move"
            raise PoseError(f"joint '{name}' is {joint.kind or 'without a type'}: it {why}")
        positions[name] = _position(name, value, turns=joint.is_rotational)
    return positions


def _position(name: str, value: str | float, *, turns: bool) -> float:
    text = str(value).strip()
    degrees = next((suffix for suffix in _DEGREES if text.endswith(suffix)), "")
    position = number(text.removesuffix(degrees))
    if position is None:
        text = text if len(text) < _MAX_CHARACTERS else f"{text[:_MAX_CHARACTERS]}..."
        raise PoseError(f"joint '{name}': '{text}' is not a position; write 1.57, 90deg or 0.1")
    if degrees and not turns:
        raise PoseError(f"joint '{name}' is prismatic; write its position in m, not in degrees")
    return position * pi / 180 if degrees else position
