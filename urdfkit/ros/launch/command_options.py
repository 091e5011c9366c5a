"""Command lines of nodes with options that they do not have: ROS arguments, spawner, ros2 control.

Sources: ``node_main.cc`` of cartographer_ros, ``rcl/src/rcl/arguments.c`` of ros2/rcl,
``ArgumentParser.hpp`` of eProsima/Micro-XRCE-DDS-Agent, ``spawner.py`` of controller_manager and
the verbs of ros2controlcli of ros-controls/ros2_control, humble to rolling.
"""

import re
from collections.abc import Iterator

from urdfkit.core.suggest import TYPO, nearest
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.cartographer import CARTOGRAPHER, REQUIRED
from urdfkit.ros.launch.contents import StartedProgram, Word
from urdfkit.ros.launch.spawned_controllers import has_value, spawns_controllers
from urdfkit.text.diagnostic import Problem, Severity

_ROS_ARGUMENTS = "--ros-args"
#: The programs of Gazebo, which are no nodes, and the plugin by which Gazebo Classic is one.
_GAZEBO, _OF_GAZEBO = ("gazebo", "gzserver", "gzclient", "gz", "ign"), "libgazebo_ros_init.so"
_SPAWNER = "controller_manager/spawner"
#: Its options that name a controller, or its type, or print a help.
_NAMING = frozenset(("--controller", "-t", "--controller-type", "-h", "--help"))
_AGENT = "micro_ros_agent/micro_ros_agent"
#: A word of the launch file by which ROS is known to be newer than Galactic.
_RECENT = b"ros_gz"


def wrong_options(program: StartedProgram) -> Iterator[Problem]:
    """Options that stop a program, or that it ignores."""
    if program.frame is None and program.key == CARTOGRAPHER:
        yield from _cartographer(program)
    if not program.is_ros_2 or program.frame is not None:
        return
    yield from _ros_arguments(program)
    yield from _private_parameters(program)
    if program.key == _SPAWNER:
        yield from _spawner(program)
    if [word.text for word in program.words[:2]] == ["ros2", "control"]:
        yield from _ros2_control(program)
    if program.key == _AGENT:
        yield from _agent(program)


def _ros_arguments(program: StartedProgram) -> Iterator[Problem]:
    """ROS arguments that rcl rejects, such as ``-p name=value``."""
    known: dict[str, str] = data("launch")["ros_arguments"]
    texts = [word.text for word in program.words]
    if texts and texts[0] in _GAZEBO and _OF_GAZEBO not in texts:
        return  # nothing in this process reads them
    start = texts.index(_ROS_ARGUMENTS) if _ROS_ARGUMENTS in texts else len(texts)
    expected = ""
    for word in program.words[start + 1 :]:
        text = word.text
        if expected:
            is_assigned = expected != "assignment" or text is None or ":=" in text
            if not is_assigned and text is not None:
                message = f"'{text}' is not an assignment of ROS arguments"
                help = f"write {text.replace('=', ':=', 1)}" if "=" in text else "write NAME:=VALUE"
                yield _error(word, message, help)
            expected = ""
        elif text is None or text in ("--", _ROS_ARGUMENTS):
            return
        elif text in known:
            expected = known[text]
        elif text.startswith("-"):
            match = nearest(text, known, TYPO)
            help = f"did you mean {match}?" if match else "remove it, or write it before --ros-args"
            yield _error(word, f"unknown ROS argument '{text}'", help)


def _private_parameters(program: StartedProgram) -> Iterator[Problem]:
    """Parameters as on the command line of ROS 1, which ROS 2 ignores."""
    for word in program.words if program.package else ():
        if word.text == _ROS_ARGUMENTS:
            return
        if match := re.match(r"_([a-zA-Z]\w*):=(.*)", word.text or ""):
            message = f"ROS 2 ignores '{word.text}', a parameter of ROS 1"
            help = f"write parameters: {match[1]}: {match[2]}"
            yield Problem("LAU036", word.span, message, help, severity=Severity.WARNING)


def _spawner(program: StartedProgram) -> Iterator[Problem]:
    """Options that the spawner does not have: argparse stops at them."""
    texts = [word.text for word in program.words]
    if all(texts) and _NAMING.isdisjoint(texts) and not spawns_controllers(program):
        message = "the spawner stops: its arguments name no controller"
        help = "write the name of a controller as its first argument"
        yield Problem("LAU036", program.span, message, help, severity=Severity.ERROR)
    facts = data("launch")["spawner"]
    known = facts["options"].split()
    is_value = False
    for word in program.words:
        option = (word.text or "").partition("=")[0]
        if option == _ROS_ARGUMENTS:
            return
        was_value, is_value = is_value, has_value(option) and "=" not in (word.text or "")
        if was_value:
            continue
        is_known = option in known or (
            option.startswith("--") and any(name.startswith(option) for name in known)
        )
        if is_known or not re.match(r"-+[a-zA-Z]", option):
            continue
        successor = facts["former"].get(option)
        if successor:
            message = f"the spawner has no option {option} (supported up to Humble)"
            yield Problem(
                "LAU036", word.span, message, f"write {successor}", severity=Severity.INFO
            )
        else:
            match = nearest(option, known)
            help = f"did you mean {match}?" if match else f"it has {', '.join(known)}"
            yield _error(word, f"the spawner has no option {option}", help)


def _ros2_control(program: StartedProgram) -> Iterator[Problem]:
    """Verbs and states of ``ros2 control`` of Galactic and before."""
    facts = data("launch")["ros2_control"]
    is_recent = _RECENT in program.span.source.data
    severity = Severity.WARNING if is_recent else Severity.INFO
    for word in program.words[2:]:
        successor = facts["former"].get(word.text or "")
        if successor:
            message = f"ros2 control has no '{word.text}' (supported up to Galactic)"
            yield Problem("LAU036", word.span, message, f"write {successor}", severity=severity)


def _agent(program: StartedProgram) -> Iterator[Problem]:
    """Transports and options that the agent of micro-ROS does not have, or that are missing."""
    facts = data("launch")["agent"]
    transports, options = facts["transports"].split(), facts["options"].split()
    if not program.words:
        message = "micro_ros_agent stops: its arguments name no transport"
        help = 'write ["serial", "--dev", "/dev/ttyACM0"], or udp4, --port and a number'
        yield Problem("LAU036", program.span, message, help, severity=Severity.ERROR)
        return
    first = program.words[0].text
    if first and " " in first:
        help = f"write {first.split()}"
        yield _error(program.words[0], f"'{first}' is one word for micro_ros_agent", help)
    elif first and not first.startswith("-") and first not in transports:
        help = f"write one of {', '.join(transports)}, unless your agent has its own"
        message = f"micro_ros_agent has no transport '{first}'"
        # Teams extend the agent, for example with CAN.
        is_typo = nearest(first, transports, TYPO) is not None
        severity = Severity.ERROR if is_typo else Severity.WARNING
        yield Problem("LAU036", program.words[0].span, message, help, severity=severity)
    texts = [word.text for word in program.words]
    required = facts["required"].get(first, "").split()
    is_given = None in texts or any((text or "").split("=")[0] in required for text in texts)
    if required and not is_given:
        message = f"micro_ros_agent stops: {first} requires {required[0]}"
        yield _error(program.words[0], message, f"add {required[0]} and its value")
    for word in program.words[1:]:
        option = word.text or ""
        if option == _ROS_ARGUMENTS:
            return
        if re.match(r"--[a-zA-Z]", option) and option not in options:
            match = nearest(option, options, 0)
            yield _error(word, f"micro_ros_agent ignores '{option}'", f"did you mean {match}?")


def _cartographer(program: StartedProgram) -> Iterator[Problem]:
    """Options of Cartographer that are missing or misspelt: it stops without these two."""
    options = [(word.text or "").partition("=")[0].lstrip("-") for word in program.words]
    if "flagfile" in options or not all(word.text for word in program.words):
        return
    for required in (REQUIRED - set(options)) if program.words else ():
        message = f"cartographer_node stops: -{required} is missing"
        match = nearest(required, options, TYPO)
        word = program.words[options.index(match) if match else 0]
        help = f"write -{required} for {word.text}" if match else f"add -{required} and its value"
        yield _error(word, message, help)


def _error(word: Word, message: str, help: str) -> Problem:
    return Problem("LAU036", word.span, message, help, severity=Severity.ERROR)
