"""Keys of parameter files of controllers that neither a controller nor its manager reads."""

from collections.abc import Iterator

from urdfkit.core.suggest import TYPO, is_typo, nearest
from urdfkit.ros.catalog.controllers import parameters_of
from urdfkit.ros.controllers import MANAGER, Section
from urdfkit.ros.node_parameters import PARAMETERS
from urdfkit.text.located_yaml import Key, Node, Value, mapping, scalar
from urdfkit.text.source import Span


def unread_keys(root: Node) -> Iterator[tuple[Span, str, str]]:
    """The unread keys of a file: location, message and help."""
    sections = [(k, node) for k, node in mapping(root).items() if isinstance(node, dict)]
    for key, node in sections:
        for inner in node:
            if isinstance(inner, Key) and inner != PARAMETERS and _is_parameters(inner):
                message = f"parameters of '{key}' are not read: '{inner}' is not '{PARAMETERS}'"
                yield inner.span, message, f"write {PARAMETERS}"
    declared: set[str] = set()
    yield from _misspelt_manager(sections)
    for key, node in sections:
        inside = node.get(PARAMETERS)
        if _node_of(key) == MANAGER and isinstance(inside, dict):
            yield from _without_type(inside)
            yield from _below_manager(inside, dict(sections))
            section = Section({}, {}, None)
            section.add(inside)
            declared.update(section.types)
    yield from _unread_sections(sections, declared - {""})


def _unread_sections(
    sections: list[tuple[str, dict[str, Node]]], declared: set[str]
) -> Iterator[tuple[Span, str, str]]:
    """Sections without a controller, and sections of controllers without ``ros__parameters``."""
    without = declared.difference(_node_of(key) for key, _ in sections)
    for key, node in sections:
        name = _node_of(key)
        if not isinstance(key, Key):
            continue
        if name in declared and not any(map(_is_parameters, node)):
            message = f"parameters of '{key}' are not read: they are not in {PARAMETERS}"
            yield key.span, message, f"write {PARAMETERS}: below '{key}', and indent the rest"
        elif name not in declared and (suggested := nearest(name, without, TYPO)):
            message = f"'{key}' is not a controller of the controller manager and not read"
            yield key.span, message, f"did you mean '{suggested}'?"


def _is_parameters(key: str) -> bool:
    return key == PARAMETERS or nearest(key, [PARAMETERS], TYPO) is not None


def _without_type(manager: dict[str, Node]) -> Iterator[tuple[Span, str, str]]:
    """A ``type`` without a controller, because of its indentation, or a misspelt ``type``."""
    kind = scalar(manager, "type")
    if kind and "/" in kind.text:
        message = "type without a controller: it is not indented below a name"
        yield kind.span, message, "indent it below the name of its controller"
    for name, node in manager.items():
        for key, value in mapping(node).items() if "type" not in mapping(node) else ():
            is_class = isinstance(value, Value) and "/" in value.text
            if isinstance(key, Key) and is_class and is_typo(key, "type"):
                yield key.span, f"controller '{name}' has '{key}' instead of type", "write type"


def _misspelt_manager(
    sections: list[tuple[str, dict[str, Node]]],
) -> Iterator[tuple[Span, str, str]]:
    """A section with the types of controllers whose name is that of the manager, misspelt."""
    for key, node in sections:
        inside = mapping(node, PARAMETERS)
        is_manager = any("type" in mapping(value) for value in inside.values())
        name = _node_of(key)
        if isinstance(key, Key) and is_manager and name != MANAGER and is_typo(name, MANAGER):
            message = f"parameters of '{key}' are not read: the node is '{MANAGER}'"
            yield key.span, message, f"write {MANAGER}"


def _below_manager(
    manager: dict[str, Node], sections: dict[str, dict[str, Node]]
) -> Iterator[tuple[Span, str, str]]:
    """Parameters of a controller next to its type, where only the controller manager sees them.

    A controller that also has them in its own section works: those of ROS 1 were left over.
    """
    for name, node in manager.items():
        kind = scalar(node, "type")
        known = parameters_of(kind.text, 2) if kind else None
        own = mapping(sections.get(name), PARAMETERS)
        for key in mapping(node) if known else ():
            is_own = known is not None and (known.type_of(key) or key in known.required)
            if is_own and key not in own and isinstance(key, Key):
                message = f"'{key}' of controller '{name}' is not read: it is a parameter of "
                message += MANAGER
                help = f"write it below {name}: {PARAMETERS}:, at the top level"
                yield key.span, message, help
                break


def _node_of(key: str) -> str:
    """Name of the node in a key such as ``/**/drive``."""
    return key.strip("/").rpartition("/")[2]
