"""Configurations of RViz."""

from collections.abc import Iterator

from urdfkit.text.located_yaml import Node, Value, load, mapping, scalar
from urdfkit.text.source import Source


def manager_of(source: Source) -> dict[str, Node]:
    """The section of a configuration that contains the displays; empty if it is missing."""
    return mapping(load(source), "Visualization Manager")


def displays(source: Source) -> Iterator[dict[str, Node]]:
    """The enabled displays, including those in groups."""
    listed = manager_of(source).get("Displays")
    stack: list[Node] = list(listed) if isinstance(listed, list) else []
    while stack:
        display = mapping(stack.pop())
        enabled = scalar(display, "Enabled")
        if enabled and enabled.text.lower() != "true":
            continue
        yield display
        inner = display.get("Displays")
        stack += inner if isinstance(inner, list) else []


def tools(source: Source) -> list[dict[str, Node]]:
    """The tools of a configuration."""
    listed = manager_of(source).get("Tools")
    return [mapping(tool) for tool in listed] if isinstance(listed, list) else []


def other_classes(source: Source) -> list[Value]:
    """The classes of the panels, the tools and the view."""
    panels = mapping(load(source)).get("Panels")
    view = mapping(manager_of(source), "Views").get("Current")
    parts = [*(panels if isinstance(panels, list) else ()), *tools(source), view]
    return [kind for part in parts if (kind := scalar(mapping(part), "Class"))]


def topic_of(display: dict[str, Node], name: str = "Topic") -> Value | None:
    """The topic of a display; None if it is missing, or a plain text as in ROS 1."""
    value = mapping(display, name).get("Value")
    return value if isinstance(value, Value) and value.text else None
