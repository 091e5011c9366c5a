"""The classes of composable nodes: ``catalog/launch.json``."""

from collections.abc import Iterable

from urdfkit.core.suggest import CLOSE_TYPO, nearest
from urdfkit.ros.catalog import data

#: The mark of a package all of whose classes are known.
_ALL = "+"


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
    if plugin not in known and (match or same or _ALL in known):
        message = f"package '{package}' has no component '{plugin}'"
        others = ", ".join(name for name in known if name != _ALL)
        return message, f"write {match or (same[0] if same else f'one of {others}')}"
    return None


def executable_of(plugin: str | None) -> str:
    """The executable that is the same node as a class; empty if there is none, or it is unknown."""
    executables: dict[str, str] = data("launch")["standalone"]
    return executables.get(plugin or "", "")


def wrong_container(target: str, containers: Iterable[str]) -> tuple[str, str] | None:
    """Message and help for a target that is no container; None if it may be one.

    Args:
        target: the name of a container; launch does not add a namespace to it.
        containers: the names of those that the file starts, with their namespaces.
    """
    name, known = target.strip("/"), [container.strip("/") for container in containers]
    if not name or "$" in name or name in known:
        return None
    same = [other for other in known if other.rpartition("/")[2] == name.rpartition("/")[2]]
    suggested = same[0] if len(same) == 1 else nearest(name, known, CLOSE_TYPO)
    if suggested is None:
        return None
    return f"no container is called '/{name}': it is '/{suggested}'", f"write /{suggested}"
