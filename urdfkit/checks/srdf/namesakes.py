"""Other robots with the same name that an SRDF and MoveIt's files may have been written for."""

from collections.abc import Iterator
from itertools import chain, islice

from urdfkit.lint.rules import Context
from urdfkit.ros.launch.robot_arguments import launches_of_package, launches_of_workspace
from urdfkit.ros.moveit.srdf import Srdf

#: Most robots of launch files that are expanded.
_MAX_STARTED = 32


def launched_namesakes(context: Context, srdf: Srdf) -> Iterator[Context]:
    """The robots with the name of a robot or its SRDF in launch files of the workspace.

    They are this robot with other arguments, or another revision of it.
    """
    place = (srdf.path, context.resolver)
    launches = chain(launches_of_package(*place), launches_of_workspace(*place))
    descriptions = (description for launch in launches for description in launch.descriptions)
    for description in islice(descriptions, _MAX_STARTED):
        robot = context.other_robot(description.path, description.arguments)
        if robot.is_readable and robot.model.name in (context.model.name, srdf.root.get("name")):
            yield robot
