"""Containers of composable nodes that nothing starts.

Source: ``navigation_launch.py`` and ``bringup_launch.py`` of nav2_bringup, humble to rolling: only
the latter starts the container.
"""

from urdfkit.checks.bringup.workspace_launches import all_launches, is_included
from urdfkit.lint.rules import Context, Finding, Findings
from urdfkit.ros.launch.contents import Launch

_PACKAGE, _STARTING = "/nav2_bringup/launch/", "bringup_launch.py"
_LOADING = ("navigation_launch.py", "localization_launch.py")
_SWITCH, _NAME, _DEFAULT = "use_composition", "container_name", "nav2_container"


def missing_container(context: Context) -> Findings:
    """Launch files of Nav2 that wait for a container that they do not start."""
    if is_included(context):
        return
    launches = all_launches(context)
    if any(map(_may_start_container, launches)) or b"omposableNodeContainer" in context.source.data:
        return
    for file in context.launch.includes:
        arguments = file.arguments or {}
        switch, name = arguments.get(_SWITCH), arguments.get(_NAME)
        is_composed = switch is not None and (switch.text or "").lower() == "true"
        if is_composed and file.is_sure and file.path.endswith(_LOADING) and _PACKAGE in file.path:
            container = _DEFAULT if name is None else name.text
            yield Finding(
                file.span,
                f"{file.path.rpartition('/')[2]} waits for the container '{container}', which "
                "nothing starts",
                f"include {_STARTING}, start a component_container of this name, or set "
                f"{_SWITCH} to False",
            )


def _may_start_container(launch: Launch) -> bool:
    starts = any(node.executable.startswith("component_container") for node in launch.programs)
    return starts or any(_STARTING in file.path for file in launch.includes)
