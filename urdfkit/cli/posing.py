"""The options for joint positions, for all commands with a pose."""

from collections.abc import Mapping
from typing import Any

from urdfkit.cli import options, output
from urdfkit.cli.decorators import option, with_options
from urdfkit.lint.context import Context
from urdfkit.physics.poses import outside_limits, pose

#: Adds the options ``--joint`` and ``--pose`` to a command, as ``joint`` and ``pose``.
posed = with_options(
    option("--pose FILE", "Pose file, or an SRDF group state such as ready or arm.srdf:ready."),
    option(
        "--joint NAME=VALUE",
        "Joint position in rad or m, or in degrees such as 90deg.",
        multiple=True,
    ),
)


def positions(context: Context, inputs: Mapping[str, Any]) -> dict[str, float]:
    """The joint positions of the options; reports those outside the limits.

    Raises:
        UsageError: ``--joint`` has no ``=``.
        PoseError: there is no such joint or pose.
    """
    words = {}
    for word in inputs["joint"]:
        key, equals, value = word.rpartition("=")
        if not (key and equals):
            raise options.UsageError(
                f"--joint {word}: expected NAME=VALUE: the joint and its position"
            )
        words[key] = value
    pose_by_joint = pose(context, words, inputs["pose"])
    for sentence in outside_limits(context.tree, pose_by_joint):
        output.note(sentence)
    return pose_by_joint
