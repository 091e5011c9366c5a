"""Launch files and actions of ros_gz that pass their arguments to a node: ``catalog/launch.json``.

Source: ``ros_gz_sim/launch``, ``ros_gz_bridge/launch`` and the ``actions`` of gazebosim/ros_gz,
which include these files.
"""

import re
from collections.abc import Iterator, Mapping

from urdfkit.ros.catalog import data
from urdfkit.ros.launch.bridges import EXPANDS_NAMES
from urdfkit.ros.launch.contents import GivenParameters, IncludedFile, StartedProgram, Word

_SPAWNER = "ros_gz_sim/create"
#: The options of the program that spawns models, by argument.
_OPTIONS = {name: name for name in ("world", "file", "topic", "x", "y", "z", "R", "P", "Y")} | {
    "model_string": "string", "entity_name": "name", "roll": "R", "pitch": "P", "yaw": "Y",
}  # fmt: skip
_CONFIG_FILE = "config_file"
#: Arguments of later versions with parameters of the bridge.
_OTHER_PARAMETERS = ("bridge_params", "extra_bridge_params")
_EXPANDED = re.compile(rf"\b{EXPANDS_NAMES}\W+true\b", re.IGNORECASE)


def file_of_action(name: str) -> str:
    """The launch file, as package and path, that an action or a tag includes; empty for others."""
    files: dict[str, str] = data("launch")["actions"]
    return files.get(name, "")


def is_forwarding(path: str) -> bool:
    """True for a launch file whose nodes `forwarded_nodes` knows."""
    return _entry(path) is not None


def forwarded_nodes(included: IncludedFile) -> Iterator[StartedProgram]:
    """The nodes to which a launch file passes its arguments."""
    arguments = included.arguments
    for key in (_entry(included.path) or "").split():
        package, _, executable = key.partition("/")
        node = StartedProgram(
            package, executable, (), included.span, included.frame, included.is_sure
        )
        if arguments is None:
            yield node._replace(parameters=GivenParameters({}, is_whole=False))
        elif key == _SPAWNER:
            yield node._replace(words=tuple(_command_line(arguments)))
        else:
            yield _bridge(node, arguments)


def _entry(path: str) -> str | None:
    files: dict[str, str] = data("launch")["forwarded"]
    return files.get("/".join(path.split("/")[-3:]))


def _command_line(arguments: Mapping[str, Word]) -> Iterator[Word]:
    for name, option in _OPTIONS.items():
        word = arguments.get(name)
        if word and word.text != "":
            yield Word(f"-{option}", word.span)
            yield word


def _bridge(node: StartedProgram, arguments: Mapping[str, Word]) -> StartedProgram:
    missing = Word("", node.span)
    name, space = (arguments.get(key, missing).text for key in ("bridge_name", "namespace"))
    given = {key: word for key, word in arguments.items() if key == _CONFIG_FILE}
    others = [arguments[key] for key in _OTHER_PARAMETERS if key in arguments]
    if word := next((word for word in others if _EXPANDED.search(word.span.text)), None):
        given[EXPANDS_NAMES] = Word("true", word.span)
    return node._replace(
        name=name or "",
        namespace=space and space.strip("/"),
        parameters=GivenParameters(
            {key: word.text for key, word in given.items()},
            is_whole=arguments.keys().isdisjoint(_OTHER_PARAMETERS),
            at={key: word.span for key, word in given.items()},
        ),
    )
