"""``$(find pkg)``, ``$(arg name)`` and the other commands in round brackets.

Their meaning is that of stock xacro, which requires a ROS installation; here the Resolver finds
packages, and environment variables are checked against an allow-list.
"""

from __future__ import annotations

import builtins
import os
from collections.abc import Callable, Mapping

from urdfkit.core.record import Record
from urdfkit.core.static_typing import Any
from urdfkit.core.suggest import did_you_mean
from urdfkit.xacro.bounds import UnsafeExpression
from urdfkit.xacro.errors import VARIABLE, MissingArgument
from urdfkit.xacro.expressions import evaluate
from urdfkit.xacro.sandbox import Sandbox

#: Variables that ``$(env)`` and ``$(optenv)`` may read without ``--trust``: names, not prefixes,
#: which would include a secret such as ROS_TOKEN.
ENVIRONMENT = frozenset(
    "AMENT_PREFIX_PATH GAZEBO_MODEL_PATH GAZEBO_PLUGIN_PATH GAZEBO_RESOURCE_PATH GAZEBO_VERSION "
    "GZ_SIM_RESOURCE_PATH GZ_VERSION IGN_GAZEBO_RESOURCE_PATH ROBOT_MODEL ROBOT_NAME "
    "ROBOT_NAMESPACE ROBOT_SIMULATION ROBOT_TYPE ROS_DISTRO ROS_DOMAIN_ID ROS_NAMESPACE "
    "ROS_PACKAGE_PATH ROS_PYTHON_VERSION ROS_VERSION".split()
)

COMMANDS = ("find", "env", "optenv", "dirname", "arg", "eval", "cwd")


class SubstitutionError(Exception):
    """The command failed; the text is for users."""


class UnsetVariable(SubstitutionError):
    """A variable that is not set."""

    def __init__(self, name: str) -> None:
        super().__init__(f"{VARIABLE} '{name}' is not set")
        self.name = name


class ForbiddenVariable(SubstitutionError):
    """A variable that is set, but not on the allow-list."""


class SubstitutionContext(Record):
    """The values that commands use."""

    find: Callable[[str], str]  # directory of a package by name
    argument: Callable[[str], str]  # value of a xacro argument; raises KeyError
    directory: str  # of the file that is processed
    working_directory: str  # for ``$(cwd)``
    environment: Mapping[str, str]
    sandbox: Sandbox | None  # for expressions; None if every variable and expression is allowed
    functions: Mapping[str, Any]  # available in expressions
    ros_version: Callable[[], str]  # default of ``ROS_VERSION`` without ROS
    warn: Callable[[str], None]  # warns the user


def substitute(content: str, context: SubstitutionContext) -> str:
    """The value of ``$(content)``.

    Raises:
        KeyError: an argument has no value.
        SubstitutionError: any other error of the command.
    """
    if content == "cwd":
        return os.path.abspath(context.working_directory)
    if content.startswith("eval "):
        return str(_evaluate(content[len("eval ") :], context))
    words = [word for word in content.split(" ") if word]
    if not words:
        return f"$({content})"
    command, arguments = words[0], words[1:]
    if command == "arg":
        return context.argument(_single(command, arguments))
    if command == "find":
        return context.find(_single(command, arguments))
    if command == "env":
        return _variable(_single(command, arguments), context)
    if command == "optenv" and arguments:
        return _optional_variable(arguments[0], " ".join(arguments[1:]), context)
    if command == "dirname":
        return os.path.abspath(context.directory)
    hint = did_you_mean(command, COMMANDS) or f"; the commands are {', '.join(COMMANDS)}"
    raise SubstitutionError(f"'$({content})' is not known{hint}")


def _single(command: str, arguments: list[str]) -> str:
    if len(arguments) != 1:
        raise SubstitutionError(f"$({command} ...) takes one name, not {len(arguments)}")
    return arguments[0]


def may_read(name: str, context: SubstitutionContext) -> bool:
    """True if the model may read an environment variable."""
    return context.sandbox is None or name in ENVIRONMENT


def _variable(name: str, context: SubstitutionContext) -> str:
    if name not in context.environment:
        if name == "ROS_VERSION":
            return context.ros_version()
        raise UnsetVariable(name)
    if not may_read(name, context):
        raise ForbiddenVariable(f"{VARIABLE} '{name}' is not on the allow-list")
    return context.environment[name]


def _optional_variable(name: str, default: str, context: SubstitutionContext) -> str:
    if may_read(name, context):
        return context.environment.get(name, default)
    if name in context.environment:
        context.warn(
            f"environment variable '{name}' is set, but not on the allow-list: $(optenv) takes its "
            "default; --trust reads the variable"
        )
    return default


def _evaluate(expression: str, context: SubstitutionContext) -> Any:
    if "__" in expression:
        raise UnsafeExpression("$(eval ...) may not contain double underscores")
    names = _EvalNames(context)
    if context.sandbox is None:
        return eval(expression, {}, names)
    return evaluate(expression.strip(), names, context.sandbox)


class _EvalNames(dict[str, Any]):
    """The names of a ``$(eval ...)``: functions, then arguments, as numbers if possible."""

    def __init__(self, context: SubstitutionContext) -> None:
        super().__init__(context.functions)
        self.context = context
        self.update(
            true=True,
            false=False,
            arg=lambda name: _convert(context.argument(name)),
            find=context.find,
            env=lambda name: _variable(name, context),
            optenv=lambda name, default="": _optional_variable(name, default, context),
            dirname=lambda: os.path.abspath(context.directory),
        )

    def __missing__(self, name: str) -> Any:
        try:
            return _convert(self.context.argument(name))
        except MissingArgument:
            if self.context.sandbox is not None and hasattr(builtins, name):
                raise UnsafeExpression(f"{name} is not allowed in expressions") from None
            raise KeyError(name) from None


def _convert(text: str) -> Any:
    try:
        return float(text) if "." in text else int(text)
    except ValueError:
        return {"true": True, "false": False}.get(text.lower(), text)
