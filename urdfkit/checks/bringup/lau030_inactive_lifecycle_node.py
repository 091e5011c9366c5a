"""A lifecycle node stays unconfigured, or what activates it waits for a node that is not started.

- A lifecycle manager of Nav2 waits for a node that nothing starts, or `autostart` of the manager is
  false, as it is by default.
- No manager activates a node of Nav2, or of slam_toolbox since Jazzy, which stays unconfigured. Or
  no launch file of the workspace starts a lifecycle manager for a server of Nav2.
- A launch file of Nav2 waits for a container of composable nodes that nothing starts.

Sources:
    Nav2, lifecycle manager: https://docs.nav2.org/configuration/packages/configuring-lifecycle.html
    Managed nodes: https://design.ros2.org/articles/node_lifecycle.html
"""

from urdfkit.checks.bringup.containers import missing_container
from urdfkit.checks.bringup.known_programs import are_topics_known
from urdfkit.checks.bringup.lifecycle import (
    inactive_mapping,
    not_activated,
    not_started,
    unmanaged,
)
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule

NAME = "launch/navigation.launch.xml"
BAD = """\
<launch>
  <node pkg="nav2_map_server" exec="map_server" name="map_server"/>
  <node pkg="nav2_lifecycle_manager" exec="lifecycle_manager" name="manager">
    <param name="node_names" value="['map_server']"/>
    <param name="autostart" value="false"/>
  </node>
</launch>
"""
GOOD = BAD.replace('value="false"', 'value="true"')


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    yield from not_activated(context)
    yield from unmanaged(context)
    yield from not_started(context)
    yield from inactive_mapping(context)
    if are_topics_known(context):
        yield from missing_container(context)
