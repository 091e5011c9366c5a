"""The classes of composable nodes: ``catalog/launch.json``."""

from urdfkit.core.suggest import CLOSE_TYPO, nearest
from urdfkit.ros.catalog import data


def wrong_component(package: str | None, plugin: str | None) -> tuple[str, str] | None:
    """Message and help for a class that a container does not find; None if it may exist."""
    if not plugin or "$" in plugin:
        return None
    known: list[str] = data("launch")["components"].get(package or "", "").split()
    if "/" in plugin and "::" not in plugin:
        message = f"plugin is '{plugin}', but composable nodes are classes of C++"
        return message, f"write {plugin.replace('/', '::')}"
    match = nearest(plugin, known, CLOSE_TYPO) if plugin not in known else None
    same = [name for name in known if name.rpartition("::")[2] == plugin.rpartition("::")[2]]
    if plugin not in known and (match or same):
        return f"package '{package}' has no component '{plugin}'", f"write {match or same[0]}"
    return None
