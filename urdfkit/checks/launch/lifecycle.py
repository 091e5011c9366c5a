"""Nodes of Nav2 and the lifecycle managers that activate them."""

from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Severity
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.argument_checks import is_included

_MANAGER = "nav2_lifecycle_manager"
_NAMES = "node_names"
_MAX_NAMED = 4


def not_activated(context: Context) -> Findings:
    """Managed nodes that are not started, and started nodes that are not managed."""
    launch = context.launch
    programs = launch.programs
    managers = [node for node in programs if node.package == _MANAGER]
    listed = [node.parameters.lists.get(_NAMES) for node in managers]
    is_whole = not launch.unread and all(node.is_sure for node in programs)
    if not managers or not is_whole or b"omposable" in context.source.data:
        return
    if any(names is None or None in names for names in listed):
        return
    names = {name for listed_names in listed for name in listed_names or () if name}
    nodes = {node.title: node for node in programs}
    executables = data("nodes")["lifecycle"].split()
    managed = {name: node for name, node in nodes.items() if node.executable in executables}
    if names.isdisjoint(nodes) or is_included(context.source.path, context.resolver):
        return
    for name, node in managed.items():
        if name not in names and node.package.startswith("nav2_"):
            yield Finding(
                node.at,
                f"'{name}' stays unconfigured: no lifecycle manager has it in {_NAMES}",
                f"add it to {_NAMES} of the lifecycle manager",
                severity=Severity.WARNING,
            )
    if missing := sorted(names.difference(nodes)):
        yield Finding(
            managers[0].at,
            f"the lifecycle manager waits for {few(missing, _MAX_NAMED)}, which nothing starts",
            f"start them, or remove them from {_NAMES}",
            severity=Severity.WARNING,
        )
