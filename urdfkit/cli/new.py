"""``urdfkit new``: a ROS 2 package to start a robot from."""

import os
import shlex

import click

from urdfkit.cli import output
from urdfkit.cli.decorators import described, no_stream, option
from urdfkit.output.package_templates import KINDS, create


@described("new")
@click.argument("name")
@click.option("--kind", type=click.Choice(KINDS), required=True, help="Kind of robot.")
@option(
    "-o, --output DIR",
    "Directory to write NAME in.",
    to="out",
    default=os.curdir,
    callback=no_stream,
)
def command(name: str, kind: str, out: str) -> int:
    """Write a ROS 2 package with a valid robot to start from.

    For ROS 2 Jazzy and Gazebo Harmonic: xacro with macros, controllers, a bridge, a world, a launch
    file and RViz. Nothing is overwritten.

    Exit codes: 0 written, 2 the name is not valid or exists, or cannot be written.

    Examples:
        urdfkit new my_robot --kind diff_drive
        urdfkit new my_arm --kind arm -o src
    """
    files = create(name, kind, out)
    package = os.path.join(out, name) if out != os.curdir else name
    output.page(
        (
            *(f"{package}/{file}" for file in files),
            "",
            f"Check it:      urdfkit check {shlex.quote(package)}",
            "Simulate it:   urdfkit simulate " + shlex.quote(f"{package}/urdf/{name}.urdf.xacro"),
            "Build it:      colcon build && source install/setup.bash  # in the workspace",
            f"Start it:      ros2 launch {name} simulation.launch.py",
        )
    )
    return 0
