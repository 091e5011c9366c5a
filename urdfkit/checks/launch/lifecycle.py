"""Nodes of Nav2 and the lifecycle managers that activate them."""

from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Location, Severity
from urdfkit.ros.launch.argument_checks import is_included

_MANAGER = "nav2_lifecycle_manager"
_NAMES = "node_names"
#: Executables of Nav2 that are lifecycle nodes of the same name.
MANAGED = frozenset(
    "amcl behavior_server bt_navigator collision_monitor controller_server map_server "
    "planner_server smoother_server velocity_smoother waypoint_follower".split()
)
_NAMED = 4


def not_activated(context: Context) -> Findings:
    """Names of a lifecycle manager that nothing starts, and nodes that none names."""
    launch = context.launch
    started = (*launch.started, *launch.included)
    managers = [one for one in started if one.package == _MANAGER]
    listed = [one.parameters.lists.get(_NAMES) for one in managers]
    is_whole = not launch.unread and all(one.is_sure for one in started)
    if not managers or not is_whole or b"omposable" in context.source.data:
        return
    if any(names is None or None in names for names in listed):
        return
    names = {name for several in listed for name in several or () if name}
    nodes = {one.name or one.executable: one for one in started}
    managed = {name: one for name, one in nodes.items() if one.executable in MANAGED}
    if names.isdisjoint(nodes) or is_included(context.source.path, context.resolver):
        return
    for name, one in managed.items():
        if name not in names and one.package.startswith("nav2_"):
            yield Finding(
                Location(one.span, one.frame),
                f"'{name}' stays unconfigured: no lifecycle manager has it in {_NAMES}",
                f"add it to {_NAMES} of the lifecycle manager",
                severity=Severity.WARNING,
            )
    if lost := sorted(names.difference(nodes)):
        yield Finding(
            Location(managers[0].span, managers[0].frame),
            f"the lifecycle manager waits for {few(lost, _NAMED)}, which nothing starts",
            f"start them, or remove them from {_NAMES}",
            severity=Severity.WARNING,
        )
