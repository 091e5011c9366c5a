"""A launch file, or a file that it names, is not installed by the build of its package.

In the source tree the file exists. After `colcon build` or `catkin_make install` it is not:
"file 'robot.launch.py' was not found in the share directory", or RViz and the controllers miss
their configuration. Install the directory.

Sources:
    REP 122, installed files: https://ros.org/reps/rep-0122.html
    ros2/demos#353: https://github.com/ros2/demos/issues/353
"""

from __future__ import annotations

import os

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, Need, rule
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Span
from urdfkit.workspace.install_rules import InstallRules

NAME = "launch/robot.launch"
BAD = '<launch><rosparam file="$(find bot)/settings/robot.yaml"/></launch>'
GOOD = BAD.replace("settings/", "config/")
FILES = {
    "package.xml": b"<package><name>bot</name></package>",
    "CMakeLists.txt": b"project(bot)\n"
    b"install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\n",
    "settings/robot.yaml": b"rate: 10\n",
    "config/robot.yaml": b"rate: 10\n",
}


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(subject: Subject) -> Findings:
    source = subject.source
    home = subject.resolver.packages.enclosing(source.path)
    if home is None:
        return
    name, folder = home
    shipping = InstallRules(folder, name)
    own = os.path.abspath(source.path)
    if not os.path.relpath(own, folder).startswith("launch"):
        return  # a test or an example, which stay in the source tree
    named = [(file.path, file.span) for file in subject.launch.files if file.exists]
    reported: set[str] = set()
    for path, span in [(own, Span(source, 0, 0)), *named]:
        relative = os.path.relpath(path, folder)
        top = relative.partition(os.sep)[0]
        if top in (os.pardir, *reported) or os.sep not in relative or not os.path.exists(path):
            continue
        if not shipping.installs(relative):
            reported.add(top)
            message = f"'{relative}' is not installed by {shipping.file}"
            yield Finding(Location(span), message, shipping.remedy(top))
