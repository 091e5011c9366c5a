"""Tags and attributes of launch files in XML, of ROS 1 and of ROS 2.

Sources: ``xmlloader.py`` of ros/ros_comm (noetic); the actions of ros2/launch and ros2/launch_ros
that are exposed to XML (humble to rolling).
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfkit.core.suggest import TYPO, is_typo, nearest
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.document import CallFrame, Element

_CONDITIONS = frozenset(("if", "unless"))

#: Attributes of namespaces, of rosmon, and those that part the items of a list in ROS 2.
_OF_OTHERS = re.compile(r":|^rosmon-|-sep$")
#: Of each tag the attributes, ! those that it must have.
_ROS_1 = {
    "launch": "deprecated",
    "arg": "name! value default doc",
    "env": "name! value!",
    "group": "ns clear_params",
    "include": "file! ns clear_params pass_all_args",
    "machine": "name! address! env-loader ssh-port user password default timeout ros-root "
    "ros-package-path",
    "master": "type uri auto",
    "node": "pkg! type! name! machine args output respawn respawn_delay cwd ns clear_params "
    "launch-prefix required",
    "param": "name! value type textfile binfile command",
    "remap": "from! to!",
    "rosparam": "command ns file param subst_value",
    "test": "pkg! type! test-name! name machine args output respawn respawn_delay cwd ns "
    "clear_params launch-prefix required time-limit retry",
}
_PROCESS = (
    "name cwd launch-prefix output respawn respawn_delay respawn_max_retries sigkill_timeout "
    "sigterm_timeout shell emulate_tty on_exit"
)
_ROS_2 = {
    "launch": "deprecated version",
    "append_env": "name! value! prepend separator",
    "arg": "name! value default description",
    "choice": "value!",
    "composable_node": "pkg! plugin! name namespace",
    "env": "name! value!",
    "executable": f"cmd! {_PROCESS}",
    "extra_arg": "name! value!",
    "group": "scoped forwarding",
    "include": "file!",
    "keep": "name! value!",
    "let": "name! value!",
    "load_composable_node": "target!",
    "log": "message! level",
    "node": f"pkg exec! node-name exec_name namespace args ros_args {_PROCESS}",
    "node_container": f"pkg exec! node-name exec_name namespace args ros_args {_PROCESS}",
    "param": "name from value type allow_substs",
    "push-ros-namespace": "namespace!",
    "push_ros_namespace": "namespace!",
    "remap": "from! to!",
    "reset": "",
    "reset_env": "",
    "ros_timer": "period!",
    "set_env": "name! value!",
    "set_parameter": "name! value! type",
    "set_parameters_from_file": "filename!",
    "set_remap": "from! to!",
    "set_ros_log_dir": "new_log_dir!",
    "set_use_sim_time": "value!",
    "shutdown": "reason",
    "timer": "period! cancel_on_shutdown",
    "unset_env": "name!",
    "unset": "name!",
}
_TABLES = {1: _ROS_1, 2: _ROS_2}

#: The words that an attribute may be, by ROS, tag and name.
_WORDS = {
    (1, "rosparam", "command"): ("load", "dump", "delete"),
    (1, "node", "output"): ("screen", "log"),
    (1, "param", "type"): ("str", "string", "int", "double", "bool", "boolean", "yaml", "auto"),
    (2, "node", "output"): ("screen", "log", "both", "own_log", "full"),
}

#: What an attribute of the other ROS is called in this one, by tag.
_TRANSLATED = {
    1: {("node", "exec"): "type", ("node", "namespace"): "ns", ("arg", "description"): "doc"},
    2: {("node", "type"): "exec", ("node", "ns"): "namespace", ("arg", "doc"): "description"},
}
#: Texts by which people know the one or the other.
_MARKS = {
    1: ("$(find ", "$(arg ", "$(anon ", "$(optenv "),
    2: ("$(var ", "$(find-pkg-share ", "$(find-pkg-prefix ", "$(exec-in-pkg "),
}


def dialect(root: Element) -> int | None:
    """1 or 2, as most of a launch file is written; None if it is undecided."""
    votes = {1: 0, 2: 0}
    for element in root.walk():
        for ros, other in ((1, 2), (2, 1)):
            names = _names(_TABLES[ros].get(element.tag, ""))
            others = _names(_TABLES[other].get(element.tag, ""))
            votes[ros] += element.tag in _TABLES[ros] and element.tag not in _TABLES[other]
            votes[ros] += len(names.difference(others).intersection(element.attributes))
            votes[ros] += sum(
                mark in attribute.value
                for attribute in element.attributes.values()
                for mark in _MARKS[ros]
            )
    return None if votes[1] == votes[2] else max(votes, key=lambda ros: votes[ros])


def _names(row: str) -> set[str]:
    return {word.rstrip("!") for word in row.split()}


def mistakes(element: Element, ros: int, frame: CallFrame | None) -> Iterator[Problem]:
    """Unknown, missing and invalid tags and attributes of an element, apart from the tags in it."""
    table = _TABLES[ros]
    row = table.get(element.tag)
    if row is None:
        if suggested := nearest(element.tag, table, TYPO):
            message = f"unknown tag <{element.tag}>"
            yield Problem("LAU010", element.span, message, f"did you mean <{suggested}>?", frame)
        return
    for word in row.split():
        name = word.rstrip("!")
        if word.endswith("!") and not _is_written(element, name, ros):
            message = f"<{element.tag}> has no {name}"
            help = f'write {name}="..."'
            yield Problem("LAU010", element.span, message, help, frame, severity=Severity.ERROR)
    if element.tag == "launch":
        return  # its attributes are not read
    known = _names(row)
    for attribute in element.attributes.values():
        name = attribute.name
        words = _WORDS.get((ros, element.tag, name))
        if words and attribute.value not in words and "$" not in attribute.value:
            message = f"<{element.tag}>: {name} is '{attribute.value}'"
            yield Problem("LAU010", attribute.span, message, f"write {' or '.join(words)}", frame)
        if name in known or name in _CONDITIONS or _OF_OTHERS.search(name):
            continue
        suggested = _TRANSLATED[ros].get((element.tag, name)) or nearest(name, known)
        help = f"did you mean {suggested}?" if suggested else "it has: " + ", ".join(sorted(known))
        message = f"unknown attribute '{name}' of <{element.tag}> in ROS {ros}"
        yield Problem("LAU010", attribute.span, message, help, frame)


def _is_written(element: Element, name: str, ros: int) -> bool:
    """True if an attribute is there, or a typo of it, which is reported instead."""
    translated = _TRANSLATED[ros]
    return any(
        other == name
        or translated.get((element.tag, other)) == name
        or is_typo(other, name)
        or nearest(other, [name], TYPO)
        for other in element.attributes
    )
